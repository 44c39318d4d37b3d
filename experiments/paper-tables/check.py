"""What the paper's tables must not say."""
from lab import planning

plan = planning.load("paper-tables", "plan")


def check(rows, config, require):
    made, covers = plan.runs(config), plan.covers(config)
    for key, run in made.items():
        row = rows[run.key]
        if row["failure"]:
            continue
        optimum = row["result"]["optimal_regions"]
        require(row["result"]["proved"], f"{run.key}: the optimum of {optimum} regions is not proved")
        best = row["bundle"]["covers"]
        for k, cover in enumerate(rows[plan.annealed(config)[key].key]["bundle"]["covers"][:len(best)]):
            require(float(cover["covered_area_percent"]) <= float(best[k]["upper_bound_percent"]) + 1e-9,
                    f"{run.key}: annealing covers more with {k + 1} regions than is proved possible")
        for method in config["methods"]:
            cover = rows[covers[(*key, method)].key]
            if cover["failure"]:
                continue
            size = cover["result"]["size"]
            require(size >= optimum, f"{cover['job']}: {size} regions, fewer than the proved optimum of {optimum}")
            require(method != "exact" or size == optimum, f"{cover['job']}: {size} regions, the run says {optimum}")
    for (name, backend, regions), run in made.items():
        finer = made.get((name, backend, 4 * regions))
        if backend == "exact" and finer and not rows[run.key]["failure"] and not rows[finer.key]["failure"]:
            coarse, fine = (rows[one.key]["result"]["optimal_regions"] for one in (run, finer))
            require(coarse <= fine, f"{finer.key}: {fine} regions see all, {coarse} regions four times as large are needed")
