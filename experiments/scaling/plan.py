"""Large scenes."""
import os

from lab import jobs as lab


def runs(config):
    return {count: lab.solve(lab.rooms(count, config["detail"]), regions=config["regions"], viewpoints=config["viewpoints"], close_gap=None if
                             config["viewpoints"] == "none" else 0, threads=os.cpu_count()) for count in config["rooms"]}


def jobs(config, notes):
    return list(runs(config).values())


def outputs(config):
    return {"tables": ["scaling"], "figures": ["scaling"], "pictures": []}
