#!/usr/bin/env python3
"""Interpolates meshes like those of the similarity paper by its method and by ours, with pictures.

usage: similarity.py SURPASS DATA OUTPUT

Similarity based interpolation using Catmull-Clark subdivision surfaces (Lai, Cheng 2006): its times and
pictures like its figures 2, 3 and 4. Writes OUTPUT/similarity.md. Exits with 1 where a surface does not
interpolate.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from real_meshes import folder_or_skip

# name, mesh, what the paper says of the mesh of its own that is nearest in size, and how it is drawn
MODELS = [
    ("Teapot", "quad/paper_teapot_138_128_4open.obj", "138 vertices, under 1 s", ["--up", "z", "--camera", "35,25"]),
    ("Hose", "tri/closed_hose_370.obj", "354 vertices, 4 s", None),
    ("Cubespikes", "quad/closed_cubespikes_1194.obj", "1,022 vertices, 51 s", ["--camera", "30,25"]),
    ("Bigguy", "quad/closed_bigguy_1452.obj", "1,022 vertices, 51 s", None),
]
FORMS = [
    ("directions", ["--method", "similarity", "--similarity", "directions", "--row-weights", "none"]),
    ("vectors", ["--method", "similarity"]),
    ("fair", ["--method", "fair"]),
]

RUNS = 20

# The paper's figure 3: a glass, with and without what its rim shall do.
GLASS = [
    ("by boundary rules", "rules", ["--open", "boundary-rules"]),
    ("in a dummy ring", "ring", ["--open", "dummy-ring"]),
    ("by boundary rules, its rim asked to end upright", "rules-rim", ["--open", "boundary-rules", "--requirements"]),
    ("in a dummy ring, its rim asked to end upright", "ring-rim", ["--open", "dummy-ring", "--requirements"]),
]
GLASS_VIEW = ["--up", "z", "--camera", "20,25"]

HEAD = """# Similarity-based interpolation: the paper's sizes, measured again

Written by `make papers`. S. Lai, F. Cheng, *Similarity based interpolation using Catmull-Clark subdivision
surfaces*, The Visual Computer 22, 2006. The teapot is the paper's: one mesh of four open parts, 138 vertices and
128 faces. Its other meshes are not published; beside each of ours stands what the paper reports for the nearest of
its own, on a PC of 3.2 GHz of its day, so the times are no comparison of methods. `directions` is the paper's form
with its weights (`--row-weights none`), `vectors` the default here, `fair` thin-plate fairing; all with boundary rule
edge-and-corner, and the glass with the paper's ring of dummy faces as well; to the paper's 1e-2. Seconds are
for set-up and solution, the least of twenty runs on one thread (too high where other work shares the machine); errors are
relative to the box side.

