"""Lower bound and viewpoints when `--close-gap` allows more and more seconds."""
from lab import jobs as lab

# Floor plans: corners, and how many guards they take, where that is known (tests/full_coverage derives them).
GALLERIES = {
    "comb3": ("0 0 12 0 12 1 10 1 10 9 9 9 9 1 6 1 6 9 5 9 5 1 2 1 2 9 1 9 1 1 0 1", 3),
    "comb5": ("0 0 22 0 22 1 20 1 20 9 19 9 19 1 16 1 16 9 15 9 15 1 12 1 12 9 11 9 11 1 8 1 8 9 7 9 7 1 4 1 4 9 3 9 3 1 0 1", 5),
    "reflex": ("0 0 8 0 8 4 4 4 4 8 0 8", 1),
    "holes": ("0 0 20 0 20 12 0 12 | 4 4 4 8 8 8 8 4 | 12 4 12 8 16 8 16 4", None),
}


def scenes(config):
    found = {name: lab.room(name) for name in config["scenes"]}
    for name in config["galleries"]:
        found[name] = lab.gallery(name, GALLERIES[name][0])
    return found


def runs(config):
    """{(scene, coverage, regions, seconds): run}; galleries by full coverage of 64 regions only."""
    made = {}
    for name, scene in scenes(config).items():
        is_room = name in config["scenes"]
        for coverage in config["coverages"] if is_room else ["full"]:
            for regions in config["regions"] if is_room else config["regions"][:1]:
                for seconds in config["seconds"]:
                    made[name, coverage, regions, seconds] = lab.solve(scene, regions=regions, coverage=coverage, close_gap=seconds)
    return made


def jobs(config, notes):
    return list(runs(config).values())


def outputs(config):
    return {"tables": ["bracket"], "figures": ["bracket"], "pictures": []}
