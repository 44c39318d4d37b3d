"""What complete sets of viewpoints leave unimaged, by element size."""
from lab import figures, planning, tables

plan = planning.load("element-criterion", "plan")


def draw(rows, config, folder, work):
    runs, lines = plan.runs(config), []
    figure, ax = figures.axes("element area, m²", "coverable area that no viewpoint images, %", log="x")
    curves = {}
    for key, job in plan.audits(config).items():
        if rows[job.key]["failure"]:
            continue
        name, backend, area = key
        audit, run = rows[job.key]["result"], rows[runs[key].key]["result"]
        coverable = audit["coverable_area"]
        lines.append([name, backend, area, run["visible_elements"], f"{coverable:.1f}", audit["viewpoints"], run["lower_bound"] or "none",
                      f"{coverable - audit['missed_area']:.1f}", f"{audit['missed_area']:.2f}", f"{100 - audit['imaged_percent']:.2f}", audit["seen_in_part"],
                      f"{100 * audit['area_seen_in_part'] / coverable:.1f}"])
        curves.setdefault((name, backend), []).append((area, 100 - audit["imaged_percent"]))
    for i, ((name, backend), points) in enumerate(curves.items()):
        ax.plot(*zip(*points), label=f"{name} room, {backend}", **figures.style(i))
    ax.set_ylim(bottom=0)
    ax.legend()
    figures.save(figure, folder / "missed")
    tables.write(folder / "element_criterion", "Viewpoints that see a part of each coverable element, and what they image of it, measured exactly; one thread.",
                 ["scene", "backend", "element area, m²", "coverable elements", "coverable, m²", "viewpoints", "lower bound", "imaged, m²", "missed, m²",
                  "missed, %", "seen in part", "their area, %"], lines)
