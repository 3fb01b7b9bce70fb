#!/usr/bin/env python3
"""Repeats the measurements of the papers with the built command line and writes docs/papers/.

usage: papers.py SURPASS DATA OUTPUT

Loop subdivision surface based progressive interpolation (Cheng, Fan, Lai, Huang, Wang, Yong 2009):
Table 1 and the pictures of figures 2 and 3. Exits with 1 where the published figures are not met.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from real_meshes import folder_or_skip

# The paper scales each model so that the largest side of its bounding box is 0.95 and stops below an
# absolute 1e-3; the command line works relative to the box side.
SIDE = 0.95
STOP = 1e-3

# name, file, published: vertices, iterations, maximum and average error, and how closely we agree.
TABLE_1 = [
    ("Hog", "paper_hog_606.off", 606, 10, 0.000870799, 0.000175255, 1e-7),
    ("Rabbit", "paper_rabbit_453.off", 453, 13, 0.000932857, 0.000111197, 1e-7),
    ("Tiger", "paper_tiger_956.off", 956, 9, 0.000720453, 0.00014148, 1e-7),
    ("Statue", "paper_statue_711_a.off", 711, 11, 0.000890806, 0.000109163, 1e-7),
    ("Boy", "paper_boy_17342.off", 17342, 6, 0.000913795, 0.000095615, 1e-7),
    ("Turtle", "paper_turtle_445.off", 445, 10, 0.000955765, 0.0001726, 1e-6),
    ("Bird", "paper_bird_1129.off", 1129, 9, 0.000766811, 0.000088345, 1e-7),
]
OPEN = [
    ("Face", "paper_face_299_open.off"),
    ("Pipe", "paper_pipe_428_open6.off"),
    ("Nefertiti", "open_nefertiti_654_2loops.off"),
    ("Mannequin", "open_mannequin_428.off"),
    ("Pig", "open_pig_468_7loops.off"),
    ("Hypersheet", "open_hypersheet_487_3loops.off"),
    ("Lion", "open_lion_7529_5loops.off"),
]
# name, file, camera azimuth and elevation, and whether the given vertices are marked as in figure 3
FIGURES = [
    ("figure-2-hog", "paper_hog_606.off", "130,15", False),
    ("figure-2-rabbit", "paper_rabbit_453.off", "30,15", False),
    ("figure-2-tiger", "paper_tiger_956.off", "40,15", False),
    ("figure-2-turtle", "paper_turtle_445.off", "50,35", False),
    ("figure-3-pipe", "paper_pipe_428_open6.off", "35,25", True),
    ("figure-3-face", "paper_face_299_open.off", "15,5", True),
]


def interpolate(surpass, mesh, folder, *options):
    """Runs `surpass interpolate`; returns the control mesh's path and the report."""
    control = folder / (mesh.stem + ".control.ply")
    report = folder / (mesh.stem + ".json")
    subprocess.run([surpass, "interpolate", mesh, "-o", control, "--report", report, "--quiet", *options],
                   check=True)
    return control, json.loads(report.read_text())


def table_1(surpass, data, folder):
    rows = ["| model | vertices | iterations | paper | maximum error | paper | average error | paper | agrees |",
            "|---|--:|--:|--:|--:|--:|--:|--:|---|"]
    all_agree = True
    for name, file, vertices, iterations, largest, average, closeness in TABLE_1:
        _, report = interpolate(surpass, data / "tri" / file, folder, "--boundary", "interior",
                                "--solver", "richardson", "--tolerance", repr(STOP / SIDE))
        ours_max = report["error"]["max"] * SIDE
        ours_mean = report["error"]["mean"] * SIDE
        agrees = (report["input"]["vertices"] == vertices and report["iterations"] == iterations
                  and abs(ours_max - largest) <= closeness and abs(ours_mean - average) <= closeness)
        all_agree &= agrees
        rows.append(f"| {name} | {vertices} | {report['iterations']} | {iterations} | {ours_max:.9f} | "
                    f"{largest:.9f} | {ours_mean:.9f} | {average:.9f} | {'yes' if agrees else 'NO'} |")
    return rows, all_agree


def open_models(surpass, data, folder):
    rows = ["| model | vertices | boundary loops | boundary iterations | its last error | "
            "interior iterations | maximum error | average error |",
            "|---|--:|--:|--:|--:|--:|--:|--:|"]
    for name, file in OPEN:
        _, report = interpolate(surpass, data / "tri" / file, folder, "--boundary", "hoppe",
                                "--solver", "richardson", "--tolerance", repr(STOP / SIDE))
        boundary = report["boundary_history"][-1]["max"] * SIDE
        rows.append(f"| {name} | {report['input']['vertices']} | {report['input']['boundary_loops']} | "
                    f"{report['boundary_iterations']} | {boundary:.9f} | {report['iterations']} | "
                    f"{report['error']['max'] * SIDE:.9f} | {report['error']['mean'] * SIDE:.9f} |")
    return rows


def figures(surpass, data, folder, output):
    lines = []
    for name, file, camera, marked in FIGURES:
        given = data / "tri" / file
        control, _ = interpolate(surpass, given, folder, "--boundary", "edge-only")
        subprocess.run([surpass, "render", control, "-o", output / f"{name}.png", "--levels", "3",
                        "--beside", given, *(["--points", given] if marked else []),
                        "--camera", camera, "--size", "640x640", "--quiet"], check=True)
        lines.append(f"![{name}]({name}.png)")
    return lines


def main():
    surpass, output = sys.argv[1], pathlib.Path(sys.argv[3])
    data = folder_or_skip(sys.argv[2], len(TABLE_1) + len(OPEN), "Progressive interpolation")
    output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        closed, agree = table_1(surpass, data, folder)
        opened = open_models(surpass, data, folder)
        pictures = figures(surpass, data, folder, output)
    text = "\n".join([
        "# Progressive interpolation on Loop surfaces: the paper's table, measured again",
        "",
        "Written by `make papers`. F. Cheng, F. Fan, S. Lai, C. Huang, J. Wang, J. Yong, *Loop subdivision",
        "surface based progressive interpolation*, Journal of Computer Science and Technology 24(1), 2009.",
        "",
        "## Table 1: closed models",
        "The paper says that its models are normalised to a unit cube. Its figures come out when the largest",
        "side of the bounding box is 0.95, the error is the Euclidean distance, the iteration (`richardson`)",
        "stops at the first maximum below 1e-3, and evaluations of the limit are counted. Vertices on holes",
        "take the interior rule over their edge neighbours (`--boundary interior`).",
        "",
        *closed,
        "",
        "## Open models, two-stage solve",
        "Boundary rule `hoppe`: boundary curves first, then the interior. For its face model (299 vertices)",
        "the paper reports 10 iterations to 0.000998516 on the boundary and 10 to 0.000896328 inside; the",
        "model of that size in our collection takes other counts, so the paper used another model or scale.",
        "",
        *opened,
        "",
        "## Figures",
        "Left the given mesh, right the interpolating surface (boundary rule `edge-only`, three refinements,",
        "moved to the limit); red dots are the given vertices.",
        "",
        *pictures,
        "",
    ])
    (output / "progressive-loop.md").write_text(text)
    print("\n".join(closed + [""] + opened))
    print(f"\nwritten: {output / 'progressive-loop.md'}")
    sys.exit(0 if agree else 1)


if __name__ == "__main__":
    main()
