#!/usr/bin/env python3
"""Repeats the examples of the non-stationary Loop paper, compares it with other ways to interpolate, and looks for
what its theorems say.

usage: nonstationary.py SURPASS DATA OUTPUT

Interpolating triangular meshes using a non-uniform, non-stationary Loop subdivision (Zhang, Zheng, Chen 2025). The
examples need no data; the comparison does. Writes OUTPUT/nonstationary-loop.md. Exits with 1 where a distance is not
that of an independent implementation, or a surface does not interpolate.
"""
import json
import math
import pathlib
import random
import sys
import tempfile

from program import Program

SHAPES = [0, -1, -2, -3, -3.5]
STEPS = 7
# Hausdorff distances between given mesh and mesh after 7 steps by an independent implementation, for SHAPES.
DISTANCES = {
    "tetrahedron": [0.183102, 0.270574, 0.507838, 0.752775, 0.878114],
    "triangular bipyramid": [0.102742, 0.142003, 0.266815, 0.395836, 0.461938],
    "decagonal bipyramid": [0.112939, 0.085162, 0.160934, 0.247331, 0.293583],
    "star": [0.071487, 0.060961, 0.089220, 0.134102, 0.158136],
}
CLOSE = 1e-3
# name, what of the paper it is like, mesh, shapes, and the camera's azimuth in degrees
FIGURES = [
    ("figure-3", "Figure 3", "tetrahedron", [-1, -2, -3], -25),
    ("figure-4", "Figure 4", "triangular bipyramid", [-1, -2, -3], -15),
    ("figure-5", "Figure 5", "triangular bipyramid", [-0.5, 0, 1], -15),
    ("figure-6", "Figure 6", "decagonal bipyramid", [0, -1.5, -3], -9),
    ("figure-7", "Figure 7", "star", [0, -1.5, -3], -9),
]
TEN = ["closed_knight_502.off", "paper_turtle_445.off", "paper_hog_606.off", "paper_tiger_956.off",
       "paper_bird_1129.off", "closed_blobby_2027.off", "closed_fandisk_2877.obj", "closed_cow_2904.off",
       "closed_spot_2930.obj", "closed_kitten_2500_genus1.off"]
LEVELS = 3


def bipyramid(n, height=1.0, inner=1.0):
    rim = [(1.0 if i % 2 == 0 else inner, 2 * math.pi * i / n) for i in range(n)]
    points = [(0, 0, height), (0, 0, -height)] + [(r * math.cos(t), r * math.sin(t), 0) for r, t in rim]
    faces = []
    for i in range(n):
        a, b = 2 + i, 2 + (i + 1) % n
        faces += [(0, a, b), (1, b, a)]
    return points, faces


EXAMPLES = {
    "tetrahedron": ([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)]),
    "triangular bipyramid": bipyramid(3),
    "decagonal bipyramid": bipyramid(10),
    "star": bipyramid(10, 0.5, 0.6),
}


def write_off(path, points, faces):
    lines = [f"OFF\n{len(points)} {len(faces)} 0"]
    lines += [" ".join(repr(float(x)) for x in p) for p in points]
    lines += ["3 " + " ".join(str(i) for i in f) for f in faces]
    path.write_text("\n".join(lines) + "\n")
    return path


def read_off(path):
    words = path.read_text().split()
    n, m = int(words[1]), int(words[2])
    at, width = 4, 6 if words[0] == "NOFF" else 3  # with normals
    points = [tuple(float(x) for x in words[at + width * i:at + width * i + 3]) for i in range(n)]
    at += width * n
    return points, [tuple(int(i) for i in words[at + 4 * f + 1:at + 4 * f + 4]) for f in range(m)]


class Subdivision(Program):
    def subdivide(self, mesh, levels, *options, name="refined.off"):
        out = self.folder / name
        out.unlink(missing_ok=True)
        report = self.run("subdivide", mesh, "-o", out, "--levels", levels, "--scheme", "nonstationary-loop", *options)
        return out, report


def distance_table(program):
    rows = ["| mesh | " + " | ".join(f"{s:g}" for s in SHAPES) + " | nearest the reference to |",
            "|---|" + "--:|" * (len(SHAPES) + 1)]
    right, parameters = True, []
    for name, (points, faces) in EXAMPLES.items():
        given = write_off(program.folder / "given.off", points, faces)
        cells, worst, found_parameters = [], 0, []
        for shape, reference in zip(SHAPES, DISTANCES[name]):
            refined, report = program.subdivide(given, STEPS, "--shape", shape)
            found = program.run("compare", given, refined)["distance"]["hausdorff"]
            worst = max(worst, abs(found - reference) / reference)
            cells.append(f"{found:.6f}")
            found_parameters.append(" and ".join(f"{p['parameter']:.6f}" for p in report["nonstationary"]["parameters"]))
        right &= worst <= CLOSE
        rows.append(f"| {name} | " + " | ".join(cells) + f" | {worst:.1e} |")
        parameters.append(f"| {name} | " + " | ".join(found_parameters) + " |")
    return rows, parameters, right


