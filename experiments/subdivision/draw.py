"""The grid as a table, the optimum against the number of regions, and what each answer costs."""
from lab import figures, planning, tables

plan = planning.load("subdivision", "plan")


def draw(rows, config, folder, work):
    grid = {key: rows[run.key] for key, run in plan.runs(config).items()}
    lines = []
    for (name, backend, area, regions), row in grid.items():
        if row["failure"]:
            lines.append([name, backend, area, regions, row["failure"], *[""] * 9])
            continue
        result = row["result"]
        lines.append([name, backend, area, regions, result["optimal_regions"], "yes" if result["proved"] else "no", result["lower_bound"] or "none", result["viewpoints"],
                      result["elements"], result["links"], tables.number(result["seconds"]["visibility"]), tables.number(result["seconds"]["cover"]), tables.number(result["seconds"]["viewpoints"]),
                      tables.number(result["peak_memory_kb"] / 1000)])
    tables.write(folder / "subdivision", "Optimal regions over region and element size (m²), one thread.",
                 ["scene", "backend", "element area", "regions", "optimum", "proved", "bound on viewpoints", "viewpoints", "elements", "links", "visibility, s",
                  "cover, s", "viewpoints, s", "memory, MB"], lines)
    regions_figure(grid, config, folder)
    cost_figure(grid, config, folder)


def curve(grid, name, backend, area, config, value):
    return [(regions, value(grid[name, backend, area, regions]["result"])) for regions in config["regions"]
            if not grid[name, backend, area, regions]["failure"]]


def regions_figure(grid, config, folder):
    figure, every = figures.pyplot.subplots(1, len(config["scenes"]), figsize=(5 * len(config["scenes"]), 4), squeeze=False, sharey=True)
    for ax, name in zip(every[0], config["scenes"]):
        ax.set(xlabel="viewing regions", ylabel="optimal regions", title=f"{name} room", xscale="log")
        for i, area in enumerate(config["element_areas"]):
            for backend, line in (("exact", "-"), ("rays", ":")):
                ax.plot(*zip(*curve(grid, name, backend, area, config, lambda r: r["optimal_regions"])), linestyle=line,
                        label=f"{backend}, {area:g} m²", **figures.style(i))
        ax.legend(fontsize=7, ncol=2)
    figures.save(figure, folder / "regions")


def cost_figure(grid, config, folder):
    figure, ax = figures.axes("visibility and cover, s", "optimal regions, exact", log="x")
    for i, name in enumerate(config["scenes"]):
        for j, area in enumerate(config["element_areas"]):
            points = curve(grid, name, "exact", area, config, lambda r: (r["seconds"]["visibility"] + r["seconds"]["cover"], r["optimal_regions"]))
            ax.plot([p[1][0] for p in points], [p[1][1] for p in points], color=figures.COLOURS[j], marker=figures.MARKS[j],
                    linestyle="-" if i == 0 else "--", label=f"{name}, {area:g} m²")
    ax.legend(fontsize=7, ncol=2)
    figures.save(figure, folder / "cost")
