"""The bracket against the seconds allowed."""
from lab import figures, planning, tables

plan = planning.load("bracket", "plan")


def draw(rows, config, folder, work):
    made = {key: rows[run.key] for key, run in plan.runs(config).items() if not rows[run.key]["failure"]}
    lines = []
    for (name, coverage, regions, seconds), row in made.items():
        result = row["result"]
        lines.append([name, coverage, regions, seconds, result["viewpoints"], result["lower_bound"], result["viewpoints"] - result["lower_bound"],
                      tables.number(result["imaged_percent"], 5) if "imaged_percent" in result else "", tables.number(result["seconds"]["viewpoints"])])
    tables.write(folder / "bracket", "Viewpoints and their proven lower bound by the seconds allowed for closing the gap (--close-gap), one thread.",
                 ["scene", "coverage", "regions", "seconds allowed", "viewpoints", "lower bound", "gap", "imaged, %", "search, s"], lines)
    figure, ax = figures.axes("viewpoint search, s", "viewpoints (filled) and lower bound (open)", log="x")
    for i, (name, coverage) in enumerate(dict.fromkeys(key[:2] for key in made if key[0] in config["scenes"])):
        runs = sorted((row["result"]["seconds"]["viewpoints"], row["result"]) for key, row in made.items()
                      if key[:2] == (name, coverage) and key[2] == config["regions"][0])
        style = figures.style(i)
        ax.plot([x for x, _ in runs], [r["viewpoints"] for _, r in runs], label=f"{name} room, {coverage}", **style)
        ax.plot([x for x, _ in runs], [r["lower_bound"] for _, r in runs], linestyle="--", markerfacecolor="none", **style)
    ax.legend(fontsize=8)
    figures.save(figure, folder / "bracket")
