"""The paper's tables and figures: both rooms, all numbers of regions, both backends, all optimizers."""
from lab import jobs as lab

# The paper's figures of chosen regions: room, regions.
REGION_FIGURES = {"6": ("simple", 64), "7": ("simple", 256), "8": ("complex", 64), "9": ("complex", 256)}
# And of viewpoints.
VIEWPOINT_FIGURES = {"10": ("simple", 64), "11": ("complex", 64)}


def runs(config):
    """{(scene, backend, regions): run}"""
    return {(name, backend, regions): lab.solve(lab.room(name), backend=backend, regions=regions)
            for name in config["scenes"] for backend in config["backends"] for regions in config["regions"]}


def annealed(config):
    """As the paper chose: by annealing. {(scene, backend, regions): run}"""
    return {(name, backend, regions): lab.solve(lab.room(name), backend=backend, regions=regions, optimizer="sa", viewpoints="none")
            for name in config["scenes"] for backend in config["backends"] for regions in config["regions"]}


def covers(config):
    """{(scene, backend, regions, method): cover}"""
    return {(*key, method): lab.cover(run, method=method, **({"time_limit": config["local_seconds"]} if method == "local" else {}))
            for key, run in runs(config).items() for method in config["methods"]}


def pictures(config):
    """{figure: picture} where the run is there."""
    made = runs(config)
    found = {}
    for figures, colour_by in ((REGION_FIGURES, "covered_by"), (VIEWPOINT_FIGURES, "viewpoints")):
        for number, (name, regions) in figures.items():
            run = made.get((name, "exact", regions))
            if run:
                found[number] = lab.picture(run, colour_by, colour_by=colour_by, size=config["picture_size"])
    return found


def jobs(config, notes):
    first = next(iter(runs(config).values()))
    return [*runs(config).values(), *annealed(config).values(), *covers(config).values(), *pictures(config).values(), first.again()]


def outputs(config):
    return {"tables": ["table1", "table2", "table3", "methods"], "figures": ["coverage"],
            "pictures": [f"figure{number}.png" for number in pictures(config)]}
