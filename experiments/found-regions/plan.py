"""A region that nobody drew, and what cracks and narrow gaps change."""
from lab import jobs as lab
from lab import planning


def present(config, notes):
    """{scene: (files, options)} of those that are there; a note for each that is not."""
    found = {}
    for name, options in config["scenes"].items():
        scene = lab.file_scene(config["scenes_folder"], name)
        if (planning.ROOT / scene.obj).exists():
            found[name] = scene, options
        else:
            notes.append(f"found-regions: {scene.obj} is not there, skipped")
    return found


def inspections(config, notes):
    return {name: lab.inspect(scene, width=options["heal"]) for name, (scene, options) in present(config, notes).items()}


def runs(config, notes):
    """{(scene, whether cracks are closed): run}, in one region; as the scene is, with a second look without narrow gaps."""
    made = {}
    for name, (scene, options) in present(config, notes).items():
        aperture = options["aperture"]
        region = lab.found_region(scene, **{key: value for key, value in options.items() if key != "aperture"})
        made[name, False] = lab.solve(region, regions=config["regions"], aperture=aperture, viewpoints="none")
        made[name, True] = lab.solve(region, regions=config["regions"], heal=options["heal"], viewpoints="none")
    return made


def jobs(config, notes):
    return [*inspections(config, notes).values(), *runs(config, []).values()]


def outputs(config):
    return {"tables": ["found_regions"], "figures": [], "pictures": []}
