#!/usr/bin/env python3
"""Interpolates meshes like those of the similarity paper by its method and by ours, with pictures.

usage: similarity.py SURPASS DATA OUTPUT

Similarity based interpolation using Catmull-Clark subdivision surfaces (Lai, Cheng 2006): its times and
pictures like its figures 2, 3 and 4. Writes OUTPUT/similarity.md. Exits with 1 where a surface does not
interpolate.
"""
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from real_meshes import folder_or_skip

TEAPOT = "quad/paper_teapot_138_128_4open.obj"
# name, mesh, and what the paper says of the mesh of its own that is nearest in size
MODELS = [
    ("Teapot", TEAPOT, "138 vertices, under 1 s"),
    ("Hose", "tri/closed_hose_370.obj", "354 vertices, 4 s"),
    ("Cubespikes", "quad/closed_cubespikes_1194.obj", "1,022 vertices, 51 s"),
    ("Bigguy", "quad/closed_bigguy_1452.obj", "1,022 vertices, 51 s"),
]
DIRECTIONS = ["--method", "similarity", "--similarity", "directions", "--weights", "none"]
VECTORS = ["--method", "similarity"]
FORMS = [("directions", DIRECTIONS), ("vectors", VECTORS), ("fair", ["--method", "fair"])]

TEAPOT_VIEW = ["--up", "z", "--camera", "30,25", "--size", "440x330", "--point-radius", "0.01"]
# For pictures like figure 2 and like figure 4: name, mesh, and how it is drawn
FIGURE_2 = [
    ("Teapot", TEAPOT, TEAPOT_VIEW),
    ("T", "quad/closed_T_20.ply", ["--camera", "30,20", "--size", "440x400"]),
]
FIGURE_4 = [
    ("Teapot", TEAPOT, TEAPOT_VIEW),
    ("T", "quad/closed_T_20.ply", ["--camera", "30,20", "--size", "360x330"]),
    ("Three holes", "quad/closed_3torus_19_genus3.off", ["--camera", "30,20", "--size", "360x360"]),
    ("Capsule", "quad/open_hole_capsule_89_3loops.off", ["--camera", "30,-30", "--size", "360x330"]),
    ("Rocker arm", "tri/closed_rocker_arm_800_genus1.off", ["--camera", "150,35", "--size", "360x330"]),
    ("Cubespikes", "quad/closed_cubespikes_1194.obj", ["--camera", "30,25", "--size", "360x360"]),
    ("Bigguy", "quad/closed_bigguy_1452.obj", ["--camera", "30,10", "--size", "360x360"]),
]

RUNS = 20

RING, RULES = ["--open", "dummy-ring"], ["--open", "boundary-rules"]
# The paper's figure 3: a glass, in a ring of dummy faces or without, its rim asked to end upright or not.
GLASS = [
    ("by boundary rules", RULES, False),
    ("in a dummy ring", RING, False),
    ("by boundary rules, its rim asked to end upright", RULES, True),
    ("in a dummy ring, its rim asked to end upright", RING, True),
]
GLASS_VIEW = ["--up", "z", "--camera", "20,25", "--size", "340x400"]
BOWL = 0.8  # above this height
BOWL_VIEW = ["--up", "z", "--camera", "20,0", "--size", "440x300"]

HEAD = """# Similarity-based interpolation: the paper's sizes and figures, made again

Written by `make papers`. S. Lai, F. Cheng, *Similarity based interpolation using Catmull-Clark subdivision
surfaces*, The Visual Computer 22, 2006. The teapot is the paper's: one mesh of four open parts, 138 vertices and
128 faces. Its other meshes are not published; beside each of ours stands what the paper reports for the nearest of
its own, on a PC of 3.2 GHz of its day, so the times are no comparison of methods. `directions` is the paper's form
with its weights (`--weights none`), `vectors` the default here, `fair` thin-plate fairing; all with boundary rule
edge-and-corner, and the glass with the paper's ring of dummy faces as well. All is done to the paper's 1e-2, and for the
table to 1e-6, too (iterations, seconds); pictures are those at 1e-2. The error is the largest distance between a given
vertex and its limit point, relative to the box side, at either. Seconds are for set-up and solution, and from file to
file for the whole process, from its start to its end; each is the least of twenty runs on one thread (too high where
other work shares the machine). What the forms are, where they differ from the paper, and what the stop leaves undone:
[methods/similarity.md](../methods/similarity.md).

| mesh | vertices | faces | form | iterations | seconds | file to file | to 1e-6 | seconds | file to file | error | the paper |
|---|--:|--:|---|--:|--:|--:|--:|--:|--:|--:|---|
"""

