#!/usr/bin/env python3
"""Drives report.html in a headless browser and compares what it shows with the bundle's files.

page_test.py VIEWCOVER: exit code 0, 1 where the page is wrong, 77 where no browser is installed.
The browser runs a script appended to the page, which acts as a user does (mouse, keys, inputs) and
leaves what it saw as JSON in the document.
"""
import csv
import html
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
HOSTILE = ['</script><script>window.injected=1</script>', '<img src=x onerror="window.injected=2">',
           'say "it\'s", \\ & so on', 'Wände ✓ 部屋']

# Before the page's own scripts: all complaints are kept.
WATCH = """<script>
window.complaints = [];
window.onerror = (message) => { window.complaints.push(String(message)); };
for (const kind of ['error', 'warn']) {
  console[kind] = (...all) => window.complaints.push(kind + ': ' + all.join(' '));
}
</script>"""

DRIVE = """
const finish = () => { const gl = view.renderer.getContext(); gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4)); };
view.drawNow();
finish();
const outcome = {first_picture: performance.now(), picks: [], sets: [], frames: []};
const canvas = $('canvas'), box = canvas.getBoundingClientRect();
const at = (x, y) => ({clientX: box.left + x, clientY: box.top + y, bubbles: true, cancelable: true, button: 0});
const click = (x, y, shift) => {
  for (const kind of ['mousedown', 'mouseup', 'click']) canvas.dispatchEvent(new MouseEvent(kind, {...at(x, y), shiftKey: shift}));
};
const key = (name, target) => target.dispatchEvent(new KeyboardEvent('keydown', {key: name, bubbles: true, cancelable: true}));
const eye = () => view.camera.position.toArray();

outcome.pixels = new Set();
const gl = view.renderer.getContext(), row = new Uint8Array(4 * gl.drawingBufferWidth);
view.drawNow();
for (let y = 0; y < gl.drawingBufferHeight; y += 8) {
  gl.readPixels(0, y, gl.drawingBufferWidth, 1, gl.RGBA, gl.UNSIGNED_BYTE, row);
  for (let i = 0; i < row.length; i += 4) outcome.pixels.add(row[i] << 16 | row[i + 1] << 8 | row[i + 2]);
}
outcome.pixels = outcome.pixels.size;

outcome.start = eye();
key('ArrowLeft', canvas);
outcome.by_key = eye();
canvas.dispatchEvent(new MouseEvent('mousedown', at(300, 300)));
document.dispatchEvent(new MouseEvent('mousemove', at(380, 320)));
document.dispatchEvent(new MouseEvent('mouseup', at(380, 320)));
outcome.by_mouse = eye();
key('0', document.body);
outcome.home = eye();

for (let y = 0.2; y < 0.95; y += 0.05) {
  for (let x = 0.1; x < 0.95; x += 0.05) {
    click(x * box.width, y * box.height, false);
    if (!state.picked || state.picked.kind !== 'element') continue;
    outcome.picks.push([state.picked.index, Number($('times-visible').dataset.value), $('times-visible').textContent, $('picked-group').textContent]);
  }
}
click(0.5 * box.width, 0.55 * box.height, true);
outcome.region = state.picked && state.picked.kind;
outcome.region_text = $('selection').textContent;
key('Escape', document.body);
outcome.cleared = state.picked === null;

for (let k = 1; k <= run.covers.length; ++k) {
  $('k').value = k;
  $('k').dispatchEvent(new Event('input', {bubbles: true}));
  outcome.sets.push([chosen().map((r) => r + 1), $('k-text').textContent, [...$('selection').querySelectorAll('.chosen')].length]);
}
outcome.difference = $('summary').textContent;
outcome.rows = $('hidden-list').querySelectorAll('tr.pick').length;
document.querySelector('#hidden-list tr.pick')?.click();
outcome.unseen = state.picked && state.picked.index;

for (let i = 0; i < 9; ++i) {
  const start = performance.now();
  view.turn(0.1, 0);
  view.drawNow();
  finish();
  outcome.frames.push(performance.now() - start);
}
{
  const start = performance.now();
  setMode(state.mode === 'group' ? 'unseen' : 'group');
  outcome.recolour = performance.now() - start;
}
outcome.elements = counts.element;
outcome.groups = run.groups;
outcome.injected = window.injected;
outcome.complaints = window.complaints;
const text = document.createElement('pre');
text.id = 'outcome';
text.textContent = JSON.stringify(outcome);
document.documentElement.replaceChildren(text);
"""

failures = []


