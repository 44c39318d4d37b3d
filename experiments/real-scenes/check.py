"""Brackets are brackets, and every bundle withstands `verify`."""
from lab import planning

plan = planning.load("real-scenes", "plan")


def check(rows, config, require):
    for key, job in plan.verdicts(config, []).items():
        run = rows[plan.runs(config, [])[key].key]
        if run["failure"]:
            continue
        require(run["result"]["lower_bound"] is not None, f"{run['job']}: no lower bound")
        require(rows[job.key]["failure"] is None, f"{job.key}: {rows[job.key]['failure']}")