FIGURE_2_TEXT = """
## Figure 2: the limit surface, scaled
The given vertices are red. The limit surface (b) is smaller than the given mesh. In (c) it is stretched, along each
axis by its own factor, until the box of the limits of the given vertices is that of the given vertices: this is the
reference, which `--write-reference` writes. The interpolating surface (d) is of the paper's form, `directions`. The
pictures of a row are seen from the same place.

"""

FIGURE_3_TEXT = """
## Figure 3: an open mesh, and its rim
The paper goes around the boundary with a ring of dummy faces, whose outer vertices start where the boundary's are.
The ring has no width there; (c) shows it after the refinement, which gives it some: the blue band at the rim. Of the
two rings that it is refined to, only the inner one has an influence on the surface, and only that one is kept. The
surfaces (d), (e) and (f) end inside of it. In (f) the surface is asked to end upright at every vertex of the rim; what
the paper asks of its glass it does not say: from the side it shows in the bowl's outline, which narrows up to the rim
in (e) and ends upright in (f). The form is `vectors`, the default here.

"""

FIGURE_3_MORE = """
By the paper's form, `directions`, the stem is fluted, and the surface turns upright so close to the rim that it is
hardly seen. The control meshes show where the free dummies have gone. Boundary rules, without dummies, make the
surface straight across the rim, and it swells below to end upright. None of this is due to the stop: solved to 1e-6 the
surfaces by `directions`, and the swollen one, look the same in these views.

"""

FIGURE_4_TEXT = """
## Figure 4: meshes of several kinds
Row by row: the paper's teapot; a T; a body with three holes; a capsule, open at three places; a rocker arm; Cubespikes;
Bigguy. But for the teapot these are not the paper's meshes, which are not published, and the rocker arm here is made of
triangles. `directions` is the paper's form, `vectors` the default here. Measures of these forms and of fair surfaces, for
Cubespikes, Bigguy and eight other meshes and with our weights under `directions`, are in the [comparison of
methods](../comparison.md). The limit surface is not scaled, as in the paper. At the tip of the teapot's spout the
interpolating surfaces turn over, unlike the limit surface: the lip shows its back, in blue.

"""


def seconds_of_process(command):
    """From its start to its end, without what Python's subprocess does around it."""
    words = [os.fspath(word) for word in command]
    start = time.perf_counter()
    _, status = os.waitpid(os.posix_spawn(words[0], words, os.environ), 0)
    seconds = time.perf_counter() - start
    if status != 0:
        raise subprocess.CalledProcessError(os.waitstatus_to_exitcode(status), words)
    return seconds


def interpolate(surpass, mesh, options, folder):
    """The last report, and the least seconds of several runs: for set-up and solution, and from file to file."""
    report = folder / "report.json"
    command = [surpass, "interpolate", mesh, "-o", folder / "control.ply", "--scheme", "catmull-clark", "--threads",
               "1", "--quiet", *options]
    solving, whole = [], []
    for _ in range(RUNS):
        subprocess.run([*command, "--report", report], check=True)
        found = json.loads(report.read_text())
        solving.append(found["seconds"]["topology"] + found["seconds"]["solve"])
        whole.append(seconds_of_process(command))
    return found, min(solving), min(whole)


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


