"""Random rays against exact visibility: what they miss, what their optimum covers in truth, what they cost."""
from lab import jobs as lab


def rays_of(name, config):
    most = config["most_rays_complex"] if name == "complex" else max(config["rays"])
    return [rays for rays in config["rays"] if rays <= most]


def exact_runs(config):
    return {name: lab.solve(lab.room(name), regions=config["regions"], viewpoints="none") for name in config["scenes"]}


def ray_runs(config):
    """{(scene, rays, seed): run}"""
    return {(name, rays, seed): lab.solve(lab.room(name), backend="rays", rays=rays, regions=config["regions"], seed=seed, viewpoints="none")
            for name in config["scenes"] for rays in rays_of(name, config) for seed in config["seeds"]}


def comparisons(config):
    exact = exact_runs(config)
    return {key: lab.compare(run, exact[key[0]]) for key, run in ray_runs(config).items()}


def soups(config):
    """{occluders: job}: queries between two squares through so many random triangles."""
    return {n: lab.Job(lab.key_of("first-free-ray", n, queries=config["soup_queries"], most=config["soup_most_rays"], width=config["soup_width"]), "soup",
                       ("first_free_ray.py", "{folder}", str(n), str(config["soup_queries"]), str(config["soup_most_rays"]), lab.text(config["soup_width"]), "1"),
                       labels=(("occluders", n), ("queries", config["soup_queries"]), ("most_rays", config["soup_most_rays"])), script=True)
            for n in config["soup_occluders"]}


def jobs(config, notes):
    runs = ray_runs(config)
    return [*exact_runs(config).values(), *runs.values(), *comparisons(config).values(), *soups(config).values(),
            next(iter(runs.values())).again()]


def outputs(config):
    return {"tables": ["rays", "first_free_ray"], "figures": ["missed", "time", "first_free_ray"], "pictures": []}
