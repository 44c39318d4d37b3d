"""What rays miss and cost, and the first free ray through a soup."""
from lab import figures, planning, tables

plan = planning.load("rays-vs-exact", "plan")
# Haumont, Makinen and Nirenstein (2005), figure 17, read off: rays to the first free one by number of occluders.
HAUMONT = {40: 10, 100: 1_000, 300: 35_000}


def of(rows, jobs, name, rays, value):
    """A value of all seeds."""
    found = [rows[job.key] for key, job in jobs.items() if key[:2] == (name, rays)]
    return [value(row["result"]) for row in found if not row["failure"]]


def shown(values, scale=1, digits=3):
    if not values:
        return "no result"
    mean, half = figures.mean_and_interval([scale * value for value in values])
    return f"{mean:.{digits}g} ± {half:.2g}" if half else f"{mean:.{digits}g}"


def draw(rows, config, folder, work):
    exact = {name: rows[run.key]["result"] for name, run in plan.exact_runs(config).items()}
    runs, comparisons = plan.ray_runs(config), plan.comparisons(config)
    lines = []
    for name in config["scenes"]:
        for rays in plan.rays_of(name, config):
            asked = (rows, comparisons, name, rays)
            lines.append([name, str(rays), shown(of(*asked, lambda r: r["Q_u"]["count"]), 100), shown(of(*asked, lambda r: r["Q_u"]["area"]), 100),
                          shown(of(rows, runs, name, rays, lambda r: r["optimal_regions"])),
                          shown(of(*asked, lambda r: r["optimum"]["covered_percent_by_b"]), digits=6),
                          shown(of(*asked, lambda r: r["optimum"]["elements_left_out_by_b"])),
                          shown(of(rows, runs, name, rays, lambda r: r["seconds"]["visibility"]))])
        truth = exact[name]
        lines.append([name, "exact", "0", "0", truth["optimal_regions"], "100", "0", tables.number(truth["seconds"]["visibility"])])
    tables.write(folder / "rays", f"Random rays a shaft against exact visibility, {config['regions']} regions, one thread; mean of {len(config['seeds'])} seeds and "
                 "its 95 % confidence interval. Rays see nothing that is hidden (Q_o = 0).",
                 ["scene", "rays", "Q_u by count, %", "by area, %", "optimal regions", "they cover in truth, %", "elements left out", "visibility, s"], lines)
    missed(rows, config, comparisons, folder)
    time(rows, config, exact, folder)
    soups(rows, config, folder)


def missed(rows, config, comparisons, folder):
    figure, ax = figures.axes("random rays a shaft", "visible pairs missed, %", log="xy")
    for i, name in enumerate(config["scenes"]):
        for by, line in (("count", "-"), ("area", "--")):
            points = [(rays, *figures.mean_and_interval([100 * q for q in of(rows, comparisons, name, rays, lambda r: r["Q_u"][by])]))
                      for rays in plan.rays_of(name, config)]
            points = [point for point in points if point[1] > 0]
            ax.errorbar([p[0] for p in points], [p[1] for p in points], yerr=[min(p[2], 0.99 * p[1]) for p in points], linestyle=line, capsize=2,
                        label=f"{name} room, by {by}", **figures.style(i))
    ax.legend()
    figures.save(figure, folder / "missed")


def time(rows, config, exact, folder):
    figure, ax = figures.axes("visibility, s", "visible pairs missed, %", log="xy")
    for i, name in enumerate(config["scenes"]):
        points = []
        for rays in plan.rays_of(name, config):
            seconds = of(rows, plan.ray_runs(config), name, rays, lambda r: r["seconds"]["visibility"])
            share = of(rows, plan.comparisons(config), name, rays, lambda r: r["Q_u"]["count"])
            if share and sum(share) > 0:
                points.append((sum(seconds) / len(seconds), 100 * sum(share) / len(share), rays))
        ax.plot([p[0] for p in points], [p[1] for p in points], label=f"{name} room, random rays", **figures.style(i))
        for x, y, rays in points:
            ax.annotate(f"{rays:,}", (x, y), textcoords="offset points", xytext=(4, 3), fontsize=7)
        ax.axvline(exact[name]["seconds"]["visibility"], color=figures.COLOURS[i], linestyle=":", label=f"{name} room, exact: none missed")
    ax.legend(fontsize=8)
    figures.save(figure, folder / "time")


def soups(rows, config, folder):
    lines, points = [], []
    for n, job in plan.soups(config).items():
        result = rows[job.key]["result"]
        if result is None:
            continue
        lines.append([n, result["visible"], result["hidden"], result["median_rays"] if result["median_rays"] else "-",
                      result["quartile_rays"] if result["quartile_rays"] else "more" if result["visible"] else "-", result["never_found"],
                      HAUMONT.get(n, "")])
        if result["median_rays"]:
            points.append((n, result["median_rays"], result["quartile_rays"]))
    tables.write(folder / "first_free_ray", f"Rays (powers of two) until the first free one, for visible pairs of unit squares through random triangles {config['soup_width']:g} wide; "
                 f"{config['soup_queries']} queries a line, no more than {config['soup_most_rays']:,} rays.",
                 ["occluders", "visible", "hidden", "median rays", "third quartile", "never found", "Haumont et al. 2005, figure 17"], lines)
    figure, ax = figures.axes("occluders", "rays until the first free one", log="y")
    ax.plot([p[0] for p in points], [p[1] for p in points], label="median", **figures.style(0))
    quartiles = [p for p in points if p[2]]
    ax.plot([p[0] for p in quartiles], [p[2] for p in quartiles], label="third quartile", linestyle="--", **figures.style(1))
    ax.plot(*zip(*HAUMONT.items()), label="Haumont et al. 2005, figure 17 (their scenes)", linestyle=":", **figures.style(2))
    ax.legend()
    figures.save(figure, folder / "first_free_ray")
