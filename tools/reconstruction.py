#!/usr/bin/env python3
"""Repeats Table 1 of the Doo-Sabin reconstruction paper on clouds of its sizes, with pictures.

usage: reconstruction.py SURPASS DATA OUTPUT

Smooth surface reconstruction using Doo-Sabin subdivision surfaces (Cheng, Fan, Huang, Wang, Lai,
Miura). Writes OUTPUT/doo-sabin-reconstruction.md. Exits with 1 where a genus, a number of vertices or
the interpolation is not what it should be.
"""
import pathlib
import sys
import tempfile

from program import Program
from real_meshes import folder_or_skip

# name, cloud, genus, and the paper's points, vertices and iterations to 1e-6
TABLE_1 = [
    ("CubeHC", "paper3_CubeHC_like_82016.ply", 5, 81920, 7666, 9, "35,25"),
    ("Goblet", "paper3_Goblet_like_129343.ply", 0, 129280, 8082, 7, "30,20"),
    ("Rockarm", "paper3_Rockarm_like_204051.ply", 1, 203904, 13984, 5, "40,35"),
    ("Beethoven", "paper3_Beethoven_like_262038.ply", None, 262016, 16378, 5, "20,10"),
]
OPEN = "Beethoven"
# name, cloud, genus, vertices
SHARP = [("CubeHC", "bench_points/paper3_CubeHC_like_82016.ply", 5, 7666),
         ("Fandisk", "points/sampled_fandisk_20035_edges.ply", 0, 2500)]
SCAN = "meshlab_bunny_16130.ply"

HEAD = """# Doo-Sabin reconstruction: the paper's table on clouds of its sizes

Written by `make papers`. F. Cheng, F. Fan, C. Huang, J. Wang, S. Lai, K. Miura, *Smooth surface
reconstruction using Doo-Sabin subdivision surfaces*. The paper's points are not published; these
clouds are blue-noise samples of similar shapes, of nearly the same sizes. Lengths are relative to the
box side. What the paper's own counts imply is in [the method's page](../methods/reconstruction.md).
"""


BUST = ["The bust is the paper's open model. The mesh that this cloud was sampled from is closed but for two",
        "triangles that stand alone, so no wide opening is left to be found: the front leaves small holes,",
        "which are filled by default. With `--close none` they stay, and Doo-Sabin's boundary rule holds them."]


class Reconstruction(Program):
    def reconstruct(self, cloud, *options):
        """Mesh, control mesh and report."""
        mesh, control = self.folder / "mesh.ply", self.folder / "control.ply"
        return mesh, control, self.run("reconstruct", cloud, "-o", mesh, "--control", control, *options)

    def iterations(self, mesh, solver):
        """Evaluations of the limit until every vertex is within 1e-6."""
        return self.run("interpolate", mesh, "-o", self.folder / "solved.ply", "--scheme", "doo-sabin", "--solver",
                        solver, "--tolerance", "1e-6", "--history")["iterations"]

    def draw(self, cloud, mesh, control, picture, camera):
        """Points, polyhedron and surface."""
        self.run("render", control, "--levels", "3", "--beside", f"{cloud},{mesh}", "-o", picture, "--camera", camera,
                 "--size", "480x480")


def measured(runner, cloud, *options):
    mesh, control, report = runner.reconstruct(cloud, *options)
    counts = [runner.iterations(mesh, solver) for solver in ("richardson", "chebyshev")]
    return mesh, control, report, counts


def genus_of(report):
    found = report["reconstruction"]
    loops = found["open_loops"]
    return f"{found.get('genus', '?')}" + (f", {loops} loops" if loops else "")


def row(name, report, counts, paper):
    found, used = report["reconstruction"], report["distance"]["used"]
    seconds, memory = report["processor"], report["peak_memory_bytes"] / 1e6
    return (f"| {name} | {found['points']} | {report['mesh']['vertices']} | {paper} | {genus_of(report)} | "
            f"{found['polyhedron']['max']:.1e} | {used['max']:.1e} | {used['mean']:.1e} | "
            f"{used['percentile99']:.1e} | {counts[0]} | {counts[1]} | {seconds:.1f} | {memory:.0f} |")


def is_right(report, genus, vertices):
    found = report["reconstruction"]
    return ((genus is None or found.get("genus") == genus)
            and (vertices is None or report["mesh"]["vertices"] == vertices)
            and report["interpolation"]["max"] <= 1e-12)


