"""A line a size, and time and memory against polygons."""
from lab import figures, planning, tables

plan = planning.load("scaling", "plan")


def draw(rows, config, folder, work):
    lines, points = [], []
    for count, run in plan.runs(config).items():
        row = rows[run.key]
        if row["failure"]:
            lines.append([count, row["failure"], *[""] * 10])
            continue
        result, seconds = row["result"], row["result"]["seconds"]
        lines.append([count, result["polygons"], result["regions"], result["visible_elements"], result["links"], result["optimal_regions"],
                      result["viewpoints"] or "", tables.number(seconds["visibility"]), tables.number(seconds["cover"]), tables.number(seconds["viewpoints"]),
                      tables.number(seconds["total"]), round(result["peak_memory_kb"] / 1024)])
        points.append((result["polygons"], seconds["visibility"], seconds["total"]))
    tables.write(folder / "scaling", f"{config['detail']} living rooms in a row, {config['regions']} regions a room, exact, all cores.",
                 ["rooms", "polygons", "regions", "elements seen", "links", "optimal regions", "viewpoints", "visibility, s", "cover, s", "viewpoints, s",
                  "all, s", "memory, MB"], lines)
    figure, ax = figures.axes("polygons", "seconds", log="xy")
    for index, name in enumerate(["visibility", "all"]):
        ax.plot([point[0] for point in points], [point[1 + index] for point in points], label=name, **figures.style(index))
    ax.legend()
    figures.save(figure, folder / "scaling")