class Artist:
    """Draws what belongs to one given mesh, all of it from the same place."""

    def __init__(self, surpass, figure, name, mesh, view, folders):
        self.surpass, self.figure, self.name, self.mesh, self.view = surpass, figure, name, mesh, view
        self.folder, self.output = folders
        self.frame = [mesh]
        self.scale = None

    def factors(self):
        return f"{self.name} " + ", ".join(f"{factor:.2f}" for factor in self.scale)

    def interpolated(self, name, options):
        """The control mesh and the reference. From now on there is room for the surface in the pictures."""
        control, reference, surface = (self.folder / f"{self.name}-{name}-{part}.obj"
                                       for part in ("control", "reference", "surface"))
        subprocess.run([self.surpass, "interpolate", self.mesh, "-o", control, "--scheme", "catmull-clark", "--quiet",
                        "--write-reference", reference, "--surface", surface, "--levels", "2", "--report",
                        self.folder / "report.json", *options], check=True)
        self.frame.append(surface)
        self.scale = json.loads((self.folder / "report.json").read_text())["similarity"]["scale"]
        return control, reference

    def facets(self, name, mesh):
        return self._draw(name, mesh, ["--flat", "--edges"])

    def surface(self, name, control, levels, points=True):
        marks = ["--points", self.mesh] if points else []
        return self._draw(name, control, ["--scheme", "catmull-clark", "--levels", str(levels), *marks])

    def close(self, name, control, frame, view):
        """Of a part only, from another side."""
        return self._draw(name, control, ["--scheme", "catmull-clark", "--levels", "3"], [frame], view)

    def _draw(self, name, mesh, options, frame=None, view=None):
        picture = f"similarity-{self.figure}-{self.name}-{name}.png".lower().replace(" ", "-")
        frame = ",".join(str(path) for path in frame or self.frame)
        subprocess.run([self.surpass, "render", mesh, "-o", self.output / picture, "--frame", frame, "--quiet",
                        *(view or self.view), *options], check=True)
        return f"![{self.name}, {name}]({picture})"


def table(captions, *rows):
    lines = ["| " + " | ".join(cells) + " |\n" for cells in (captions, *rows)]
    return lines[0] + "|" + "---|" * len(captions) + "\n" + "".join(lines[1:])


def factors_of(artists):
    return "\nFactors along x, y and z: " + "; ".join(artist.factors() for artist in artists) + ".\n"


def figure_2(surpass, data, folders):
    artists, rows = [], []
    for name, file, view in FIGURE_2:
        artist = Artist(surpass, 2, name, data / file, view, folders)
        control, reference = artist.interpolated("directions", DIRECTIONS)
        rows.append([artist.facets("given", artist.mesh), artist.surface("limit", artist.mesh, 4),
                     artist.surface("scaled", reference, 3), artist.surface("directions", control, 3)])
        artists.append(artist)
    captions = ["(a) given mesh", "(b) limit surface", "(c) scaled limit surface", "(d) interpolating surface"]
    return FIGURE_2_TEXT + table(captions, *rows) + factors_of(artists)


def with_blue_dummies(control, path):
    """The mesh with its hole faces as faces, but turned over: seen from the front they show their backs."""
    lines = control.read_text().splitlines()
    holes = {int(face) for line in lines if line.startswith("t hole") for face in line.split()[3:]}
    vertices = [line for line in lines if line.startswith("v ")]
    faces = [line.split()[1:] for line in lines if line.startswith("f ")]
    turned = (reversed(face) if f in holes else face for f, face in enumerate(faces))
    path.write_text("\n".join(vertices + ["f " + " ".join(face) for face in turned]) + "\n")
    return path


