"""A region that nobody drew, and what hairline cracks change."""
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
    """{(scene, whether cracks are closed): run}, in one region."""
    made = {}
    for name, (scene, options) in present(config, notes).items():
        heal = options["heal"]
        region = lab.found_region(scene, **options)
        for healed in (False, True):
            made[name, healed] = lab.solve(region, regions=config["regions"], heal=heal if healed else None, viewpoints="none")
    return made


def jobs(config, notes):
    return [*inspections(config, notes).values(), *runs(config, []).values()]


def outputs(config):
    return {"tables": ["found_regions"], "figures": [], "pictures": []}
