#!/usr/bin/env python3
"""Compares the methods of interpolation on ten real meshes and writes docs/comparison.md.

usage: compare_methods.py SURPASS DATA DOCS [--head-only] [--methods plain,fair]

Rule and measures stand in HEAD; they were written down before any interpolating surface was measured. --head-only
writes them with the names of the meshes and nothing else.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from real_meshes import folder_or_skip

FOLDERS = ("quad", "tri")
EACH = 5
LEVELS = 4
READING = "## What each is good for"
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
written down before any interpolating surface was measured, and every number found is below, whoever it speaks for.

**Meshes.** From the collection's CATALOG.tsv, of the folders `quad` and `tri` each: meshes that load, are
manifold, oriented, of one component, without isolated, doubled or degenerate elements, of 300 to
5000 vertices, and no regression shape of OpenSubdiv (`osd_*`), for these are made up; sorted by path; of
the n that remain those with the numbers k n / 5, rounded down, k = 0 to 4. Triangles are polygons, too: all
are interpolated by Catmull-Clark surfaces, with boundary rule edge-and-corner.

**Methods**, each with its default options: {methods}.

**Measures**, all free of scale, less is better, by `surpass quality --levels {levels}` with the two rings
around extraordinary samples that it leaves out by default ([definitions](command-line.md#fairness)):
bending, bending without the sharpest hundredth of the area, thin plate (relative), curvature
variation (relative), total variation, largest curvature and 99 % curvature (relative), and the angle
between the normals and those of the Catmull-Clark surface of the given mesh itself, mean and rms in
degrees. Levels are those of the given mesh; a control mesh that
is refined once has one less, so all have the same samples. Time is what `interpolate --report` says for solving
with its setup, on one thread of the machine named below.

A method that refuses a mesh, because there is no such surface or it is not reached, is a dash.

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


def interpolate(surpass, given, control, options):
    """The report, or None with the sentence of the refusal."""
    report = control.with_suffix(".json")
    run = subprocess.run([surpass, "interpolate", given, "-o", control, "--scheme", "catmull-clark",
                          "--boundary", "edge-and-corner", "--threads", "1", "--report", report, "--force",
                          "--quiet", *options], capture_output=True, text=True)
    if run.returncode in (3, 4):
        return None, json.loads(report.read_text())["failure"]["message"]
    if run.returncode != 0:
        sys.exit(f"interpolate {given} {options}: {run.stderr}")
    return json.loads(report.read_text()), ""


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
    """Per method: dict of measures and seconds, or None; and the refusals."""
    found, refusals, controls = {}, {}, {}
    for name, _, options in METHODS:
        control = folder / f"{given.stem}.{name}.ply"
        report, refusal = interpolate(surpass, given, control, options)
        if report is None:
            refusals[name] = refusal
        else:
            controls[name] = control
            found[name] = {"seconds": seconds(report)}
    # The coarsest mesh of a comparison sets the levels: the given mesh is always among them.
    surfaces = measured(surpass, given, [given, *controls.values()])[1:]
    for name, surface in zip(controls, surfaces):
        found[name].update({m: value_at(surface, keys) for m, keys in MEASURES})
        found[name]["left out"] = surface["coverage"]["left_out"]
    return found, refusals, controls


def table(found, refusals):
    names = [name for name, _, _ in METHODS]
    lines = ["| measure | " + " | ".join(names) + " |", "|---|" + "---:|" * len(names)]
    for measure in [m for m, _ in MEASURES] + ["seconds"]:
        values = [found[n][measure] if n in found else None for n in names]
        least = min(v for v in values if v is not None)
        cells = ["-" if v is None else f"**{v:.4g}**" if v == least else f"{v:.4g}" for v in values]
        lines.append(f"| {measure} | " + " | ".join(cells) + " |")
    lines += ["", *(f"`{name}`: {text}" for name, text in refusals.items())]
    return "\n".join(lines).rstrip() + "\n"


def summary(results):
    """How often each was best, and the mean ratio to plain where both exist."""
    names = [name for name, _, _ in METHODS]
    lines = ["| measure | " + " | ".join(names) + " |", "|---|" + "---:|" * len(names)]
    for measure in [m for m, _ in MEASURES] + ["seconds"]:
        cells = []
        for name in names:
            best = sum(1 for r in results
                       if name in r and r[name][measure] <= min(other[measure] for other in r.values()))
            ratios = [math.log(r[name][measure] / r["plain"][measure]) for r in results
                      if name in r and "plain" in r]
            mean = f"{math.exp(sum(ratios) / len(ratios)):.3f}" if ratios else "-"
            cells.append(f"{mean} ({best})")
        lines.append(f"| {measure} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def draw(surpass, control, picture):
    picture.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run([surpass, "render", control, "-o", picture, "--levels", "3", "--size", "360x270",
                    "--scheme", "catmull-clark", "--style", "reflection", "--quiet"], check=True)


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
    parser.add_argument("--head-only", action="store_true")
    parser.add_argument("--methods", type=lambda names: names.split(","),
                        help="only these: to try the script, the page wants all of them")
    arguments = parser.parse_args()
    arguments.data = folder_or_skip(arguments.data, len(FOLDERS) * EACH, "Comparison of methods")
    if arguments.methods:
        METHODS[:] = [m for m in METHODS if m[0] in arguments.methods]
    meshes = [arguments.data / path for path in chosen(arguments.data)]
    methods = ", ".join(f"`{name}` ({what})" for name, what, _ in METHODS)
    text = HEAD.format(methods=methods, levels=LEVELS)
    for mesh in meshes:
        vertices, faces = counts(mesh)
        text += f"| {mesh.parent.name}/{mesh.name} | {vertices} | {faces} |\n"
    page = arguments.docs / "comparison.md"
    reading = kept(page)
    text += "\nThe measurements are still to be made.\n" if arguments.head_only else body(arguments, meshes, reading)
    page.write_text(text)


def kept(page):
    """The section that people write, which a new run must not lose."""
    text = page.read_text() if page.exists() else ""
    begin = text.find(READING)
    return "\n" + text[begin:text.find("\n## ", begin) + 1].rstrip() + "\n" if begin >= 0 else ""


def body(arguments, meshes, reading):
    surpass, results, text = arguments.surpass.resolve(), [], ""
    with tempfile.TemporaryDirectory() as name:
        for mesh in meshes:
            print(mesh, file=sys.stderr)
            found, refusals, controls = one_mesh(surpass, mesh, pathlib.Path(name))
            results.append(found)
            text += f"\n## {mesh.parent.name}/{mesh.name}\n\n" + table(found, refusals)
            pictures = {m: pathlib.Path("images/comparison") / f"{mesh.stem}.{m}.png" for m in controls}
            for method, control in controls.items():
                draw(surpass, control, arguments.docs / pictures[method])
            text += "\n| " + " | ".join(pictures) + " |\n" + "|---" * len(pictures) + "|\n"
            text += "| " + " | ".join(f"![{m}]({p})" for m, p in pictures.items()) + " |\n"
            shares = {f"{100 * f['left out']:.1f}" for f in found.values()}
            text += f"\nLeft out: {' to '.join(sorted(shares, key=float))} % of the area.\n"
    head = f"""
## In all

The geometric mean over the meshes of each measure divided by that of `plain`, where both have a
surface, and in brackets on how many of the {len(meshes)} meshes the method has the least. Times on
{machine()}.

"""
    return head + summary(results) + reading + text


if __name__ == "__main__":
    main()
