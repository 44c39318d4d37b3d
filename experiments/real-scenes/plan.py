"""Viewpoints and their bound for a part of each element and for all that is visible, verified."""
from lab import jobs as lab
from lab import planning


def present(config, notes):
    """The scenes that are there; a note for each that is not."""
    found = {name: lab.room(name) for name in config["rooms"]}
    for name in config["scenes"]:
        scene = lab.file_scene(config["scenes_folder"], name)
        if (planning.ROOT / scene.obj).exists() and (planning.ROOT / scene.region).exists():
            found[name] = scene
        else:
            notes.append(f"real-scenes: {scene.obj} is not there, skipped")
    return found


def runs(config, notes):
    """{(scene, coverage): run}"""
    made = {}
    for name, scene in present(config, notes).items():
        made[name, "elements"] = lab.solve(scene, regions=config["regions"])
        made[name, "full"] = lab.solve(scene, regions=config["regions"], coverage="full", close_gap=config["full_seconds"])
    return made


def verdicts(config, notes):
    return {key: lab.verify(run) for key, run in runs(config, notes).items()}


def jobs(config, notes):
    return [*runs(config, notes).values(), *verdicts(config, []).values()]


def outputs(config):
    return {"tables": ["real_scenes"], "figures": [], "pictures": []}
