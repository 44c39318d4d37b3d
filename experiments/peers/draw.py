"""Time and error of each."""
from lab import figures, planning, tables

plan = planning.load("peers", "plan")


def draw(rows, config, folder, work):
    lines, curves = [], {}
    for name in config["scenes"]:
        exact = rows[plan.exact_runs(config)[name].key]["result"]
        lines.append([name, "exact backend", "", "0", "0", "0", "0", tables.number(exact["seconds"]["visibility"])])
        for rays in config["rays"]:
            row, run = rows[plan.comparisons(config)[name, rays].key]["result"], rows[plan.ray_runs(config)[name, rays].key]["result"]
            lines.append([name, "rays backend", rays, *(tables.percent(row[measure][by]) for measure in ("Q_u", "Q_o") for by in ("count", "area")),
                          tables.number(run["seconds"]["visibility"])])
            curves.setdefault((name, "rays backend"), []).append((run["seconds"]["visibility"], 100 * row["Q_u"]["count"]))
        for peer in ("embree", "one-occluder"):
            for rays in config["rays"] if peer == "embree" else [0]:
                found = [rows[job.key]["result"] for key, job in plan.peers(config).items() if key[:3] == (name, peer, rays)]
                mean = [sum(result[measure][by] for result in found) / len(found) for measure in ("Q_u", "Q_o") for by in ("count", "area")]
                seconds = sum(result["seconds"] for result in found) / len(found)
                lines.append([name, peer, rays or "", *map(tables.percent, mean), tables.number(seconds)])
                curves.setdefault((name, peer), []).append((seconds, 100 * (mean[0] + mean[2])))
    tables.write(folder / "peers", f"Visible pairs missed (Q_u) and added (Q_o) in percent of the exact ones, {config['regions']} regions, one thread; the peers go through all "
                 "pairs of the exact run's elements, flat.",
                 ["scene", "method", "rays", "Q_u by count", "by area", "Q_o by count", "by area ", "visibility, s"], lines)
    figure, ax = figures.axes("visibility, s", "pairs missed and added, %", log="xy")
    for i, ((name, method), points) in enumerate(curves.items()):
        points = [point for point in points if point[1] > 0]
        if points:
            ax.plot(*zip(*points), label=f"{name} room, {method}", **figures.style(i))
    for i, name in enumerate(config["scenes"]):
        ax.axvline(rows[plan.exact_runs(config)[name].key]["result"]["seconds"]["visibility"], color=figures.COLOURS[i], linestyle=":",
                   label=f"{name} room, exact: none")
    ax.legend(fontsize=7)
    figures.save(figure, folder / "peers")
