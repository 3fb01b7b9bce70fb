#!/usr/bin/env python3
"""Times reconstruction from twenty thousand to two million points: points_curve.py BUILD RESULTS PLOT

Runs BUILD/surpass reconstruct on random points of a torus, binary PLY in and out, with the Doo-Sabin
surface through every point and the distances of all points to it. Writes RESULTS/points_curve.json,
RESULTS/points_curve.md with the table, which it prints too, and PLOT, an SVG. Takes some minutes and
5 GB at the largest size.
"""
import array
import json
import math
import os
import pathlib
import random
import subprocess
import sys
import tempfile

from plot import log_plot, publish

SIZES = [20_000, 100_000, 500_000, 2_000_000]
STAGES = ["read", "reconstruct", "interpolate", "verify", "write"]
GROWTH = 1.6  # what the time of a point may grow by from the second size to the last


def write_torus(path, count):
    """Random points, even in area, on the torus of radii 1 and 0.4."""
    source = random.Random(count)
    numbers = array.array("d")
    while len(numbers) < 3 * count:
        u, v = 2 * math.pi * source.random(), 2 * math.pi * source.random()
        radius = 1 + 0.4 * math.cos(v)
        if 1.4 * source.random() > radius:
            continue
        numbers.extend((radius * math.cos(u), radius * math.sin(u), 0.4 * math.sin(v)))
    if sys.byteorder == "big":
        numbers.byteswap()
    head = (f"ply\nformat binary_little_endian 1.0\nelement vertex {count}\nproperty double x\n"
            "property double y\nproperty double z\nend_header\n")
    path.write_bytes(head.encode() + numbers.tobytes())


def run(program, folder, count):
    cloud, report = folder / "cloud.ply", folder / "report.json"
    write_torus(cloud, count)
    child = subprocess.Popen([program, "reconstruct", cloud, "-o", folder / "mesh.ply", "--report",
                              report, "--quiet"])
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{program} failed on {count} points")
    found = json.loads(report.read_text())
    mesh = found["reconstruction"]
    if mesh.get("genus") != 1 or mesh["open_loops"] != 0 or found["distance"]["all"]["max"] > 1e-12:
        sys.exit(f"{count} points of a torus did not become a closed torus through them")
    return {"points": count, "processor": usage.ru_utime + usage.ru_stime,
            "peak": found["peak_memory_bytes"], "wall": found["seconds"]["total"],
            "filled_loops": mesh["filled_loops"], **{s: found["seconds"][s] for s in STAGES}}


def a_point(figure, key):
    return figure[key] / figure["points"]


def table(figures):
    lines = ["| points | processor time, s | µs a point | wall time, s | " +
             " | ".join(f"{s}, s" for s in STAGES) + " | peak, MB | kB a point |",
             "|" + " --: |" * (len(STAGES) + 6)]
    for f in figures:
        cells = [f["points"], f"{f['processor']:.2f}", f"{1e6 * a_point(f, 'processor'):.1f}",
                 f"{f['wall']:.2f}", *(f"{f[s]:.2f}" for s in STAGES), f"{f['peak'] / 1e6:.0f}",
                 f"{1e-3 * a_point(f, 'peak'):.2f}"]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    growth = a_point(figures[-1], "processor") / a_point(figures[1], "processor")
    verdict = "reached" if growth <= GROWTH else "**missed**"
    lines += ["", f"From {figures[1]['points']} to {figures[-1]['points']} points the processor time a "
                  f"point grows by a factor of {growth:.2f}; striven for: at most {GROWTH}: {verdict}."]
    return "\n".join(lines)


def plot(figures):
    lines = {"seconds": [(f["points"], f["processor"]) for f in figures],
             "gigabytes": [(f["points"], f["peak"] / 1e9) for f in figures]}
    names = {-2: "0.01", -1: "0.1", 0: "1", 1: "10", 2: "100"}
    return log_plot(lines, "points", (4, 6.6), range(4, 7), (-2, 2.4), names)


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    build, results, picture = map(pathlib.Path, sys.argv[1:])
    figures = []
    memory = pathlib.Path("/dev/shm")  # the disk, to which the program flushes, is not measured
    with tempfile.TemporaryDirectory(dir=memory if memory.is_dir() else None) as name:
        for count in SIZES:
            figures.append(run(build / "surpass", pathlib.Path(name), count))
            print(f"{count} points: {figures[-1]['processor']:.1f} s", file=sys.stderr)
    publish(figures, table(figures), results, "points_curve", plot(figures), picture)


if __name__ == "__main__":
    main()