| mesh | vertices | faces | form | iterations | error | seconds | the paper |
|---|--:|--:|---|--:|--:|--:|---|
"""


def interpolate(surpass, mesh, options, folder):
    """The control mesh, the last report, and the least seconds of several runs."""
    control, report = folder / "control.obj", folder / "report.json"
    seconds = []
    for _ in range(RUNS):
        subprocess.run([surpass, "interpolate", mesh, "-o", control, "--scheme", "catmull-clark", "--threads", "1",
                        "--report", report, "--quiet", *options], check=True)
        found = json.loads(report.read_text())
        seconds.append(found["seconds"]["topology"] + found["seconds"]["solve"])
    return control, found, min(seconds)


def write_glass(folder, around=8):
    """A glass that is open at the top, as a mesh, and the directions that make its rim upright."""
    profile = [(0.6, 0.0), (0.52, 0.05), (0.1, 0.14), (0.08, 0.5), (0.1, 0.75), (0.38, 0.95), (0.55, 1.25),
               (0.56, 1.5), (0.46, 1.8)]
    lines = ["v 0 0 0"]
    for radius, height in profile:
        for k in range(around):
            angle = 2 * math.pi * k / around
            lines.append(f"v {radius * math.cos(angle)} {radius * math.sin(angle)} {height}")

    def at(ring, k):
        return 2 + ring * around + k % around

    lines += [f"f 1 {at(0, k + 1)} {at(0, k)}" for k in range(around)]
    for ring in range(len(profile) - 1):
        lines += [f"f {at(ring, k)} {at(ring, k + 1)} {at(ring + 1, k + 1)} {at(ring + 1, k)}" for k in range(around)]
    mesh, rim = folder / "glass.obj", folder / "rim.json"
    mesh.write_text("\n".join(lines) + "\n")
    last = len(profile) - 1
    rim.write_text(json.dumps({"requirements": [
        {"vertex": at(last, k) - 1, "towards": at(last - 1, k) - 1, "direction": [0, 0, -1]} for k in range(around)]}))
    return mesh, rim


def glass(surpass, folder, output):
    """Rows, pictures, and whether all surfaces interpolate and meet what was asked."""
    mesh, rim = write_glass(folder)
    limit = "similarity-glass-limit.png"
    draw(surpass, mesh, mesh, 3, output / limit, GLASS_VIEW)
    rows, pictures, right = [], [f"![Glass, its limit surface]({limit})"], True
    for title, name, options in GLASS:
        asked = options + [rim] if options[-1] == "--requirements" else options
        control, found, seconds = interpolate(surpass, mesh, ["--method", "similarity", *asked], folder)
        right &= found["error"]["max"] <= 1e-12
        right &= all(r["error"] <= 1e-10 and not r["flipped"] for r in found["similarity"].get("requirements", []))
        rows.append(f"| Glass, {title} | {found['input']['vertices']} | {found['input']['faces']} | vectors | "
                    f"{found['iterations']} | {found['error']['max']:.1e} | {seconds:.4f} | \"almost in real time\" |")
        picture = f"similarity-glass-{name}.png"
        draw(surpass, mesh, control, 2, output / picture, GLASS_VIEW)
        pictures.append(f"![Glass, {title}]({picture})")
    return rows, pictures, right


def draw(surpass, mesh, control, levels, picture, view):
    subprocess.run([surpass, "render", control, "--scheme", "catmull-clark", "--levels", str(levels), "--beside", mesh,
                    "--points", mesh, "-o", picture, "--size", "560x560", "--quiet", *view], check=True)


def main():
    surpass, output = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    data = folder_or_skip(sys.argv[2], len(MODELS) * len(FORMS), "Similarity")
    output.mkdir(parents=True, exist_ok=True)
    rows, pictures, right = [], [], True
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for title, file, paper, view in MODELS:
            mesh = data / file
            if view:
                limit = f"similarity-{title.lower()}-limit.png"
                draw(surpass, mesh, mesh, 3, output / limit, view)
                pictures.append(f"![{title}, its limit surface]({limit})")
            for form, options in FORMS:
                control, found, seconds = interpolate(surpass, mesh, options, folder)
                right &= found["error"]["max"] <= 1e-12
                rows.append(f"| {title} | {found['input']['vertices']} | {found['input']['faces']} | {form} | "
                            f"{found['iterations']} | {found['error']['max']:.1e} | {seconds:.4f} | {paper} |")
                if view:
                    picture = f"similarity-{title.lower()}-{form}.png"
                    draw(surpass, mesh, control, 2, output / picture, view)
                    pictures.append(f"![{title}, {form}]({picture})")
        glass_rows, glass_pictures, glass_right = glass(surpass, folder, output)
        rows, pictures, right = rows + glass_rows, pictures + glass_pictures, right and glass_right
    print("\n".join(rows))
    (output / "similarity.md").write_text(
        HEAD + "\n".join(rows) + "\n\n## Pictures\nLeft the given mesh; right its limit surface, which misses the given "
        "vertices (red), then the interpolating surfaces.\n\n" + "\n".join(pictures) + "\n")
    sys.exit(0 if right else 1)


if __name__ == "__main__":
    main()
