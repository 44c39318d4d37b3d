"""Plain Embree rays over the whole scene, and the test for one occluder alone, pair by pair."""
from lab import jobs as lab


def exact_runs(config):
    return {name: lab.solve(lab.room(name), regions=config["regions"], viewpoints="none") for name in config["scenes"]}


def ray_runs(config):
    """The same numbers of rays in viewcover's own backend."""
    return {(name, rays): lab.solve(lab.room(name), backend="rays", rays=rays, regions=config["regions"], viewpoints="none")
            for name in config["scenes"] for rays in config["rays"]}


def comparisons(config):
    exact = exact_runs(config)
    return {key: lab.compare(run, exact[key[0]]) for key, run in ray_runs(config).items()}


def peer(name, run, rays=0, seed=1):
    return lab.Job(lab.key_of("peer", name, rays=rays or None, seed=seed) + "@" + run.key, "peer", (name, lab.bundle(run), str(rays), str(seed)),
                   (run,), seed, (*run.labels, ("peer", name), ("peer_rays", rays)), program="peers")


def peers(config):
    """{(scene, peer, rays, seed): job}"""
    made = {}
    for name, run in exact_runs(config).items():
        made[name, "one-occluder", 0, 1] = peer("one-occluder", run)
        for rays in config["rays"]:
            for seed in config["seeds"]:
                made[name, "embree", rays, seed] = peer("embree", run, rays, seed)
    return made


def jobs(config, notes):
    return [*exact_runs(config).values(), *ray_runs(config).values(), *comparisons(config).values(), *peers(config).values(),
            next(iter(peers(config).values())).again()]


def outputs(config):
    return {"tables": ["peers"], "figures": ["peers"], "pictures": []}
