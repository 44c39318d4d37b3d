"""Every bound is below every number of viewpoints for the same task, whatever the time, and around the known number of guards."""
from lab import planning

plan = planning.load("bracket", "plan")


def check(rows, config, require):
    best = {}
    for (name, coverage, regions, seconds), run in plan.runs(config).items():
        row = rows[run.key]
        if row["failure"]:
            continue
        low, high = row["result"]["lower_bound"], row["result"]["viewpoints"]
        guards = plan.GALLERIES.get(name, ("", None))[1]
        if guards is not None:
            require(low <= guards <= high, f"{run.key}: {low} to {high}, but {guards} guards are known to be the fewest")
        # Elements are the same for all times only: of full coverage, witnesses differ from run to run.
        if coverage == "elements":
            lowest, highest, other = best.get((name, regions), (0, 10**9, ""))
            require(low <= highest, f"{run.key}: bound {low}, but {other} sees all with {highest}")
            require(lowest <= high, f"{run.key}: {high} viewpoints, fewer than the bound {lowest} of {other}")
            best[name, regions] = (max(low, lowest), min(high, highest), run.key)
