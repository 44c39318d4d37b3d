"""Tables 1, 2 and 3, the optimizers side by side, and coverage against k, each beside the paper's numbers."""
import csv
import math
import shutil

from lab import figures, planning, tables

plan = planning.load("paper-tables", "plan")
PAPER = planning.ROOT / "papers/tables"
# The paper's names of the runs of its table 1.
PAPER_RUNS = {"6": ("simple", 64), "7": ("simple", 256), "7a": ("simple", 1024), "8": ("complex", 64), "9": ("complex", 256)}


def paper_table(number):
    with open(PAPER / f"table{number}.csv", newline="") as file:
        return list(csv.DictReader(file))


def whole(percent):
    """Two digits, rounded down: 100 is all."""
    return f"{math.floor(100 * float(percent)) / 100:.2f}"


def draw(rows, config, folder, work):
    made = {key: rows[run.key] for key, run in plan.runs(config).items() if not rows[run.key]["failure"]}
    annealed = {key: rows[run.key] for key, run in plan.annealed(config).items() if not rows[run.key]["failure"]}
    table1(made, folder)
    table2(annealed, made, folder)
    table3(made, folder)
    methods(rows, made, config, folder)
    coverage(made, annealed, folder)
    for number, picture in plan.pictures(config).items():
        if not rows[picture.key]["failure"]:
            shutil.copy(work / picture.key / "figure.png", folder / f"figure{number}.png")


def table1(made, folder):
    paper = {PAPER_RUNS[row["figure"]]: row for row in paper_table(1)}
    lines = []
    for (name, backend, regions), row in made.items():
        result, printed = row["result"], paper.get((name, regions), {})
        lines.append([name, backend, regions, result["elements"], printed.get("elements", ""), result["links"], printed.get("links", ""),
                      result["optimal_regions"], printed.get("optimal_regions", ""), tables.number(result["seconds"]["visibility"]),
                      printed.get("visibility_seconds", ""), tables.number(result["seconds"]["cover"]), printed.get("optimization_seconds", ""),
                      tables.number(result["peak_memory_kb"] / 1000), tables.number(float(printed["memory_kb"]) / 1000) if printed else ""])
    pairs = ("elements", "links", "optimal regions", "visibility, s", "optimization, s", "memory, MB")
    tables.write(folder / "table1", "Table 1: statistics of the region optimum. \"Paper\": its own rooms of as many polygons, its own machine.",
                 ["scene", "backend", "regions", *(title for pair in pairs for title in (pair, "paper"))], lines)


def table2(annealed, made, folder):
    """Annealing for each k, as in the paper, and what is proved possible."""
    paper = {int(row["regions"]): row for row in paper_table(2)}
    name, backend, regions = max((key for key in annealed if key[1] == "rays"), key=lambda key: (key[0] == "complex", key[2] == 256, key[2]))
    covers, best = annealed[name, backend, regions]["bundle"]["covers"], made[name, backend, regions]["bundle"]["covers"]
    lines = []
    for k in range(1, max(len(covers), len(paper)) + 1):
        ours = covers[k - 1] if k <= len(covers) else None
        bound = best[k - 1] if k <= len(best) else None
        printed = paper.get(k, {})
        lines.append([k, whole(ours["covered_area_percent"]) if ours else "", whole(bound["covered_area_percent"]) if bound else "",
                      printed.get("percent_of_optimum", ""), int(ours["evaluations"]) if ours else "", printed.get("visibility_evaluations", ""),
                      tables.number(ours["seconds"]) if ours else "", printed.get("seconds", "")])
    tables.write(folder / "table2", f"Table 2: percent of what all regions see for each number of regions; {name} room, {backend}, {regions} regions, by "
                 "annealing and at best.", ["regions", "annealing, %", "exact, %", "paper, %", "evaluations", "paper", "seconds", "paper"], lines)


def table3(made, folder):
    """After each viewpoint: percent of what is coverable."""
    paper = {int(row["viewpoint"]): row for row in paper_table(3)}
    runs = [key for key in made if made[key]["result"]["viewpoints"]]
    steps = {key: made[key]["bundle"]["viewpoints"] for key in runs}
    count = max([len(paper), *(len(rows) for rows in steps.values())])
    lines = []
    for k in range(1, count + 1):
        printed = paper.get(k, {})
        lines.append([k, *(f"{whole(steps[key][k - 1]['covered_area_percent'])}" if k <= len(steps[key]) else "" for key in runs),
                      printed.get("percent_of_optimum", "")])
    lines.append(["lower bound", *(made[key]["result"]["lower_bound"] or "none" for key in runs), ""])
    lines.append(["seconds", *(tables.number(made[key]["result"]["seconds"]["viewpoints"]) for key in runs),
                  sum(float(row["seconds"]) for row in paper.values())])
    tables.write(folder / "table3", "Table 3: percent of the coverable area after each viewpoint; the paper's complex room.",
                 ["viewpoints", *(f"{name} {backend} {regions}" for name, backend, regions in runs), "paper"], lines)


def methods(rows, made, config, folder):
    covers = plan.covers(config)
    lines = []
    for key, row in made.items():
        line = [*key, row["result"]["optimal_regions"]]
        for method in config["methods"]:
            cover = rows[covers[(*key, method)].key]
            line.append(cover["failure"] or f"{cover['result']['size']} ({tables.number(cover['result'].get('best_after_seconds', cover['result']['seconds']), 2)})")
        lines.append(line)
    tables.write(folder / "methods", "Regions by each optimizer (seconds until that set was there), one seed, one thread; the optimum is proved.",
                 ["scene", "backend", "regions", "optimum", *config["methods"]], lines)


def coverage(made, annealed, folder):
    figure, ax = figures.axes("regions", "not yet covered, % of the coverable area", log="y")
    name, backend, regions = max((key for key in made if key[1] == "rays"), key=lambda key: (key[0] == "complex", key[2] == 256, key[2]))
    curves = {"annealing, random rays": annealed[name, "rays", regions]["bundle"]["covers"], "exact cover, random rays": made[name, "rays", regions]["bundle"]["covers"],
              "exact cover, exact visibility": made[name, "exact", regions]["bundle"]["covers"]}
    for i, (label, covers) in enumerate(curves.items()):
        left = [100 - float(cover["covered_area_percent"]) for cover in covers]
        points = [(k, value) for k, value in enumerate(left, start=1) if value > 1e-6]
        ax.plot(*zip(*points), label=f"{label}: {len(covers)} regions", **figures.style(i))
    printed = [(int(row["regions"]), 100 - float(row["percent_of_optimum"])) for row in paper_table(2) if float(row["percent_of_optimum"]) < 100]
    ax.plot(*zip(*printed), label=f"paper, its own room: {len(paper_table(2))} regions", linestyle="--", **figures.style(3))
    ax.legend()
    ax.set_title(f"{name} room, {regions} regions", fontsize=10)
    figures.save(figure, folder / "coverage")
