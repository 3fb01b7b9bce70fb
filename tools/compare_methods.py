#!/usr/bin/env python3
"""Compares the methods of interpolation on ten real meshes and writes docs/comparison.md.

usage: compare_methods.py SURPASS DATA DOCS [--save FILE | --load FILE]

Rule and measures stand in HEAD; they were written down before any interpolating surface was measured. What the numbers
mean stands in comparison_text.py, which takes every number from them and checks what it says. Exits with 1, and leaves
the page as it was, where that no longer holds.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from comparison_text import LOOSE, STOPS, TIGHT, reading
from real_meshes import folder_or_skip

FOLDERS = ("quad", "tri")
EACH = 5
LEVELS = 4
RUNS = 5  # of which the fastest counts
METHODS = [
    # heading, what it is, options of `surpass interpolate`
    ("plain", "progressive interpolation", []),
    ("vectors", "similarity, equal derivative vectors", ["--method", "similarity", "--similarity", "vectors"]),
    ("directions", "similarity, equal derivative directions",
     ["--method", "similarity", "--similarity", "directions"]),
    ("fair", "thin plate with interpolation as a constraint", ["--method", "fair"]),
]
# heading, what `surpass quality` calls it: of all, less is better
MEASURES = [
    ("bending", ("bending",)),
    ("bending, trimmed", ("trimmed_bending",)),
    ("thin plate", ("thin_plate_relative",)),
    ("curvature variation", ("curvature_variation_relative",)),
    ("total variation", ("total_variation",)),
    ("largest curvature", ("largest_curvature_relative",)),
    ("99 % curvature", ("high_curvature_relative",)),
    ("normals, mean", ("normal_deviation", "mean")),
    ("normals, rms", ("normal_deviation", "rms")),
]

HEAD = """# Methods compared

Which surface through the given vertices is fairer? Ten meshes, every method of this version on
Catmull-Clark surfaces, nine measures and the time. The rule for the meshes and the measures were
written down before any interpolating surface was measured, and all that was measured by them is below, whoever it
speaks for.

**Meshes.** From the collection's CATALOG.tsv, of the folders `quad` and `tri` each: meshes that load, are
manifold, oriented, of one component, without isolated, doubled or degenerate elements, of 300 to
5000 vertices, and no regression shape of OpenSubdiv (`osd_*`), for these are made up; sorted by path; of
the n that remain those with the numbers k n / 5, rounded down, k = 0 to 4. Triangles are polygons, too: all
are interpolated by Catmull-Clark surfaces, with boundary rule edge-and-corner.

**Methods**, each with its default options: {methods}.

**The stop.** `vectors`, `directions` and `fair` iterate until the residual is a given part of what it was at the start.
By default, and in the similarity paper, that is {loose}; all is measured at {tight}, too (`--solver-tolerance {tight}`). The
surfaces interpolate at either. `plain` has no such stop. The second stop was added when results at the first were
known, of an earlier version that began its iterations otherwise; meshes and measures remained as they were.

