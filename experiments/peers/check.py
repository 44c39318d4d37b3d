"""The conservative test misses nothing; all speak of the same exact pairs."""
from lab import planning

plan = planning.load("peers", "plan")


def check(rows, config, require):
    for (name, peer, _, _), job in plan.peers(config).items():
        row = rows[job.key]
        if row["failure"]:
            continue
        result = row["result"]
        require(peer != "one-occluder" or result["missed"] == 0, f"{job.key}: the conservative test misses {result['missed']} pairs")
        for measure in ("Q_u", "Q_o"):
            require(0 <= result[measure]["count"], f"{job.key}: {measure} is {result[measure]['count']}")
        exact = [rows[other.key]["result"]["pairs"]["b"]["count"] for key, other in plan.comparisons(config).items() if key[0] == name]
        # On a common refinement there are no fewer pairs than on the exact run's own elements.
        require(all(result["exact_pairs"] <= pairs for pairs in exact), f"{job.key}: {result['exact_pairs']} exact pairs, other comparisons {exact}")
