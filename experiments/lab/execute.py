"""execute.py PLAN KEY: runs one job of a plan and leaves DIR/KEY/row.json, its result. A failure is a result, too.

The row says what was run, from which sources, where, with what outcome; a digest over it and over the files of the job tells later
whether somebody has changed them.
"""
import csv
import datetime
import hashlib
import json
import os
import pathlib
import shutil
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
# Files of a bundle that hold no times: the same from any two runs.
TIMELESS = {"visibility.mtx", "viewpoints.mtx", "bound.mtx", "links.csv", "elements.csv", "regions.csv", "witnesses.csv", "cover.proof",
            "bound.proof", "bound.csv", "audit.csv", "scene.obj", "scene.region.json", "figure.png"}


def sha256(file):
    return hashlib.sha256(pathlib.Path(file).read_bytes()).hexdigest()


def digest(row):
    """Of all of a row but the digest."""
    text = json.dumps({name: value for name, value in row.items() if name != "digest"}, sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def last_json(text):
    for line in reversed(text.strip().splitlines()):
        if line.startswith("{"):
            return json.loads(line)
    return None


def command_of(job, folder, plan):
    words = []
    for word in job["words"]:
        word = word.replace("{folder}", str(folder))
        for need in job["needs"]:
            word = word.replace("{" + need + "}", f"{plan['folder']}/{need}")
        words.append(word)
    if job["script"]:
        return [sys.executable, str(HERE.relative_to(ROOT) / words[0]), plan["program"], *words[1:]]
    return [plan[job["program"]], *words]


def failed_need(job, plan):
    """The first job that this one needs and that failed."""
    for need in job["needs"]:
        row = json.loads((ROOT / plan["folder"] / need / "row.json").read_text())
        if row["failure"]:
            return need
    return None


def csv_rows(file):
    with open(file, newline="") as stream:
        return list(csv.DictReader(stream))


def bundle_result(bundle):
    """What a run says of itself, and its tables 2 and 3."""
    record = json.loads((bundle / "run.json").read_text())
    return {"record": {name: record[name] for name in ("seed", "options", "scene", "verdicts", "results", "measured")},
            "covers": csv_rows(bundle / "cover.csv"), "viewpoints": csv_rows(bundle / "viewpoints.csv")}


def run(job, plan):
    folder = pathlib.Path(plan["folder"]) / job["key"]
    shutil.rmtree(ROOT / folder, ignore_errors=True)
    (ROOT / folder).mkdir(parents=True)
    command = command_of(job, folder, plan)
    row = {"job": job["key"], "kind": job["kind"], "labels": dict(job["labels"]), "seed": job["seed"], "threads": job["threads"],
           "command": ["python3" if word == sys.executable else word for word in command], "source": plan["source"], "commit": plan["commit"],
           "started": datetime.datetime.now(datetime.timezone.utc).isoformat(timespec="seconds"), "failure": None, "exit_code": None,
           "result": None, "bundle": None, "files": {}}
    need = failed_need(job, plan)
    if need:
        row["failure"] = f"{need} failed"
    else:
        begin = time.monotonic()
        try:
            done = subprocess.run(command, cwd=ROOT, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                  timeout=plan["job_seconds"])
            row["exit_code"] = done.returncode
            if done.returncode in (0, 1):
                row["result"] = last_json(done.stdout)
            else:
                lines = done.stderr.strip().splitlines()
                row["failure"] = lines[-1] if lines else f"exit code {done.returncode}"
        except subprocess.TimeoutExpired:
            row["failure"] = f"no answer within {plan['job_seconds']} s"
        row["wall_seconds"] = time.monotonic() - begin
    bundle = ROOT / folder / "bundle"
    if row["failure"] is None and job["kind"] == "solve":
        row["bundle"] = bundle_result(bundle)
    if job["kind"] == "picture" and row["failure"] is None:
        # Beside the bundle it is of: keep it here, where the next picture of that run does not replace it.
        shutil.copy(ROOT / row["result"]["figure"], ROOT / folder / "figure.png")
    row["machine"] = plan["machine"]
    for file in sorted((ROOT / folder).rglob("*")):
        if file.name in TIMELESS:
            row["files"][str(file.relative_to(ROOT / folder))] = sha256(file)
    row["digest"] = digest(row)
    return row


def main():
    plan = json.loads(pathlib.Path(sys.argv[1]).read_text())
    row = run(plan["jobs"][sys.argv[2]], plan)
    out = ROOT / plan["folder"] / sys.argv[2] / "row.json"
    part = out.with_suffix(".part")
    part.write_text(json.dumps(row, indent=1, sort_keys=True) + "\n")
    os.replace(part, out)


if __name__ == "__main__":
    main()
