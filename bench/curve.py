#!/usr/bin/env python3
"""Times the whole program from a thousand to ten million vertices:
curve.py BUILD RESULTS PLOT [--quick]

Runs BUILD/surpass interpolate on one thread, OBJ in, binary PLY out, certificate included, on tori
made by BUILD/surpass_torus. Writes RESULTS/curve.json with every run, RESULTS/curve.md with the
table, which it prints too, and PLOT, an SVG. Takes a few minutes and 4 GB at the largest size; with --quick, one run a size, a minute.
"""
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

from plot import log_plot, publish

RUNS = {32: 15, 100: 15, 316: 7, 1000: 5, 3162: 5}  # by vertices a side
STAGES = ["read", "topology", "solve", "verify", "write"]
ADVICE = 1000  # vertices: the most that the commercial tool that we know advises
GROWTH = (316, 3162, 1.6)  # between these sides, time per vertex may grow by this much


def run(program, mesh, folder, *more):
    """Processor seconds of one process."""
    child = subprocess.Popen([program, "interpolate", mesh, "-o", folder / "control.ply",
                              "--tolerance", "1e-10", "--threads", "1", "--quiet", *more])
    _, status, usage = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    if child.returncode != 0:
        sys.exit(f"{program} failed on {mesh}")
    return usage.ru_utime + usage.ru_stime


def run_both(program, mesh, folder):
    """Processor seconds, shared out among the stages by the clock of a second run, which writes a
    report: that takes work that is not counted."""
    processor = run(program, mesh, folder)
    report = folder / "report.json"
    run(program, mesh, folder, "--report", report)
    found = json.loads(report.read_text())
    whole = sum(found["seconds"][stage] for stage in STAGES)
    return {"processor": processor, "peak": found["peak_memory_bytes"],
            "iterations": found["iterations"], "error": found["error"]["max"],
            **{stage: processor * found["seconds"][stage] / whole for stage in STAGES}}


def measure(build, quick):
    figures = []
    memory = pathlib.Path("/dev/shm")  # the disk, to which the program flushes, is not measured
    with tempfile.TemporaryDirectory(dir=memory if memory.is_dir() else None) as name:
        folder = pathlib.Path(name)
        mesh = folder / "torus.obj"
        for side, wanted in RUNS.items():
            count = 1 if quick else wanted
            subprocess.run([build / "surpass_torus", str(side), mesh], check=True)
            run(build / "surpass", mesh, folder)  # warms up
            runs = [run_both(build / "surpass", mesh, folder) for _ in range(count)]
            figures.append({"vertices": side * side, "runs": runs})
            print(f"{side * side} vertices: {count} runs", file=sys.stderr)
    return figures


def median(size, key):
    return statistics.median(r[key] for r in size["runs"])


def per_vertex(size, key):
    """Nanoseconds, or bytes for the peak."""
    return median(size, key) / size["vertices"] * (1 if key == "peak" else 1e9)


def table(figures):
    lines = ["| vertices | runs | processor time, ms | ns a vertex | " +
             " | ".join(f"{s}, ns a vertex" for s in STAGES) +
             " | evaluations | error | peak, bytes a vertex |",
             "|" + " --- |" * (len(STAGES) + 7)]
    for size in figures:
        cells = [size["vertices"], len(size["runs"]), f"{1e3 * median(size, 'processor'):.3g}",
                 f"{per_vertex(size, 'processor'):.0f}",
                 *(f"{per_vertex(size, s):.0f}" for s in STAGES),
                 f"{median(size, 'iterations'):.0f}", f"{median(size, 'error'):.0e}",
                 f"{per_vertex(size, 'peak'):.0f}"]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    by_size = {s["vertices"]: s for s in figures}
    small, large, bound = (by_size[GROWTH[0] ** 2], by_size[GROWTH[1] ** 2], GROWTH[2])
    growth = per_vertex(large, "processor") / per_vertex(small, "processor")
    verdict = "reached" if growth <= bound else "**missed**"
    lines += ["", f"From {small['vertices']} to {large['vertices']} vertices the processor time a "
                  f"vertex grows by a factor of {growth:.2f}; striven for: at most {bound}: {verdict}."]
    return "\n".join(lines)


def plot(figures):
    """Seconds over vertices, both logarithmic."""
    lines = {"whole program" if key == "processor" else key:
             [(size["vertices"], median(size, key)) for size in figures]
             for key in ["processor", *STAGES]}
    names = {-5: "10 µs", -4: "0.1 ms", -3: "1 ms", -2: "10 ms", -1: "0.1 s", 0: "1 s", 1: "10 s",
             2: "100 s"}
    return log_plot(lines, "vertices", (2.8, 7.2), range(3, 8), (-5, 2), names,
                    (ADVICE, "advised at most by a commercial tool"))


def main():
    if len(sys.argv) not in (4, 5) or sys.argv[4:] not in ([], ["--quick"]):
        sys.exit(__doc__)
    build, results, picture = map(pathlib.Path, sys.argv[1:4])
    figures = measure(build, quick=len(sys.argv) == 5)
    publish(figures, table(figures), results, "curve", plot(figures), picture)


if __name__ == "__main__":
    main()
