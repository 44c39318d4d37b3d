"""What every row must withstand, whatever the question. A check that fails raises Refused with a line that says what is wrong."""
from __future__ import annotations

import math

from lab import execute, rows

# Names of results that are times or sizes in memory: another run has others.
MEASURED = ("seconds", "peak_memory_kb", "best_after_seconds", "wall_seconds", "ms")


class Refused(Exception):
    """A result that cannot be right."""


def require(condition, message):
    if not condition:
        raise Refused(message)


def timeless(value):
    """A result without times, and without the folder it was found in."""
    if isinstance(value, dict):
        return {name: timeless(inner) for name, inner in value.items() if name not in MEASURED and name not in ("measured", "figure", "audit")}
    if isinstance(value, list):
        return [timeless(inner) for inner in value]
    return value


def check_row(plan, key):
    """The row of a job is whole, and of the job that was planned."""
    job, row = plan["jobs"][key], rows.read_row(plan, key)
    require(row["digest"] == execute.digest(row), f"{key}/row.json has been changed since the run: its digest is another")
    words = execute.command_of(job, f"{plan['folder']}/{key}", plan)
    words = ["python3" if word == execute.sys.executable else word for word in words]
    require(row["command"] == words, f"{key} ran `{' '.join(row['command'])}`, planned is `{' '.join(words)}`")
    require(row["seed"] == job["seed"], f"{key} has seed {row['seed']}, planned is {job['seed']}")
    require(row["source"] == plan["source"], f"{key} was run from other sources ({row['source']}, now {plan['source']}): run it again")
    for name, sha in row["files"].items():
        file = rows.ROOT / plan["folder"] / key / name
        require(file.exists(), f"{key}/{name} is gone since the run")
        require(execute.sha256(file) == sha, f"{key}/{name} has been changed since the run")
    if row["bundle"]:
        check_bundle(key, job, row)
    return row


def check_bundle(key, job, row):
    """A run did what it was asked, and its numbers fit together."""
    record, last = row["bundle"]["record"], row["result"]
    asked = dict(job["labels"])
    require(record["seed"] == job["seed"], f"{key}: run.json has seed {record['seed']}, planned is {job['seed']}")
    for name in ("backend", "rays", "coverage", "optimizer", "regions", "element_area", "time_limit", "close_gap"):
        if name not in asked:
            continue
        did, want = record["options"][name], asked[name]
        same = math.isclose(did, want, rel_tol=1e-5) if isinstance(want, float) else did == want
        require(same, f"{key}: run.json has {name} {did}, planned is {want}")
    results = record["results"]
    for name in ("regions", "elements", "visible_elements", "links", "optimal_regions", "viewpoints"):
        require(last[name] == results.get(name), f"{key}: the last line says {name} {last[name]}, run.json {results.get(name)}")
    require(last["visible_elements"] <= last["elements"], f"{key}: {last['visible_elements']} of {last['elements']} elements are visible")
    covers = [float(cover["covered_area_percent"]) for cover in row["bundle"]["covers"]]
    require(all(a <= b for a, b in zip(covers, covers[1:])), f"{key}: more regions cover less in cover.csv")
    require(len(covers) == last["optimal_regions"], f"{key}: {len(covers)} sets in cover.csv, {last['optimal_regions']} regions")
    for k, cover in enumerate(row["bundle"]["covers"], start=1):
        require(len(cover["regions"].split()) == k, f"{key}: cover.csv has {cover['regions']!r} for k = {k}")
        require(float(cover["upper_bound_percent"]) >= float(cover["covered_area_percent"]) - 1e-9,
                f"{key}: k = {k} covers more than its upper bound")
    seen = [float(viewpoint["covered_area_percent"]) for viewpoint in row["bundle"]["viewpoints"]]
    require(all(a <= b for a, b in zip(seen, seen[1:])), f"{key}: more viewpoints see less in viewpoints.csv")
    bound = last["lower_bound"]
    if last["viewpoints"] is not None and bound is not None:
        require(bound <= last["viewpoints"], f"{key}: lower bound {bound} above {last['viewpoints']} viewpoints")
        require(results["regions_lower_bound"] <= bound, f"{key}: bound {bound} below that by regions")
    require(last["backend"] == "exact" or bound is None, f"{key}: a lower bound from {last['backend']}")


def check_again(first, second):
    """Two runs of one job agree in all but times."""
    for name in ("result", "bundle"):
        a, b = timeless(first[name]), timeless(second[name])
        require(a == b, f"{first['job']}: run again it gives another {name}: {difference(a, b)}")
    for name, sha in first["files"].items():
        require(second["files"].get(name) == sha, f"{first['job']}: run again it writes another {name}")


def difference(a, b, path=""):
    """Where two results differ first."""
    if isinstance(a, dict) and isinstance(b, dict):
        for name in sorted({*a, *b}):
            if a.get(name) != b.get(name):
                return difference(a.get(name), b.get(name), f"{path}.{name}" if path else name)
    if isinstance(a, list) and isinstance(b, list) and len(a) == len(b):
        for i, (x, y) in enumerate(zip(a, b)):
            if x != y:
                return difference(x, y, f"{path}[{i}]")
    return f"{path} {a} and {b}"


def check_table(plan, question, file):
    """rows.csv says what the rows of the jobs say, line by line and column by column."""
    keys = plan["questions"][question]["jobs"]
    table = rows.read(file)
    require(len(table) == len(keys), f"{file}: {len(table)} rows, planned are {len(keys)}")
    for number, (key, line) in enumerate(zip(keys, table), start=2):
        expected = {name: rows.as_text(value) for name, value in rows.flat(rows.read_row(plan, key)).items()}
        require(line["job"] == key, f"{file}:{number}: job {line['job']}, planned is {key}")
        for name, value in expected.items():
            require(line.get(name) == value, f"{file}:{number}: {name} is {line.get(name)!r}, but {key} says {value!r}")
        for name, value in line.items():
            require(name in expected or not value, f"{file}:{number}: {name} is {value!r}, but {key} says nothing of it")


def check_all(plan, question, file):
    """All of this; returns the rows by job."""
    checked = {key: check_row(plan, key) for key in plan["questions"][question]["jobs"]}
    for key, row in checked.items():
        first = row["labels"].get("again_of")
        if first and not (row["failure"] or checked[first]["failure"]):
            check_again(checked[first], row)
    check_table(plan, question, file)
    return checked
