"""Jobs: one command of viewcover each, what it needs first, and what the row it leaves is labelled with.

A job's words may name `{folder}`, its own folder, and `{KEY}`, the folder of the job KEY. Its key names the folder, so equal jobs
of two questions are one job.
"""
from __future__ import annotations

import dataclasses

@dataclasses.dataclass(frozen=True)
class Job:
    key: str
    kind: str
    words: tuple[str, ...]  # after the program
    needs: tuple[Job, ...] = ()
    seed: int = 1
    labels: tuple[tuple[str, object], ...] = ()
    threads: int = 1
    program: str = "program"  # or "peers"
    script: bool = False  # the first word is a script of this folder's, run by Python with the program as its first argument

    def with_needs(self):
        """The job after all that it needs, first things first."""
        return [*(job for need in self.needs for job in need.with_needs()), self]

    def again(self):
        """The same job once more, for the check that two runs agree."""
        return dataclasses.replace(self, key=self.key + ".again", labels=(*self.labels, ("again_of", self.key)))

    def as_json(self):
        return {**dataclasses.asdict(self), "needs": [need.key for need in self.needs]}


def text(value):
    """A number as few characters, for keys and words."""
    return f"{value:g}" if isinstance(value, float) else str(value)


def option_words(options):
    """{"time_limit": 5, "quiet": True} as --time-limit 5 --quiet; None is left out."""
    words = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        words.append("--" + name.replace("_", "-"))
        if value is not True:
            words.append(text(value))
    return tuple(words)


def key_of(*parts, **options):
    values = [f"{name.replace('_', '')}{'' if value is True else text(value)}" for name, value in sorted(options.items())
              if value is not None and value is not False]
    return "-".join([*map(text, parts), *values]).replace("/", "_").replace(", ", "-").replace(" ", "-").replace(",", "_")


@dataclasses.dataclass(frozen=True)
class SceneFiles:
    """A scene, its region, and the job that makes both, if it takes one."""
    name: str
    obj: str
    region: str
    job: Job | None = None

    @property
    def needs(self):
        return (self.job,) if self.job else ()


def room(detail):
    """One of the two living rooms."""
    job = Job(key_of("scene", detail), "scene", ("generate", "living-room", "--detail", detail, "-o", "{folder}/scene.obj"))
    return SceneFiles(detail, f"{{{job.key}}}/scene.obj", f"{{{job.key}}}/scene.region.json", job)


def gallery(name, corners, height=2):
    """An extruded floor plan: corners as "x y x y ...", holes after a "|"."""
    job = Job(key_of("scene-gallery", name), "scene",
              ("gallery.py", "{folder}", text(height), *(f"{word}" for word in corners.split())), script=True)
    return SceneFiles(name, f"{{{job.key}}}/scene.obj", f"{{{job.key}}}/scene.region.json", job)


def file_scene(folder, name):
    """A scene of others, SCENE.obj with SCENE.region.json beside it."""
    return SceneFiles(name, f"{folder}/{name}.obj", f"{folder}/{name}.region.json")


def rooms(count, detail):
    """Living rooms in a row, doors open between them."""
    job = Job(key_of("scene-rooms", count, detail), "scene", ("generate", "rooms", "--rooms", text(count), "--detail", detail, "-o", "{folder}/scene.obj"))
    return SceneFiles(f"{count} rooms, {detail}", f"{{{job.key}}}/scene.obj", f"{{{job.key}}}/scene.region.json", job)


def found_region(scene, **options):
    """The scene with the free space at one height as region."""
    job = Job(key_of("region", scene.name, **options), "region",
              ("region", scene.obj, *option_words(options), "-o", "{folder}/scene.region.json", "--quiet"), scene.needs, 1,
              (("scene", scene.name), *options.items()))
    return SceneFiles(f"{scene.name}, found region", scene.obj, f"{{{job.key}}}/scene.region.json", job)


def inspect(scene, **options):
    """Size, repairs, pieces and cracks of a scene."""
    return Job(key_of("inspect", scene.name, **options), "inspect", ("inspect", scene.obj, *option_words(options), "--quiet"), scene.needs, 1,
               (("scene", scene.name), *options.items()))


def solve(scene, *, backend="exact", regions=64, seed=1, threads=1, **options):
    """A whole run; its bundle is the job's folder + "/bundle"."""
    asked = {"backend": backend, "regions": regions, **options}
    words = ("solve", scene.obj, "--region", scene.region, "-o", "{folder}/bundle", *option_words(asked), "--seed", text(seed), "--threads",
             text(threads), "--quiet")
    return Job(key_of("solve", scene.name, **asked, seed=seed), "solve", words, scene.needs, seed,
               (("scene", scene.name), *asked.items()), threads)


def bundle(job):
    return f"{{{job.key}}}/bundle"


def cover(run, *, method="exact", seed=1, **options):
    """A cover of the visibility matrix of a run; if exact, with its proof."""
    proof = ("--proof", "{folder}/cover.proof") if method == "exact" else ()
    words = ("cover", bundle(run) + "/visibility.mtx", "--method", method, *option_words(options), *proof, "--seed", text(seed), "--threads",
             "1", "--quiet")
    return Job(key_of("cover", method, **options, seed=seed) + "@" + run.key, "cover", words, (run,), seed,
               (*run.labels, ("method", method), *options.items()))


def proof(exact_cover):
    """Whether the proof of an exact cover holds."""
    run, = exact_cover.needs
    return Job("proof-" + exact_cover.key, "proof", ("check_proof.py", bundle(run) + "/visibility.mtx", f"{{{exact_cover.key}}}/cover.proof"),
               (exact_cover, run), exact_cover.seed, exact_cover.labels, script=True)


def compare(judged, reference):
    return Job(f"compare-{judged.key}@{reference.key}", "compare",
               ("compare", bundle(judged), bundle(reference), "--quiet"), (judged, reference), judged.seed, judged.labels)


def audit(run):
    return Job(f"audit@{run.key}", "audit", ("audit", bundle(run), "--threads", "1", "--quiet"), (run,), run.seed, run.labels)


def verify(run, after=()):
    """Whether what the bundle of a run claims holds, with what the jobs `after` have added to it."""
    return Job(f"verify@{run.key}", "verify", ("verify", bundle(run), "--quiet"), (run, *after), run.seed, run.labels)


def picture(run, name, **options):
    """A picture of a run, as the job's folder + "/figure.png"."""
    return Job(key_of("picture", name, **options) + "@" + run.key, "picture", ("show", bundle(run), *option_words({"no_page": True, **options})),
               (run,), run.seed, (*run.labels, ("picture", name)))