def figure_3(surpass, mesh, rim, folders):
    artist = Artist(surpass, 3, "Glass", mesh, GLASS_VIEW, folders)
    upright = ["--requirements", rim]
    ring, reference = artist.interpolated("ring", VECTORS + RING)
    ring_rim, _ = artist.interpolated("ring-rim", VECTORS + RING + upright)
    fluted, _ = artist.interpolated("directions", DIRECTIONS + RING)
    fluted_rim, _ = artist.interpolated("directions-rim", DIRECTIONS + RING + upright)
    rules, _ = artist.interpolated("rules", VECTORS + RULES)
    rules_rim, _ = artist.interpolated("rules-rim", VECTORS + RULES + upright)

    def extended(name, control):
        return artist.facets(name, with_blue_dummies(control, folders[0] / f"{name}.obj"))

    first = table(["(a) given mesh", "(b) limit surface of (a)", "(c) extended mesh"],
                  [artist.facets("given", mesh), artist.surface("limit", mesh, 4), extended("extended", reference)])
    second = table(["(d) limit surface of (c)", "(e) interpolating surface, similar to (d)",
                    "(f) with additional requirements"],
                   [artist.surface("extended-limit", reference, 3), artist.surface("ring", ring, 3),
                    artist.surface("ring-rim", ring_rim, 3)])
    bowl = folders[0] / "bowl.xyz"
    vertices = [line.split()[1:] for line in mesh.read_text().splitlines() if line.startswith("v ")]
    bowl.write_text("".join(" ".join(v) + "\n" for v in vertices if float(v[2]) > BOWL))
    second += "\n" + table(["the bowl of (e) from the side", "the bowl of (f) from the side"],
                           [artist.close("ring-bowl", ring, bowl, BOWL_VIEW),
                            artist.close("ring-rim-bowl", ring_rim, bowl, BOWL_VIEW)])
    third = table(["(e) by `directions`", "(f) by `directions`", "(e) by boundary rules"],
                  [artist.surface("directions", fluted, 3), artist.surface("directions-rim", fluted_rim, 3),
                   artist.surface("rules", rules, 3)])
    fourth = table(["control mesh of (e)", "control mesh of (f)", "(f) by boundary rules"],
                   [extended("ring-control", ring), extended("ring-rim-control", ring_rim),
                    artist.surface("rules-rim", rules_rim, 3)])
    return FIGURE_3_TEXT + first + "\n" + second + FIGURE_3_MORE + third + "\n" + fourth


def figure_4(surpass, data, folders):
    artists, rows = [], []
    for name, file, view in FIGURE_4:
        artist = Artist(surpass, 4, name, data / file, view, folders)
        directions, _ = artist.interpolated("directions", DIRECTIONS)
        vectors, _ = artist.interpolated("vectors", VECTORS)
        rows.append([artist.facets("given", artist.mesh), artist.surface("limit", artist.mesh, 4, points=False),
                     artist.surface("directions", directions, 3, points=False),
                     artist.surface("vectors", vectors, 3, points=False)])
        artists.append(artist)
    captions = ["given mesh", "limit surface", "interpolating surface, `directions`", "`vectors`"]
    return FIGURE_4_TEXT + table(captions, *rows) + factors_of(artists)


def measure(surpass, mesh, title, form, paper, options, folder):
    """A row of the table, and whether the surface interpolates and meets what was asked of it."""
    loose, *seconds = interpolate(surpass, mesh, options, folder)
    tight, *more_seconds = interpolate(surpass, mesh, [*options, "--solver-tolerance", "1e-6"], folder)
    error = max(found["error"]["max"] for found in (loose, tight))
    row = (f"| {title} | {loose['input']['vertices']} | {loose['input']['faces']} | {form} | "
           f"{loose['iterations']} | {seconds[0]:.4f} | {seconds[1]:.4f} | {tight['iterations']} | "
           f"{more_seconds[0]:.4f} | {more_seconds[1]:.4f} | {error:.1e} | {paper} |")
    asked = [r for found in (loose, tight) for r in found["similarity"].get("requirements", [])]
    right = error <= 1e-12 and all(r["error"] <= 1e-10 and not r["flipped"] for r in asked)
    return row, right


def measure_all(surpass, data, mesh, rim, folder):
    for title, file, paper in MODELS:
        for form, options in FORMS:
            yield measure(surpass, data / file, title, form, paper, options, folder)
    for title, options, upright in GLASS:
        asked = ["--requirements", rim] if upright else []
        yield measure(surpass, mesh, f"Glass, {title}", "vectors", '"almost in real time"',
                      VECTORS + options + asked, folder)


def main():
    surpass, output = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    data = folder_or_skip(sys.argv[2], len(MODELS) * len(FORMS), "Similarity")
    output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        mesh, rim = write_glass(folder)
        rows, right = zip(*measure_all(surpass, data, mesh, rim, folder))
        print("\n".join(rows))
        folders = folder, output
        figures = (figure_2(surpass, data, folders) + figure_3(surpass, mesh, rim, folders)
                   + figure_4(surpass, data, folders))
    (output / "similarity.md").write_text(HEAD + "\n".join(rows) + "\n" + figures)
    sys.exit(0 if all(right) else 1)


if __name__ == "__main__":
    main()