def check(claim, holds, detail=""):
    print(("holds: " if holds else "NOT TRUE: ") + claim + ("" if holds else f" ({detail})"))
    if not holds:
        failures.append(claim)


def drive(browser, page, folder):
    """What the script saw in the page."""
    text = page.read_text(encoding="utf-8")
    text = text.replace("<head>", "<head>" + WATCH, 1)
    end = text.rindex("</body>")
    driven = folder / ("driven-" + page.parent.name + ".html")
    driven.write_text(text[:end] + "<script>" + DRIVE + "</script>" + text[end:], encoding="utf-8")
    command = [browser, "--headless", "--no-sandbox", "--disable-dev-shm-usage", "--use-angle=swiftshader",
               "--enable-unsafe-swiftshader", "--disable-background-networking", "--no-first-run", "--window-size=1366,768",
               f"--user-data-dir={folder}/profile", "--dump-dom", driven.as_uri()]
    ended = subprocess.run(command, capture_output=True, text=True, timeout=120, check=False)
    found = re.search(r'<pre id="outcome">(.*?)</pre>', ended.stdout, re.S)
    if not found:
        complaints = re.findall(r"window.complaints.*", ended.stdout)[:3]
        raise SystemExit(f"NOT TRUE: the page runs to its end: {ended.stderr[-2000:]} {complaints}")
    return json.loads(html.unescape(found.group(1)))


def rows_of(file):
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def seen_pairs(file):
    """Rows by column of a Matrix Market file, numbers from 1."""
    rows = {}
    with open(file, encoding="ascii") as stream:
        lines = [line for line in stream if not line.startswith("%")]
    for line in lines[1:]:
        row, column = map(int, line.split()[:2])
        rows.setdefault(column, set()).add(row)
    return rows


def missed_pieces(first, second):
    """Pieces of the common refinement that a region sees in the first bundle only."""
    def nodes(folder):
        seen = seen_pairs(folder / "visibility.mtx")
        return {(int(r["surface"]), int(r["level"]), int(r["path"])): seen.get(i + 1, set())
                for i, r in enumerate(rows_of(folder / "elements.csv"))}

    def above(node, tree):
        surface, level, path = node
        while level >= 0:
            if (surface, level, path) in tree:
                return tree[(surface, level, path)]
            level, path = level - 1, path >> 2
        return None

    a, b = nodes(first), nodes(second)
    pieces = {n for n in a if above(n, b) is not None} | {n for n in b if above(n, a) is not None}
    return sum(1 for n in pieces if above(n, a) - above(n, b))


def check_common(name, saw):
    check(f"{name}: no complaint on the console", saw["complaints"] == [], saw["complaints"])
    check(f"{name}: the scene is drawn", saw["pixels"] > 20, saw["pixels"])
    check(f"{name}: a key turns the scene", saw["start"] != saw["by_key"])
    check(f"{name}: the mouse turns the scene", saw["by_key"] != saw["by_mouse"])
    check(f"{name}: 0 goes home", all(abs(a - b) < 1e-6 for a, b in zip(saw["start"], saw["home"])), saw["home"])
    frames = sorted(saw["frames"])
    print(f"{name}: {saw['elements']} elements, first picture after {saw['first_picture']:.0f} ms, a frame in "
          f"{frames[len(frames) // 2]:.1f} ms (median of {len(frames)}), all colours anew in {saw['recolour']:.1f} ms")


def check_picks(name, saw, folder):
    elements = rows_of(folder / "elements.csv")
    picked = {index for index, *_ in saw["picks"]}
    check(f"{name}: clicks pick elements", len(picked) >= 3, picked)
    wrong = [p for p in saw["picks"] if p[1] != int(elements[p[0]]["times_visible"])
             or not p[2].startswith(f"{p[1]} of ") or p[3] != (elements[p[0]]["group"] or "(no name)")]
    check(f"{name}: {len(picked)} picked elements show times_visible and group of elements.csv", not wrong, wrong[:3])


def check_sets(name, saw, folder):
    cover = rows_of(folder / "cover.csv")
    check(f"{name}: the slider has a place for each line of cover.csv", len(saw["sets"]) == len(cover), saw["sets"])
    for line, (chosen, text, _) in zip(cover, saw["sets"]):
        percent = float(re.search(r": ([\d.]+) %", text).group(1))
        holds = chosen == list(map(int, line["regions"].split())) and abs(percent - float(line["covered_area_percent"])) < 0.006
        check(f"{name}: k = {line['k']} shows its set and coverage", holds, (chosen, text, line))


