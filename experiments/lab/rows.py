"""Rows: what jobs left, read back, and the flat table that a question draws from."""
from __future__ import annotations

import csv
import json
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent


def read_row(plan, key):
    return json.loads((ROOT / plan["folder"] / key / "row.json").read_text())


def flat(row):
    """One line of rows.csv: what was asked, what came out, how long it took, and where it comes from."""
    line = {"job": row["job"], "kind": row["kind"], **row["labels"], "failure": row["failure"] or ""}
    result = row["result"] or {}
    for name, value in result.items():
        if isinstance(value, dict):
            line.update({f"{name}.{inner}": one for inner, one in value.items() if not isinstance(one, (dict, list))})
            for inner, one in value.items():
                if isinstance(one, dict):
                    line.update({f"{name}.{inner}.{innermost}": x for innermost, x in one.items()})
        elif not isinstance(value, list):
            line[name] = value
    if row["bundle"]:
        record = row["bundle"]["record"]
        for name in ("viewpoints_by_annealing_alone", "regions_lower_bound", "viewpoints_lower_bound", "imaged_percent"):
            if name in record["results"]:
                line[name] = record["results"][name]
        line["element_area"] = record["options"]["element_area"]
        line["options"] = json.dumps(record["options"], sort_keys=True)
    line.update(seed=row["seed"], threads=row["threads"], exit_code=row["exit_code"], wall_seconds=row.get("wall_seconds"),
                commit=row["commit"], source=row["source"], machine=row["machine"], command=" ".join(row["command"]))
    return line


def as_text(value):
    if value is None:
        return ""
    if isinstance(value, float):
        return repr(value)
    return str(value)


def collect(plan, question, file):
    """Writes rows.csv of a question: a line for each of its jobs, in order."""
    lines = [flat(read_row(plan, key)) for key in plan["questions"][question]["jobs"]]
    titles = []
    for line in lines:
        titles += [title for title in line if title not in titles]
    last = ["seed", "threads", "exit_code", "wall_seconds", "commit", "source", "machine", "options", "command"]
    titles = [title for title in titles if title not in last] + [title for title in last if title in titles]
    with open(file, "w", newline="") as stream:
        writer = csv.writer(stream, lineterminator="\n")
        writer.writerow(titles)
        writer.writerows([as_text(line.get(title)) for title in titles] for line in lines)


def read(file):
    """rows.csv as dictionaries of text."""
    with open(file, newline="") as stream:
        return list(csv.DictReader(stream))