def least_error(program, given, low, high, *options):
    """The uniform scheme's parameter that comes nearest to the given vertices, and its error, by golden sections."""
    def error(v):
        report = program.run("check", given, "--against", given, "--scheme", "nonstationary-loop", "--uniform", repr(v),
                             *options, allowed=(0, 4))
        return report["error"]["max"]

    golden = (math.sqrt(5) - 1) / 2
    for _ in range(40):
        left, right = high - golden * (high - low), low + golden * (high - low)
        if error(left) <= error(right):
            high = right
        else:
            low = left
    return (low + high) / 2, error((low + high) / 2)


def schemes_table(program):
    """Interpolation errors of the schemes of the paper's Table 1, and of its Remark 3."""
    rows = ["| mesh | this scheme | edges with the mean of their ends | uniform, best parameter | its error | exponential, best "
            "parameter | its error |", "|---|--:|--:|--:|--:|--:|--:|"]
    for name, (points, faces) in EXAMPLES.items():
        given = write_off(program.folder / "given.off", points, faces)
        cells = []
        for options in (("--shape", "-1"), ("--shape", "-1", "--rule", "mean")):
            report = program.run("check", given, "--against", given, "--scheme", "nonstationary-loop", *options,
                                 allowed=(0, 4))
            cells.append(f"{report['error']['max']:.1e}")
        for low, options in ((-2.5, ()), (-0.999, ("--iteration", "exponential"))):
            parameter, error = least_error(program, given, low, 1.9, *options)
            cells += [f"{parameter:.4f}", f"{error:.1e}"]
        rows.append(f"| {name} | " + " | ".join(cells) + " |")
    return rows


def time_table(program, data):
    rows = ["| scheme | onto the limit | processor seconds per million faces |", "|---|---|--:|"]
    mesh, out = data / "tri" / "paper_boy_17342.off", program.folder / "fine.ply"
    for options in ((), ("--limit",)):
        for scheme in ("loop", "nonstationary-loop"):
            report, seconds = program.timed("subdivide", mesh, "-o", out, "--levels", "3", "--scheme", scheme, *options)
            faces = report["outputs"][0]["faces"]
            rows.append(f"| {scheme} | {'yes' if options else 'no'} | {seconds / faces * 1e6:.3f} |")
    return rows


def figures(program, output):
    """Given mesh and surfaces, each from the same camera."""
    lines = []
    for file, title, name, shapes, degrees in FIGURES:
        given = write_off(program.folder / "given.off", *EXAMPLES[name])
        surfaces = [program.subdivide(given, 5, "--shape", shape, "--limit", name=f"{k}.off")[0]
                    for k, shape in enumerate(shapes)]
        picture = f"nonstationary-{file}.png"
        program.run("render", *surfaces, "--beside", given, "-o", output / picture, "--columns", len(shapes) + 1,
                    "--up", "z", "--camera", f"{degrees},22", "--size", "300x300")
        lines += [f"### {title}: {name}", f"Shape parameters {', '.join(f'{x:g}' for x in shapes)}.", "",
                  f"![{name}]({picture})", ""]
    return lines


def compare_methods(program, data):
    rows = ["| mesh | vertices | method | changed | steps | error | bending | bending without the sharpest hundredth | processor seconds |",
            "|---|--:|---|---|--:|--:|--:|--:|--:|"]
    right = True
    for file in TEN:
        mesh = data / "tri" / file
        control, surface = program.folder / "control.ply", program.folder / "surface.ply"

        def bending(path, *options):
            found = program.run("quality", path, "--levels", LEVELS, *options)["surfaces"][0]
            return f"{found['bending']:.0f} | {found['trimmed_bending']:.0f}"

        for shape in ("-1.5", "auto"):
            ours, seconds = program.timed("interpolate", mesh, "-o", surface, "--scheme", "nonstationary-loop", "--levels",
                                          LEVELS, "--shape", shape, runs=1 if shape == "auto" else 3)
            taken = ours["nonstationary"]["shape"]
            right &= ours["error"]["max"] <= 1e-14
            name = f"non-stationary, shape {taken:.2f}" + (" (auto)" if shape == "auto" else "")
            size = ours["input"]["vertices"]
            rows.append(f"| {mesh.stem} | {size} | {name} | the rules' parameters | 0 | {ours['error']['max']:.1e} | "
                        f"{bending(mesh, '--scheme', 'nonstationary-loop', '--shape', repr(taken))} | {seconds:.2f} |")
        progressive, seconds = program.timed("interpolate", mesh, "-o", control, "--surface", surface, "--levels", LEVELS,
                                             "--tolerance", "1e-12", "--boundary", "edge-only")
        rows.append(f"| {mesh.stem} | {size} | progressive interpolation | the control mesh | "
                    f"{progressive['iterations']} | {progressive['error']['max']:.1e} | {bending(control)} | {seconds:.2f} |")
        _, seconds = program.timed("subdivide", mesh, "-o", surface, "--levels", LEVELS, "--limit", "--scheme", "loop")
        rows.append(f"| {mesh.stem} | {size} | plain Loop | nothing | 0 | {progressive['error']['initial_max']:.1e} | "
                    f"{bending(mesh)} | {seconds:.2f} |")
    return rows, right


