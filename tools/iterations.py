#!/usr/bin/env python3
"""Counts evaluations of the limit on real meshes, for three schemes, solvers and tolerances.

usage: iterations.py SURPASS DATA OUTPUT.md
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from real_meshes import folder_or_skip

MESHES = [
    "tri/paper_hog_606.off",
    "tri/paper_rabbit_453.off",
    "tri/paper_boy_17342.off",
    "tri/paper_face_299_open.off",
    "tri/open_mannequin_428.off",
    "tri/open_lion_7529_5loops.off",
    "quad/closed_bigguy_1452.obj",
    "quad/closed_quadknot_1440_genus1.obj",
    "quad/closed_fandisk_quads_766.off",
    "quad/poly_spot_control_188.obj",
    "quad/poly_suzanne_507_3comps.obj",
    "quad/poly_greek_helmet_5021.obj",
    "quad/open_canyon_4096.obj",
    "quad/teapot_530_512_4open.obj",
]
SCHEMES = ["loop", "catmull-clark", "doo-sabin"]
SOLVERS = ["richardson", "chebyshev", "conjugate-gradient"]
TOLERANCES = ["1e-3", "1e-6", "1e-12"]

HEAD = """# Iterations

Evaluations of the limit that the surface takes, plus those of the boundary curves, until every given
vertex is within a tolerance of 1e-3 / 1e-6 / 1e-12 of the box side: `surpass interpolate --scheme ...
--solver ... --tolerance ... --history` (which tests after every sweep), boundary rule
`edge-and-corner`. PI is the paper's progressive interpolation (`richardson`), Chebyshev runs on
[lo, 1] with lo the larger one of the proven bound and of 0.83 times the mean of the rows' bounds (0.8
times where none is proven), CG in the inner product that makes the operator symmetric. `{refused}`: refused (Suzanne has interior vertices of two faces,
which CG does not take, and whose quads cannot be cut without a third face at an edge). For Loop
surfaces polygons are cut into triangles. Made by `make papers`.
"""


def count(surpass, mesh, scheme, solver, tolerance, folder):
    """Iterations, or None where the command refuses the combination or does not get there."""
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    subprocess.run(
        [surpass, "interpolate", mesh, "-o", folder / "control.ply", "--scheme", scheme, "--solver",
         solver, "--tolerance", tolerance, "--boundary", "edge-and-corner", "--report", report,
         "--history", "--quiet"] + (["--triangulate"] if scheme == "loop" else []),
        stderr=subprocess.DEVNULL, check=False)
    found = json.loads(report.read_text())
    if not found.get("converged"):
        return None
    return found["iterations"], found["boundary_iterations"]


def cell(counts):
    def text(pair):
        return "-" if pair is None else str(pair[0]) + (f"+{pair[1]}" if pair[1] else "")

    return " / ".join(text(pair) for pair in counts)


def main():
    surpass, output = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    data = folder_or_skip(sys.argv[2], len(MESHES) * len(SCHEMES), "Iterations")
    lines = [HEAD.format(refused="-")]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for scheme in SCHEMES:
            lines += [f"## {scheme}", "", "| mesh | PI | Chebyshev | CG |", "|---|---|---|---|"]
            for mesh in MESHES:
                cells = [cell([count(surpass, data / mesh, scheme, solver, tolerance, folder)
                               for tolerance in TOLERANCES]) for solver in SOLVERS]
                lines.append(f"| {pathlib.Path(mesh).stem} | " + " | ".join(cells) + " |")
            lines.append("")
    output.write_text("\n".join(lines))


if __name__ == "__main__":
    main()
