"""One line a scene."""
from lab import planning, tables

plan = planning.load("real-scenes", "plan")


def draw(rows, config, folder, work):
    runs, lines = plan.runs(config, []), []
    for name in dict.fromkeys(key[0] for key in runs):
        parts, full = (rows[runs[name, coverage].key] for coverage in ("elements", "full"))
        if parts["failure"] or full["failure"]:
            lines.append([name, parts["failure"] or full["failure"], *[""] * 9])
            continue
        a, b = parts["result"], full["result"]
        lines.append([name, a["polygons"], a["elements"], a["links"], a["optimal_regions"], f"{a['viewpoints']}, {a['lower_bound']}",
                      tables.number(a["seconds"]["total"]), b["viewpoints"], b["lower_bound"], f"{b['imaged_percent']:.2f}",
                      tables.number(b["seconds"]["total"])])
    tables.write(folder / "real_scenes", f"{config['regions']} regions a part, exact; full coverage with --close-gap {config['full_seconds']}. One thread.",
                 ["scene", "polygons", "elements", "links", "optimal regions", "viewpoints, bound", "all, s", "full coverage: viewpoints", "bound",
                  "imaged, %", "all, s "], lines)