def lattice(radius, seed):
    """Equilateral triangles with random heights."""
    rng = random.Random(seed)
    inside = lambda i, j: max(abs(i), abs(j), abs(i + j)) <= radius
    places = [(i, j) for i in range(-radius, radius + 1) for j in range(-radius, radius + 1) if inside(i, j)]
    number = {place: k for k, place in enumerate(places)}
    points = [(i + j / 2, math.sqrt(3) / 2 * j, rng.uniform(-1, 1)) for i, j in places]
    faces = []
    for i, j in places:
        if inside(i + 1, j) and inside(i, j + 1):
            faces.append((number[i, j], number[i + 1, j], number[i, j + 1]))
            if inside(i + 1, j + 1):
                faces.append((number[i + 1, j], number[i + 1, j + 1], number[i, j + 1]))
    return points, faces


def second_differences(points, level, reach):
    """By lattice place: second difference quotients along the three directions."""
    scale = 2 ** level
    heights = {}
    for x, y, z in points:
        j = y * 2 / math.sqrt(3)
        heights[round((x - j / 2) * scale), round(j * scale)] = z
    found = {}
    for (i, j), z in heights.items():
        if max(abs(i), abs(j), abs(i + j)) > reach * scale:
            continue
        found[i, j] = [(heights[i + a, j + b] + heights[i - a, j - b] - 2 * z) * scale * scale
                       for a, b in ((1, 0), (0, 1), (1, -1))]
    return found


def smooth_inside(program):
    """Second difference quotients of a random height field, level by level."""
    rows = ["| level | largest | largest change from the level before | ratio | largest jump between neighbours | ratio |",
            "|--:|--:|--:|--:|--:|--:|"]
    given = write_off(program.folder / "lattice.off", *lattice(4, 7))
    before, change_before, jump_before = {}, None, None
    for level in range(1, 7):
        # The parameters are those of the limit; the mesh is not moved onto it.
        refined, _ = program.subdivide(given, level, "--limit", "--shape", "-1.5")
        found = second_differences(read_off(refined)[0], level, 2)
        largest = max(abs(x) for d in found.values() for x in d)
        changes = [abs(x - y) for (i, j), d in before.items() for x, y in zip(d, found[2 * i, 2 * j])]
        change = max(changes) if changes else None
        jump = max(abs(x - y) for (i, j), d in found.items() for a, b in ((1, 0), (0, 1), (1, -1))
                   if (i + a, j + b) in found for x, y in zip(d, found[i + a, j + b]))
        ratio = lambda new, old: f"{new / old:.3f}" if new is not None and old else ""
        shown = f"{change:.4f}" if change is not None else ""
        rows.append(f"| {level} | {largest:.4f} | {shown} | {ratio(change, change_before)} | {jump:.4f} | "
                    f"{ratio(jump, jump_before)} |")
        before, change_before, jump_before = found, change, jump
    return rows


def normal(points, face):
    a, b, c = (points[i] for i in face)
    u, w = [y - x for x, y in zip(a, b)], [y - x for x, y in zip(a, c)]
    n = (u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0])
    length = math.hypot(*n)
    return tuple(x / length for x in n)


def spread(points, faces):
    """The largest angle, in degrees, between two faces at vertex 0."""
    normals = [normal(points, f) for f in faces if 0 in f]
    return max(math.degrees(math.acos(min(1.0, sum(x * y for x, y in zip(a, b))))) for a in normals for b in normals)


def tangent_planes(program):
    levels = range(1, 7)
    rows = ["| valence | " + " | ".join(f"level {k}" for k in levels) + " | last ratio | slowest mode |",
            "|--:|" + "--:|" * (len(levels) + 2)]
    for n in (3, 4, 5, 6, 7, 8, 10, 12):
        rng = random.Random(n)
        points, faces = bipyramid(n)
        points = [tuple(x + rng.uniform(-0.2, 0.2) for x in p) for p in points]
        given = write_off(program.folder / "fan.off", points, faces)
        angles = []
        for level in levels:
            refined, _ = program.subdivide(given, level, "--limit", "--shape", "-1.5")
            angles.append(spread(*read_off(refined)))
        tangent = 3 / 8 + math.cos(2 * math.pi / n) / 4
        second = 3 / 8 + math.cos(4 * math.pi / n) / 4 if n > 3 else 0
        middle = 1 / 16 if n == 3 else 1 / 4
        slowest = max(second, middle, 1 / 8) / tangent
        rows.append(f"| {n} | " + " | ".join(f"{a:.2f}" for a in angles) +
                    f" | {angles[-1] / angles[-2]:.3f} | {slowest:.3f} |")
    return rows


