"""Optimum, bound, viewpoints, links, time and memory over a grid of region levels and element sizes, exactly and by rays."""
from lab import jobs as lab


def runs(config):
    """{(scene, backend, element area, regions): run}"""
    grid = {}
    for name in config["scenes"]:
        for backend in ("exact", "rays"):
            for area in config["element_areas"]:
                for regions in config["regions"]:
                    rays = {"rays": config["ray_runs"]} if backend == "rays" else {}
                    grid[name, backend, area, regions] = lab.solve(lab.room(name), backend=backend, regions=regions, element_area=area, **rays)
    return grid


def jobs(config, notes):
    grid = runs(config)
    return [*grid.values(), next(iter(grid.values())).again()]


def outputs(config):
    return {"tables": ["subdivision"], "figures": ["regions", "cost"], "pictures": []}
