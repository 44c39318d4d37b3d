"""Every optimizer with every seed on the visibility matrices of the rooms, and annealing with other schedules."""
from lab import jobs as lab

METHODS = ("local", "tabu", "sa", "greedy")


def runs(config):
    """{(scene, backend, regions): run}; the same jobs as of paper-tables."""
    return {(name, backend, regions): lab.solve(lab.room(name), backend=backend, regions=regions)
            for name in config["scenes"] for backend in config["backends"] for regions in config["regions"]}


def exact_covers(config):
    return {key: lab.cover(run, method="exact") for key, run in runs(config).items()}


def proofs(config):
    return {key: lab.proof(cover) for key, cover in exact_covers(config).items()}


def covers(config):
    """{(scene, backend, regions, method, seed): cover}"""
    made = {}
    for key, run in runs(config).items():
        for method in METHODS:
            limit = {"time_limit": config["local_seconds"]} if method == "local" else {}
            for seed in config["seeds"][:1] if method == "greedy" else config["seeds"]:
                made[(*key, method, seed)] = lab.cover(run, method=method, seed=seed, **limit)
    return made


def schedules(config):
    """The default, then each number of the schedule changed alone."""
    return [None, *(f"{name}={value:g}" for name, values in config["annealing"].items() for value in values)]


def sweep(config):
    """{(scene, schedule, seed): cover} of the matrices by random rays."""
    regions = config.get("sweep_regions", config["regions"][-1])
    return {(name, schedule, seed): lab.cover(runs(config)[name, "rays", regions], method="sa", seed=seed, annealing=schedule)
            for name in config["scenes"] for schedule in schedules(config) for seed in config.get("sweep_seeds", config["seeds"])}


def jobs(config, notes):
    found = covers(config)
    return [*runs(config).values(), *exact_covers(config).values(), *proofs(config).values(), *found.values(), *sweep(config).values(),
            next(job for key, job in found.items() if key[3] == "tabu").again()]  # no time limit


def outputs(config):
    return {"tables": ["optimizers", "annealing"], "figures": ["success"], "pictures": []}
