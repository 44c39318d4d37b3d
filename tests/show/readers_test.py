#!/usr/bin/env python3
"""Reads a bundle with hostile names of groups with pandas and VTK's own reader.

readers_test.py VIEWCOVER: exit code 0, 1 where a reader finds something else, 77 where neither is
installed.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
NAMES = ['</script><script>alert(1)</script>', 'say "it\'s", \\ & so on', "Wände ✓ 部屋", "a,b", "]]>", "&lt;"]
GROUPS = 10000


def write_scene(folder):
    """GROUPS triangles on a grid, each a group of its own, and a region above them."""
    names, lines = [], []
    for i in range(GROUPS):
        x, y = i % 100 / 25, i // 100 / 25
        names.append(f"{NAMES[i % len(NAMES)]} {i}")
        lines += [f"v {x} {y} 0", f"v {x + 0.03125} {y} 0", f"v {x} {y + 0.03125} 0", f"g {names[-1]}",
                  f"f {3 * i + 1} {3 * i + 2} {3 * i + 3}"]
    (folder / "scene.obj").write_text("\n".join(lines) + "\n", encoding="utf-8")
    (folder / "scene.region.json").write_text('{"polygons": [[[1,1,2],[3,1,2],[3,3,2],[1,3,2]]]}', encoding="ascii")
    return names


def check_pandas(pandas, bundle, names):
    elements = pandas.read_csv(bundle / "elements.csv")
    assert list(elements["group"]) == names, "pandas reads other groups from elements.csv"
    assert len(pandas.read_csv(bundle / "regions.csv")) == 1
    print(f"holds: pandas reads {GROUPS} groups from elements.csv as they are")


def check_vtk(reader_class, bundle, names):
    reader = reader_class()
    reader.SetFileName(str(bundle / "scene.vtp"))
    reader.Update()
    data = reader.GetOutput()
    assert data.GetNumberOfCells() == GROUPS + 1, f"{data.GetNumberOfCells()} cells in scene.vtp"
    for name in ("times_visible", "covered_by", "surface", "group"):
        assert data.GetCellData().GetArray(name) is not None, f"scene.vtp has no array {name}"
    found = data.GetFieldData().GetAbstractArray("group_names")
    assert [found.GetValue(i) for i in range(found.GetNumberOfValues())] == names, "VTK reads other names"
    print(f"holds: VTK reads scene.vtp, its arrays and {GROUPS} names of groups as they are")


def main():
    try:
        import pandas
    except ImportError:
        pandas = None
        print("pandas is not installed: elements.csv not opened in it")
    try:
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    except ImportError:
        vtkXMLPolyDataReader = None
        print("python3-vtk9 is not installed: scene.vtp not opened in VTK")
    if pandas is None and vtkXMLPolyDataReader is None:
        print("skipped: needs pandas or python3-vtk9")
        return SKIPPED
    with tempfile.TemporaryDirectory(prefix="viewcover-readers-") as name:
        folder = Path(name)
        names = write_scene(folder)
        subprocess.run([sys.argv[1], "solve", folder / "scene.obj", "--region", folder / "scene.region.json", "--backend", "rays", "--regions", "1",
                        "--viewpoints", "none", "--element-area", "1", "--allow-outside", "-o", folder / "bundle"],
                       check=True, stdout=subprocess.DEVNULL)
        if pandas is not None:
            check_pandas(pandas, folder / "bundle", names)
        if vtkXMLPolyDataReader is not None:
            check_vtk(vtkXMLPolyDataReader, folder / "bundle", names)
    return 0


if __name__ == "__main__":
    sys.exit(main())
