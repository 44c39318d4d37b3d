"""checks_test.py PROGRAM: what experiments must refuse. A small question is run, then its results are damaged, one way after the other."""
import csv
import dataclasses
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "experiments"))

try:
    from lab import checks, planning, rows
except ImportError as error:
    print(f"skipped: {error}; scripts/setup --experiments installs it")
    sys.exit(77)

QUESTION = "rays-vs-exact"
CONFIG = {"scenes": ["simple"], "regions": 4, "rays": [1, 16], "seeds": [1, 2], "most_rays_complex": 1, "soup_occluders": [20], "soup_queries": 3,
          "soup_most_rays": 64, "soup_width": 0.7}


class Results:
    """The plan and all that its jobs left, in a folder of its own."""

    def __init__(self, program, folder):
        self.folder = folder
        folder.mkdir()
        module = planning.load(QUESTION, "plan")
        jobs = {job.key: job for wanted in module.jobs(CONFIG, []) for job in wanted.with_needs()}
        self.jobs = jobs
        self.plan = {"folder": str(folder), "program": program, "job_seconds": 120, "source": "sources", "commit": "commit", "machine": "machine",
                     "jobs": {key: job.as_json() for key, job in jobs.items()}, "questions": {QUESTION: {"jobs": list(jobs), "config": CONFIG}}}
        self.table = folder / "rows.csv"
        self.save()
        for key in jobs:
            self.run(key)
        rows.collect(self.plan, QUESTION, self.table)

    def save(self):
        (self.folder / "plan.json").write_text(json.dumps(self.plan))

    def run(self, key):
        subprocess.run([sys.executable, "experiments/lab/execute.py", self.folder / "plan.json", key], cwd=ROOT, check=True)

    def check(self):
        """The line of the check that fails, or nothing."""
        try:
            checked = checks.check_all(self.plan, QUESTION, self.table)
            planning.load(QUESTION, "check").check(checked, CONFIG, checks.require)
        except checks.Refused as refused:
            return str(refused)
        return ""

    def row(self, key):
        return self.folder / key / "row.json"

    def change_row(self, key, change, seal=False):
        """Edits row.json; with `seal` its digest, too, as a careful forger would."""
        row = json.loads(self.row(key).read_text())
        change(row)
        if seal:
            row["digest"] = checks.execute.digest(row)
        self.row(key).write_text(json.dumps(row))
        if seal:
            rows.collect(self.plan, QUESTION, self.table)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as folder:
        whole = Results(program, pathlib.Path(folder) / "whole")
        problem = whole.check()
        assert problem == "", problem
        run = next(key for key, job in whole.jobs.items() if job.kind == "solve" and ("rays", 16) in job.labels and job.seed == 2)
        again = next(key for key in whole.jobs if key.endswith(".again"))
        first = again.removesuffix(".again")
        compared = next(key for key, job in whole.jobs.items() if job.kind == "compare")
        copy = shutil.copytree(whole.folder, pathlib.Path(folder) / "kept")

        def restore():
            shutil.rmtree(whole.folder)
            shutil.copytree(copy, whole.folder)
            whole.plan["jobs"] = {key: job.as_json() for key, job in whole.jobs.items()}
            whole.save()

        def expect(pattern):
            problem = whole.check()
            assert re.search(pattern, problem), f"expected a line with {pattern!r}, not {problem!r}"
            print(f"refused: {problem[:160]}")
            restore()

        def table(change):
            with open(whole.table, newline="") as file:
                lines = list(csv.reader(file))
            change(lines)
            with open(whole.table, "w", newline="") as file:
                csv.writer(file, lineterminator="\n").writerows(lines)

        # Lines of rows.csv: a cell changed, two columns swapped, a line gone, lines in another order.
        def other_cell(lines):
            lines[3][lines[0].index("links")] = "7"
        table(other_cell)
        expect(r"rows\.csv:4: links is '7', but .* says '\d+'")

        def swapped(lines):
            a, b = lines[0].index("elements"), lines[0].index("links")
            for line in lines[1:]:
                line[a], line[b] = line[b], line[a]
        table(swapped)
        expect(r"rows\.csv:\d+: (elements|links) is '\d+', but .* says '\d+'")
        table(lambda lines: lines.pop(2))
        expect(r"rows, planned are")
        table(lambda lines: lines.insert(1, lines.pop(2)))
        expect(r"rows\.csv:2: job .*, planned is")

        # A shifted seed.
        whole.plan["jobs"][run] = dataclasses.replace(whole.jobs[run], seed=3, words=tuple(
            "3" if before == "--seed" else word for before, word in zip(("", *whole.jobs[run].words), whole.jobs[run].words))).as_json()
        whole.save()
        whole.run(run)
        whole.plan["jobs"] = {key: job.as_json() for key, job in whole.jobs.items()}
        expect(re.escape(run) + r" ran `.*--seed 3.*`, planned is `.*--seed 2")
        whole.change_row(run, lambda row: row["bundle"]["record"].update(seed=3), seal=True)
        expect(r"run\.json has seed 3, planned is 2")

        # A result changed by hand, carelessly and with care.
        whole.change_row(run, lambda row: row["result"].update(links=1))
        expect(re.escape(run) + r"/row\.json has been changed")
        whole.change_row(run, lambda row: row["result"].update(links=1), seal=True)
        expect(r"the last line says links 1, run\.json \d+")
        whole.change_row(compared, lambda row: row["result"]["Q_u"].update(count=0.5), seal=True)
        expect(r"Q_u does not fit its pairs")
        whole.change_row(compared, lambda row: row["result"]["Q_o"].update(count=0.1), seal=True)
        expect(r"rays see 0\.1 more than there is to see")
        whole.change_row(again, lambda row: row["bundle"]["record"]["verdicts"].update(hidden_by_one=1), seal=True)
        expect(re.escape(first) + r": run again it gives another bundle: record\.verdicts\.hidden_by_one \d+ and 1")

        # A file of a bundle, and rows of another program.
        with open(whole.folder / run / "bundle/visibility.mtx", "a") as file:
            file.write("1 1\n")
        expect(r"visibility\.mtx has been changed since the run")
        whole.change_row(run, lambda row: row.update(source="others"), seal=True)
        expect(r"was run from other sources")

        # A failure is a result, also of what needs it.
        whole.plan["jobs"][run]["words"] = ["solve", "nothing.obj"]
        whole.save()
        whole.run(run)
        after = next(key for key, job in whole.jobs.items() if job.kind == "compare" and job.needs[0].key == run)
        whole.run(after)
        assert "--region" in json.loads(whole.row(run).read_text())["failure"]
        assert json.loads(whole.row(after).read_text())["failure"] == f"{run} failed"


if __name__ == "__main__":
    main()