def main():
    surpass, output = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        program = Subdivision(surpass, pathlib.Path(name))
        distances, parameters, right = distance_table(program)
        pictures = figures(program, output)
        schemes, inside, planes = schemes_table(program), smooth_inside(program), tangent_planes(program)
        if sys.argv[2]:
            data = pathlib.Path(sys.argv[2]).resolve()
            comparison, interpolates = compare_methods(program, data)
            times = time_table(program, data)
            right &= interpolates
        else:
            print(f"Non-stationary Loop: {len(TEN) + 1} cases were skipped; they need a folder of real meshes, DATA=DIR.")
            comparison = times = ["(needs a folder of real meshes)"]
    head = "| mesh | " + " | ".join(f"{s:g}" for s in SHAPES) + " |\n|---|" + "--:|" * len(SHAPES)
    text = "\n".join([
        "# Non-stationary Loop subdivision: the paper's examples, comparison and theorems, measured",
        "",
        "Written by `make papers`. B. Zhang, H. Zheng, H. Chen, *Interpolating triangular meshes using a non-uniform,",
        "non-stationary Loop subdivision*, Mathematics 13(17), 2862, 2025. The text that we had has lost the coordinates,",
        "parameters and tables, so nothing here can be held against the paper's own figures: geometry is inferred from the",
        "examples' words, shape parameters are chosen. Which part of the scheme is the authors' says",
        "[methods/nonstationary-loop.md](../methods/nonstationary-loop.md).",
        "",
        "## Tables 3 and 4: Hausdorff distances",
        f"Between the given mesh and the mesh after {STEPS} steps (solved for {STEPS}), by `surpass compare`; columns are shape",
        "parameters. The last column holds them against an independent implementation in another language, which samples",
        "the surfaces.",
        "",
        *distances,
        "",
        "The vertex parameters that were solved for, by rising valence:",
        "",
        head,
        *parameters,
        "",
        "## Table 1 and Remark 3: other schemes",
        "Distance of the limit surface from the given vertices, relative to the box side. The uniform scheme meets the vertices of",
        "one valence class at most; under the exponential iteration none can be met.",
        "",
        *schemes,
        "",
        "## Figures 3 to 7",
        "Left the given mesh, then surfaces for the shape parameters as said, after 5 levels on the limit; all from one",
        "direction and in one scale.",
        "",
        *pictures,
        "## Table 2: ways to interpolate, on ten meshes",
        "Errors are relative to the box side; bending is the integral of k1^2 + k2^2 over the limit surface, sampled",
        f"after {LEVELS} levels, apart from two rings of samples around extraordinary points. Seconds are those of the",
        "processor, user and system, for the whole command on one thread (`--threads 1`): from the file to the file of the",
        f"surface after {LEVELS} levels, with `auto`, which ran once, the search for the shape, too; else the least of three runs. `auto` takes the",
        "least bending without the sharpest hundredth that `quality` finds by its own default levels. Progressive",
        "interpolation goes to 1e-12 by the default solver. Steps are iterations before the first refinement.",
        "",
        *comparison,
        "",
        "## Time",
        "Boy, 17,342 vertices, three levels, 2.2 million faces: processor seconds, user and system, of the whole command on one",
        "thread, with reading and writing; the least of three runs.",
        "",
        *times,
        "",
        "## Theorem 1: second derivatives in the regular part",
        "A lattice of equilateral triangles with random heights (shape -1.5). The surface is a height field, so its second",
        "difference quotients along the three directions tell: if they converge evenly to continuous functions the surface is C2.",
        "Points are taken on the limit surface. Changes and jumps fall geometrically.",
        "",
        *inside,
        "",
        "## Theorem 2: tangent planes at extraordinary points",
        "Double pyramids, every vertex moved at random, shape -1.5: the largest angle between two faces at an apex, in degrees. It",
        "falls to 0 by the ratio that the eigenvalues say: the largest one beside the tangents', divided by theirs. The paper proves",
        "this for equal parameters; here the vertices have their own, for which it is measured only.",
        "",
        *planes,
        "",
    ])
    (output / "nonstationary-loop.md").write_text(text)
    print("\n".join(distances + [""] + comparison + [""] + inside + [""] + planes))
    sys.exit(0 if right else 1)


if __name__ == "__main__":
    main()