COLUMNS = ("| model | points | vertices | paper's | genus | points to mesh | to limit: max | mean | 99 % below "
           "| PI | Chebyshev | s | MB |\n|---|--:|--:|--:|---|--:|--:|--:|--:|--:|--:|--:|--:|")


def table(runner, data, output):
    full, simple, pictures, right = [], [], [], True
    for name, file, genus, points, vertices, iterations, camera in TABLE_1:
        cloud = data / "bench_points" / file
        _, _, report, counts = measured(runner, cloud)
        right &= is_right(report, genus, None)
        full.append(row(name, report, counts, f"({points})"))
        if name == OPEN:
            _, _, report, counts = measured(runner, cloud, "--close", "none")
            right &= is_right(report, None, None)
            full.append(row(f"{name}, `--close none`", report, counts, f"({points})"))
        mesh, control, report, counts = measured(runner, cloud, "--vertices", str(vertices))
        right &= is_right(report, genus, vertices)
        simple.append(row(name, report, counts, f"{vertices}, {iterations} iterations"))
        picture = f"reconstruction-{name.lower()}.png"
        runner.draw(cloud, mesh, control, output / picture, camera)
        pictures.append(f"![{name}]({picture})")
    return full, simple, pictures, right


def features(runner, data, output):
    """With and without creases."""
    rows, pictures, right = [], [], True
    for name, file, genus, vertices in SHARP:
        cloud = data / file
        for angle in (None, "40"):
            options = ["--vertices", str(vertices), *(["--feature-angle", angle] if angle else [])]
            mesh, control, report = runner.reconstruct(cloud, *options)
            right &= is_right(report, genus, vertices)
            used = report["distance"]["used"]
            rows.append(f"| {name} | {angle or 'none'} | {vertices} | {report['reconstruction']['creases']} | "
                        f"{used['max']:.1e} | {used['mean']:.1e} | {used['percentile99']:.1e} |")
        picture = f"reconstruction-{name.lower()}-creases.png"
        runner.draw(cloud, mesh, control, output / picture, "35,25")
        pictures.append(f"![{name} with creases]({picture})")
    return rows, pictures, right


def scan(runner, data, output):
    cloud = data / "points" / SCAN
    mesh, control, report = runner.reconstruct(cloud, "--vertices", "3000")
    runner.draw(cloud, mesh, control, output / "reconstruction-scan.png", "20,15")
    return "![A scan](reconstruction-scan.png)", is_right(report, 0, 3000)


def main():
    surpass, output = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[3]).resolve()
    data = folder_or_skip(sys.argv[2], 2 * len(TABLE_1) + 2 + 2 * len(SHARP), "Reconstruction")
    output.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        runner = Reconstruction(surpass, pathlib.Path(temporary))
        full, simple, pictures, right = table(runner, data, output)
        picture, scan_is_right = scan(runner, data, output)
        sharp, sharp_pictures, sharp_is_right = features(runner, data, output)
    text = "\n".join([
        HEAD, "## Every point a vertex", "",
        "`surpass reconstruct POINTS -o MESH --control CONTROL`. PI is the paper's iteration (`richardson`), counted as",
        "evaluations of the limit until 1e-6; processor seconds and peak megabytes are of the whole command.", "",
        COLUMNS, *full, "", *BUST, "", "## The paper's numbers of vertices", "",
        "`--vertices N`. Distances to the limit surface are those of all points that the full mesh uses.",
        "The paper gives 1e-6 as the error for every model; of what, it does not say.", "",
        COLUMNS, *simple, "", "## Sharp edges", "",
        "A Doo-Sabin surface without creases rounds every edge. `--feature-angle` makes creases of what is",
        "sharper than that many degrees, before anything is left out.", "",
        "| model | feature angle | vertices | crease edges | to limit: max | mean | 99 % below |",
        "|---|---|--:|--:|--:|--:|--:|", *sharp, "", *sharp_pictures, "", "## Pictures",
        "From left to right the points, the polyhedron with the paper's number of vertices, and the surface",
        "through them; last a scan of 16130 points, by 3000 of them.", "", *pictures, picture, ""])
    (output / "doo-sabin-reconstruction.md").write_text(text)
    print("\n".join([COLUMNS, *full, *simple]))
    sys.exit(0 if right and scan_is_right and sharp_is_right else 1)


if __name__ == "__main__":
    main()
