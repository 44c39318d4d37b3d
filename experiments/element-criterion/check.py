"""Audited areas add up, and every bundle withstands `verify`."""
import math

from lab import planning

plan = planning.load("element-criterion", "plan")


def check(rows, config, require):
    for key, job in plan.audits(config).items():
        row = rows[job.key]
        if row["failure"]:
            continue
        audit = row["result"]
        # Viewpoints may image elements that no region sees by random rays.
        imaged = audit["coverable_area"] - audit["missed_area"]
        require(math.isclose(audit["imaged_percent"], 100 * imaged / audit["coverable_area"], rel_tol=1e-9),
                f"{job.key}: {audit['imaged_percent']} % imaged does not fit the areas")
        fits = math.isclose(audit["imaged_area"], imaged, rel_tol=1e-9)
        require(fits or key[1] == "rays" and audit["imaged_area"] > imaged, f"{job.key}: imaged and missed area do not add up")
        require(audit["seen_wholly"] + audit["seen_in_part"] + audit["not_seen"] == audit["elements"], f"{job.key}: elements do not add up")
        run = rows[plan.runs(config)[key].key]["result"]
        require(audit["viewpoints"] == run["viewpoints"] and audit["elements"] == run["elements"], f"{job.key}: is not the audit of its run")
        # What rays or an exact backend call seen, exact areas call seen.
        require(audit["seen_wholly"] + audit["seen_in_part"] >= run["visible_elements"],
                f"{job.key}: {run['visible_elements']} elements are coverable, the viewpoints see {audit['seen_wholly'] + audit['seen_in_part']}")
        verdict = rows[plan.verdicts(config)[key].key]
        require(verdict["failure"] is None, f"{verdict['job']}: {verdict['failure']}")