**Measures**, all free of scale, less is better, by `surpass quality --levels {levels}` with the two rings
around extraordinary samples that it leaves out by default ([definitions](command-line.md#fairness)):
bending, bending without the sharpest hundredth of the area, thin plate (relative), curvature
variation (relative), total variation, largest curvature and 99 % curvature (relative), and the angle
between the normals and those of the Catmull-Clark surface of the given mesh itself, mean and rms in
degrees. Levels are those of the given mesh; a control mesh that
is refined once has one less, so all have the same samples. Time is what `interpolate --report` says for solving
with its set-up, on one thread of the machine named below, the least of {runs} runs (too high where other work shares
the machine). Iterations of `plain` are of another kind and cheaper. Pictures are of the surfaces at {loose}.

Every method has a surface on every mesh.

| mesh | vertices | faces |
|---|---:|---:|
"""


def chosen(data):
    rows = list(csv.DictReader((data / "CATALOG.tsv").open(), delimiter="\t"))
    meshes = []
    for folder in FOLDERS:
        fitting = sorted(r["path"] for r in rows if is_fitting(r, folder))
        meshes += [fitting[k * len(fitting) // EACH] for k in range(EACH)]
    return meshes


def is_fitting(row, folder):
    wanted = {"load": "ok", "manifold": "True", "oriented": "True", "components": "1", "isolated": "0",
              "dup_verts": "0", "degenerate(idx/zero-area)": "0/0"}
    place, name = row["path"].split("/", 1)
    return (place == folder and not name.startswith("osd_") and "public-test" in row["role"]
            and all(row[key] == value for key, value in wanted.items())
            and 300 <= int(row["V"]) <= 5000)


def counts(path):
    """Vertices and faces as the catalogue has them in the file's own lines."""
    for row in csv.DictReader((path.parent.parent / "CATALOG.tsv").open(), delimiter="\t"):
        if row["path"] == f"{path.parent.name}/{path.name}":
            return row["V"], row["F"]
    raise KeyError(path)


def stopped(name, stop):
    """Options of the stop, for those methods that have one."""
    return [] if name == "plain" else ["--solver-tolerance", stop]


def interpolate(surpass, given, control, options):
    """The report. A refusal ends the run: the page speaks of every method on every mesh."""
    report = control.with_suffix(".json")
    run = subprocess.run([surpass, "interpolate", given, "-o", control, "--scheme", "catmull-clark",
                          "--boundary", "edge-and-corner", "--threads", "1", "--report", report, "--force",
                          "--quiet", *options], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"interpolate {given} {options}: {run.stderr}")
    return json.loads(report.read_text())


def measured(surpass, given, controls):
    """Measures of each control mesh, in their order."""
    run = subprocess.run([surpass, "quality", *controls, "--reference", given, "--scheme", "catmull-clark",
                          "--boundary", "edge-and-corner", "--levels", str(LEVELS), "--report", "-", "--quiet"],
                         capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"quality of {given}: {run.stderr}")
    return json.loads(run.stdout)["surfaces"]


def value_at(tree, keys):
    for key in keys:
        tree = tree[key]
    return tree


def seconds(report):
    return sum(report["seconds"].get(stage, 0) for stage in ("topology", "solve"))


def one_mesh(surpass, given, folder):
    """Per stop and method the measures, and the control meshes."""
    found, controls = {stop: {} for stop in STOPS}, {}
    for name, _, options in METHODS:
        for stop in STOPS if name != "plain" else STOPS[:1]:
            control = folder / f"{given.stem}.{name}.{stop}.ply"
            reports = [interpolate(surpass, given, control, [*options, *stopped(name, stop)]) for _ in range(RUNS)]
            controls[stop, name] = control
            found[stop][name] = {"iterations": reports[0]["iterations"], "seconds": min(map(seconds, reports))}
    # The coarsest mesh of a comparison sets the levels: the given mesh is always among them.
    surfaces = measured(surpass, given, [given, *controls.values()])[1:]
    for (stop, name), surface in zip(controls, surfaces):
        found[stop][name].update({m: value_at(surface, keys) for m, keys in MEASURES})
        found[stop][name]["left out"] = surface["coverage"]["left_out"]
    found[TIGHT] = {"plain": found[LOOSE]["plain"], **found[TIGHT]}
    return found, controls


def head_of_table():
    names = [name for name, _, _ in METHODS]
    return ["| measure | " + " | ".join(names) + " |", "|---|" + "---:|" * len(names)]


def table(found):
    lines = head_of_table()
    for measure in [m for m, _ in MEASURES] + ["seconds"]:
        values = [found[name][measure] for name, _, _ in METHODS]
        cells = [f"**{v:.4g}**" if v == min(values) else f"{v:.4g}" for v in values]
        lines.append(f"| {measure} | " + " | ".join(cells) + " |")
    lines.append("| iterations | " + " | ".join(str(found[name]["iterations"]) for name, _, _ in METHODS) + " |")
    return "\n".join(lines) + "\n"


def summary(results):
    """How often each was best, and the mean ratio to plain, at one stop."""
    lines = head_of_table()
    for measure in [m for m, _ in MEASURES] + ["seconds"]:
        cells = []
        for name, _, _ in METHODS:
            best = sum(1 for r in results if r[name][measure] <= min(other[measure] for other in r.values()))
            ratios = [math.log(r[name][measure] / r["plain"][measure]) for r in results]
            cells.append(f"{math.exp(sum(ratios) / len(ratios)):.3f} ({best})")
        lines.append(f"| {measure} | " + " | ".join(cells) + " |")
    steps = [[r[name]["iterations"] for r in results] for name, _, _ in METHODS]
    lines.append("| iterations | " + " | ".join(f"{min(s)} to {max(s)}" for s in steps) + " |")
    return "\n".join(lines) + "\n"


def draw(surpass, controls, picture):
    """All from the same place, close enough to tell their lines apart, in two rows."""
    picture.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run([surpass, "render", *controls, "-o", picture, "--levels", "3", "--size", "360x270", "--columns", "2",
                    "--camera", "30,20,2.5", "--scheme", "catmull-clark", "--style", "reflection", "--quiet"], check=True)


def machine():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return "an unnamed machine"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("surpass", type=pathlib.Path)
    parser.add_argument("data")
    parser.add_argument("docs", type=pathlib.Path)
    parser.add_argument("--save", type=pathlib.Path, help="keep the numbers in this file")
    parser.add_argument("--load", type=pathlib.Path, help="a new text from the numbers in this file")
    arguments = parser.parse_args()
    arguments.data = folder_or_skip(arguments.data, len(FOLDERS) * EACH, "Comparison of methods")
    meshes = chosen(arguments.data)
    if arguments.load:
        kept = json.loads(arguments.load.read_text())
    else:
        kept = {"machine": machine(), "meshes": measure_all(arguments, meshes)}
    if arguments.save:
        arguments.save.write_text(json.dumps(kept))
    results = kept["meshes"]
    prose, failed = reading(results, [m for m, _ in MEASURES])
    if failed:
        sys.exit("docs/comparison.md is as it was: these claims of tools/comparison_text.py do not hold any more, and their "
                 "sentences have to be written anew:\n  " + "\n  ".join(failed))
    methods = ", ".join(f"`{name}` ({what})" for name, what, _ in METHODS)
    text = HEAD.format(methods=methods, levels=LEVELS, runs=RUNS, loose=LOOSE, tight=TIGHT)
    for mesh in meshes:
        text += f"| {mesh} | {' | '.join(counts(arguments.data / mesh))} |\n"
    text += in_all(results, kept["machine"]) + prose
    for mesh, found in results.items():
        text += section(mesh, found)
    (arguments.docs / "comparison.md").write_text(text)


def measure_all(arguments, meshes):
    """The numbers of each mesh; draws the pictures."""
    surpass, kept = arguments.surpass.resolve(), {}
    with tempfile.TemporaryDirectory() as name:
        for mesh in meshes:
            print(mesh, file=sys.stderr)
            kept[mesh], controls = one_mesh(surpass, arguments.data / mesh, pathlib.Path(name))
            draw(surpass, [controls[LOOSE, method] for method, _, _ in METHODS], arguments.docs / picture(mesh))
    return kept


def picture(mesh):
    return pathlib.Path("images/comparison") / f"{pathlib.Path(mesh).stem}.png"


def in_all(results, where):
    text = f"""
## In all

The geometric mean over the meshes of each measure divided by that of `plain`, and in brackets on how many of the
{len(results)} meshes the method has the least. Of iterations the fewest and the most.
Times on {where}.
"""
    for stop, which in zip(STOPS, ("the default", "`plain` is the same")):
        text += f"\nAt {stop}, {which}:\n\n" + summary([found[stop] for found in results.values()])
    return text


def section(mesh, found):
    text = f"\n## {mesh}\n"
    for stop in STOPS:
        text += f"\nAt {stop}:\n\n" + table(found[stop])
    names = [f"`{method}`" for method, _, _ in METHODS]
    text += f"\nReflection lines on a part of each, stopped at {LOOSE}: "
    text += f"{' and '.join(names[:2])} above, {' and '.join(names[2:])} below.\n"
    text += f"\n![Reflection lines of all methods on {pathlib.Path(mesh).stem}]({picture(mesh)})\n"
    shares = {f"{100 * f['left out']:.1f}" for stop in STOPS for f in found[stop].values()}
    shares = sorted(shares, key=float)
    return text + f"\nLeft out: {' to '.join(dict.fromkeys((shares[0], shares[-1])))} % of the area.\n"


if __name__ == "__main__":
    main()
