"""More rooms have more of everything."""
from lab import planning

plan = planning.load("scaling", "plan")


def check(rows, config, require):
    before = None
    for count, run in plan.runs(config).items():
        row = rows[run.key]
        if row["failure"]:
            continue
        result = row["result"]
        require(result["proved"], f"{run.key}: the optimum is not proved")
        require(result["regions"] == count * config["regions"], f"{run.key}: {result['regions']} regions")
        if before:
            for what in ("polygons", "visible_elements", "links", "optimal_regions"):
                require(result[what] > before[what], f"{run.key}: no more {what} than fewer rooms have")
        before = result
