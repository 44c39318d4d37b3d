"""Exact audits of viewpoints that see a part of each element, for smaller and smaller elements."""
from lab import jobs as lab


def runs(config):
    """{(scene, backend, element area): run}"""
    return {(name, backend, area): lab.solve(lab.room(name), backend=backend, regions=config["regions"], element_area=area,
                                             **({"rays": 16} if backend == "rays" else {}))
            for name in config["scenes"] for backend in config["backends"] for area in config["element_areas"]}


def audits(config):
    return {key: lab.audit(run) for key, run in runs(config).items()}


def verdicts(config):
    """Whether `verify` holds; after the audit, so that it checks that, too."""
    return {key: lab.verify(run, (audits(config)[key],)) for key, run in runs(config).items()}


def jobs(config, notes):
    return [*runs(config).values(), *audits(config).values(), *verdicts(config).values()]


def outputs(config):
    return {"tables": ["element_criterion"], "figures": ["missed"], "pictures": []}
