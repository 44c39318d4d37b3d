"""No method finds fewer regions than are proved to be needed, and none claims a bound above what another found."""
from lab import planning

plan = planning.load("optimizers", "plan")


def check(rows, config, require):
    exact = {key: rows[cover.key]["result"] for key, cover in plan.exact_covers(config).items() if not rows[cover.key]["failure"]}
    for key, result in exact.items():
        require(result["lower_bound"] <= result["size"], f"{plan.exact_covers(config)[key].key}: bound {result['lower_bound']} above {result['size']}")
    for job in plan.proofs(config).values():
        row = rows[job.key]
        require(row["failure"] or row["result"]["holds"], f"{job.key}: {(row['result'] or {}).get('says')}")
    tried = [(key[:3], job) for key, job in plan.covers(config).items()]
    regions = config.get("sweep_regions", config["regions"][-1])
    tried += [((key[0], "rays", regions), job) for key, job in plan.sweep(config).items()]
    for key, job in tried:
        row = rows[job.key]
        if row["failure"] or key not in exact:
            continue
        result = row["result"]
        require(result["size"] >= exact[key]["lower_bound"], f"{job.key}: {result['size']} regions, fewer than the bound {exact[key]['lower_bound']}")
        require(result["lower_bound"] <= exact[key]["size"], f"{job.key}: bound {result['lower_bound']}, but {exact[key]['size']} regions do")
        require(len(set(result["chosen"])) == result["size"], f"{job.key}: size {result['size']}, but {len(set(result['chosen']))} regions chosen")
