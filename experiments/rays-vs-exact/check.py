"""Rays call nothing visible that is hidden, and more of them miss no more."""
from lab import planning

plan = planning.load("rays-vs-exact", "plan")


def check(rows, config, require):
    for (name, rays, seed), job in plan.comparisons(config).items():
        row = rows[job.key]
        if row["failure"]:
            continue
        result = row["result"]
        require(result["Q_o"]["count"] == 0 and not result["excess"], f"{job.key}: rays see {result['Q_o']['count']} more than there is to see")
        for by in ("count", "area"):
            require(0 <= result["Q_u"][by] < 1, f"{job.key}: Q_u by {by} is {result['Q_u'][by]}, not a share")
        pairs = result["pairs"]
        missed = sum(one["count"] for one in result["missed"].values())
        require(missed == pairs["b"]["count"] - pairs["a"]["count"],
                f"{job.key}: {missed} pairs missed, but {pairs['a']['count']} of {pairs['b']['count']} found")
        require(abs(result["Q_u"]["count"] - missed / pairs["b"]["count"]) < 1e-12, f"{job.key}: Q_u does not fit its pairs")
        regions = rows[plan.ray_runs(config)[name, rays, seed].key]["result"]["optimal_regions"]
        require(result["optimum"]["regions"] == regions, f"{job.key}: {result['optimum']['regions']} regions judged, {regions} chosen")
    for name in config["scenes"]:
        means = []
        for rays in plan.rays_of(name, config):
            found = [rows[job.key] for key, job in plan.comparisons(config).items() if key[:2] == (name, rays)]
            found = [row["result"]["Q_u"]["count"] for row in found if not row["failure"]]
            if found:
                means.append((rays, sum(found) / len(found)))
        for (fewer, missed_more), (more, missed) in zip(means, means[1:]):
            require(missed <= missed_more, f"{name}: {more} rays miss more ({missed:.4f}) than {fewer} ({missed_more:.4f})")
    for n, job in plan.soups(config).items():
        row = rows[job.key]
        if row["failure"]:
            continue
        result = row["result"]
        require(result["visible"] + result["hidden"] == config["soup_queries"], f"{job.key}: not all queries are accounted for")
        require(len(result["rays"]) == result["visible"], f"{job.key}: {len(result['rays'])} of {result['visible']} visible queries are listed")
