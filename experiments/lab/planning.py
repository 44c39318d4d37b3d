"""The plan of a variant: all jobs of all questions, from their configs, with the sources and the machine they are run with."""
from __future__ import annotations

import hashlib
import importlib.util
import json
import os
import pathlib
import platform
import subprocess

import yaml

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
EXPERIMENTS = ROOT / "experiments"
QUESTIONS = ["paper-tables", "rays-vs-exact", "subdivision", "optimizers", "bracket", "element-criterion", "real-scenes", "found-regions", "scaling",
             "peers"]
# What `snakemake --config NAME=VALUE` may change. Folders are relative to the project's root.
DEFAULTS = {"variant": "full", "questions": [q for q in QUESTIONS if (EXPERIMENTS / q / "plan.py").exists()], "program": "build/release/viewcover", "peers": "build/release/experiments/viewcover_peers",
            "scenes": "../shared/scenes", "results": "experiments/results", "job_seconds": 3600}


def load(question, module):
    """experiments/QUESTION/MODULE.py"""
    spec = importlib.util.spec_from_file_location(module, EXPERIMENTS / question / f"{module}.py")
    loaded = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(loaded)
    return loaded


def config_of(question, variant):
    """What `all` says and the variant says besides."""
    config = yaml.safe_load((EXPERIMENTS / question / "config.yaml").read_text())
    return {**config.get("all", {}), **config[variant]}


def source_hash():
    """Of all that the program is made from."""
    total = hashlib.sha256()
    files = [ROOT / "CMakeLists.txt", *(ROOT / "src").rglob("*"), *(ROOT / "experiments/peers").glob("*.cpp")]
    for file in sorted(file for file in files if file.is_file()):
        total.update(str(file.relative_to(ROOT)).encode() + b"\0" + file.read_bytes())
    return total.hexdigest()[:12]


def commit():
    done = subprocess.run(["git", "describe", "--always", "--dirty", "--abbrev=12"], cwd=ROOT, stdout=subprocess.PIPE, text=True)
    return done.stdout.strip() or "unknown"


def machine():
    model = platform.processor() or platform.machine()
    try:
        for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                model = line.split(":", 1)[1].strip()
                break
    except OSError:
        pass
    return f"{model}, {os.cpu_count()} cores, {platform.system()}"


def make(config):
    """The plan, and where its pieces stand."""
    variant = config["variant"]
    scenes = os.path.relpath(ROOT / config["scenes"], ROOT)
    plan = {"variant": variant, "folder": f"build/experiments/{variant}", "program": config["program"], "peers": config["peers"],
            "job_seconds": config["job_seconds"], "source": source_hash(), "commit": commit(), "machine": machine(), "jobs": {}, "questions": {}}
    notes = []
    for question in config["questions"]:
        own = {**config_of(question, variant), "scenes_folder": scenes}
        module = load(question, "plan")
        jobs = {}
        for job in module.jobs(own, notes):
            for need in job.with_needs():
                jobs[need.key] = need
        plan["jobs"].update({key: job.as_json() for key, job in jobs.items()})
        plan["questions"][question] = {"jobs": list(jobs), "config": own, **module.outputs(own)}
    return plan, notes


def write_if_changed(plan, file):
    text = json.dumps(plan, indent=1, sort_keys=True) + "\n"
    file.parent.mkdir(parents=True, exist_ok=True)
    if not file.exists() or file.read_text() != text:
        part = file.with_suffix(f".{os.getpid()}")
        part.write_text(text)
        os.replace(part, file)