def main():
    viewcover = sys.argv[1]
    browser = os.environ.get("VIEWCOVER_BROWSER") or next(filter(None, map(shutil.which, BROWSERS)), None)
    if not browser:
        print("skipped: no browser is installed (scripts/setup --browser installs one)")
        return SKIPPED

    def run(*arguments):
        subprocess.run([viewcover, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)

    with tempfile.TemporaryDirectory(prefix="viewcover-page-") as name:
        folder = Path(name)
        room = folder / "room.obj"
        run("generate", "living-room", "-o", room)
        solve = ("solve", room, "--region", folder / "room.region.json", "--backend", "rays", "--regions", 16)
        run(*solve, "--rays", 64, "-o", folder / "many")
        run(*solve, "--rays", 1, "-o", folder / "few", "--viewpoints", "none")
        run("show", folder / "many", "--against", folder / "few", "--size", "200x150")
        saw = drive(browser, folder / "many" / "report.html", folder)
        check_common("room", saw)
        check_picks("room", saw, folder / "many")
        check_sets("room", saw, folder / "many")
        check("room: shift and click pick a region", saw["region"] == "region", saw["region_text"])
        check("room: Escape clears", saw["cleared"])
        expected = missed_pieces(folder / "many", folder / "few")
        shown = re.search(r": ([\d ]+) pieces with missed regions", saw["difference"])
        check(f"room: {expected} pieces are missed by some region in the other run",
              expected > 0 and shown and int(shown.group(1).replace(" ", "")) == expected, saw["difference"])
        hidden = rows_of(folder / "many" / "elements.csv")
        check("room: the first of the unseen is unseen", saw["rows"] > 0 and hidden[saw["unseen"]]["times_visible"] == "0", saw["unseen"])

        # The figures of the paper's larger room, with the regions that its page is to be quick for.
        complex_room = folder / "complex.obj"
        run("generate", "living-room", "--detail", "complex", "-o", complex_room)
        run("solve", complex_room, "--region", folder / "complex.region.json", "--regions", 256, "--viewpoints", "none", "-o", folder / "complex")
        run("show", folder / "complex", "--size", "200x150")
        megabytes = (folder / "complex" / "report.html").stat().st_size / 1e6
        check("room of 1228 polygons: the page is small", megabytes < 25, megabytes)
        print(f"room of 1228 polygons: page of {megabytes:.1f} MB")
        saw = drive(browser, folder / "complex" / "report.html", folder)
        check_common("room of 1228 polygons", saw)
        check_sets("room of 1228 polygons", saw, folder / "complex")

        soup = folder / "soup.obj"
        run("generate", "soup", "--triangles", 20000, "-o", soup)
        run("solve", soup, "--region", folder / "soup.region.json", "--backend", "rays", "--rays", 1, "--regions", 16, "--optimizer", "greedy",
            "--viewpoints", "none", "--element-area", 1e9, "-o", folder / "soup")
        run("show", folder / "soup", "--size", "200x150")
        saw = drive(browser, folder / "soup" / "report.html", folder)
        check_common("soup", saw)

        lines = ["v 0 0 0", "v 4 0 0", "v 4 4 0", "v 0 4 0"]
        region = {"polygons": [[[1, 1, 2], [3, 1, 2], [3, 3, 2], [1, 3, 2]]]}
        for i in range(10000):
            x, y = i % 100 / 25, i // 100 / 25
            lines += [f"v {x} {y} 0", f"v {x + 0.03125} {y} 0", f"v {x} {y + 0.03125} 0",
                      f"g {HOSTILE[i % 4]} {i}", f"f {4 + 3 * i + 1} {4 + 3 * i + 2} {4 + 3 * i + 3}"]
        (folder / "hostile.obj").write_text("\n".join(lines) + "\n", encoding="utf-8")
        (folder / "hostile.region.json").write_text(json.dumps(region), encoding="ascii")
        run("solve", folder / "hostile.obj", "--region", folder / "hostile.region.json", "--backend", "rays", "--regions", 1,
            "--viewpoints", "none", "--element-area", 1, "--allow-outside", "-o", folder / "hostile")
        run("show", folder / "hostile", "--size", "200x150", "--view", "270,70")
        saw = drive(browser, folder / "hostile" / "report.html", folder)
        check_common("hostile names", saw)
        check_picks("hostile names", saw, folder / "hostile")
        check("hostile names: 10,000 groups arrive as they are", len(saw["groups"]) >= 10000 and
              all(any(g.startswith(h) for g in saw["groups"]) for h in HOSTILE), saw["groups"][:5])
        check("hostile names: nothing is injected", "injected" not in saw, saw.get("injected"))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
