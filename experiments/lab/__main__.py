"""python3 -m lab collect|check|draw PLAN QUESTION ...: the steps after the jobs."""
import json
import pathlib
import sys

from lab import checks, planning, rows


def main():
    step, plan_file, question, *rest = sys.argv[1:]
    plan = json.loads(pathlib.Path(plan_file).read_text())
    if step == "collect":
        rows.collect(plan, question, rest[0])
    elif step == "check":
        try:
            checked = checks.check_all(plan, question, rest[0])
            planning.load(question, "check").check(checked, plan["questions"][question]["config"], checks.require)
        except checks.Refused as refused:
            sys.exit(f"{question}: {refused}")
        failures = [f"{key}: {row['failure']}" for key, row in checked.items() if row["failure"]]
        pathlib.Path(rest[1]).write_text("".join(f"{line}\n" for line in [f"{len(checked)} rows hold", *failures]))
        for line in failures:
            print(f"{question}: no result from {line}")
    elif step == "draw":
        folder = pathlib.Path(rest[0])
        folder.mkdir(parents=True, exist_ok=True)
        read = {key: rows.read_row(plan, key) for key in plan["questions"][question]["jobs"]}
        planning.load(question, "draw").draw(read, plan["questions"][question]["config"], folder, planning.ROOT / plan["folder"])
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
