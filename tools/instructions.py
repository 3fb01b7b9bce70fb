#!/usr/bin/env python3
"""Guards the speed by what no other program on the machine can disturb: instruction counts.

    tools/instructions.py SURPASS            compare six small jobs with bench/instructions.tsv
    tools/instructions.py SURPASS --record   write that file anew, after a change that is worth more

Counts are those of valgrind's callgrind on one thread, less what starting the program takes. They
hold for g++ 12 and the libraries of Debian 12 on a processor with AVX2; on another one nothing can be
compared, which is said. Exit code 1 if a job takes more than 2 % above its entry.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "bench" / "instructions.tsv"
MORE = 1.02
LESS = 0.95  # worth a new entry, so that the guard does not stand far behind


def jobs(folder):
    """Name and arguments of each job; each may read what those before it wrote."""
    triangles, quads = ROOT / "data" / "sphere_irregular.obj", ROOT / "data" / "quad_torus.obj"
    fine, fine_quads = folder / "fine.obj", folder / "quads.ply"
    return {
        "refine Loop, write OBJ": ["subdivide", triangles, "-o", fine, "--levels", "3"],
        "refine Catmull-Clark, write PLY": ["subdivide", quads, "-o", fine_quads, "--levels", "4"],
        "read OBJ, write PLY": ["convert", fine, folder / "fine.ply"],
        "read PLY, topology": ["inspect", folder / "fine.ply"],
        "interpolate Loop": ["interpolate", folder / "fine.ply", "-o", folder / "loop.ply"],
        "interpolate Catmull-Clark": ["interpolate", fine_quads, "-o", folder / "quads2.ply"],
    }


def count(surpass, arguments):
    """Instructions of one run."""
    threads = [] if arguments == ["--version"] else ["--threads", "1", "--quiet"]
    run = subprocess.run(
        ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", surpass]
        + [str(a) for a in arguments] + threads, capture_output=True, text=True, check=False)
    found = re.search(r"Collected : (\d+)", run.stderr)
    if run.returncode != 0 or not found:
        sys.exit(f"{arguments[0]} did not run under callgrind:\n{run.stderr}")
    return int(found.group(1))


def measure(surpass):
    """Thousands of instructions by job, less those of the start."""
    start = count(surpass, ["--version"])
    with tempfile.TemporaryDirectory() as folder:
        return {name: (count(surpass, arguments) - start) // 1000
                for name, arguments in jobs(pathlib.Path(folder)).items()}


def compare(found, expected):
    """Prints a line a job; how many exceed their entry."""
    over = 0
    for name, now in found.items():
        ratio = now / expected[name]
        verdict = "MORE" if ratio > MORE else "less: record it" if ratio < LESS else "ok"
        over += ratio > MORE
        print(f"{name:34} {now:12,} thousand {ratio:8.4f} of the entry  {verdict}")
    print(f"{len(found) - over} passed, {over} failed, 0 skipped")
    return over


def main():
    if len(sys.argv) < 2 or sys.argv[2:] not in ([], ["--record"]):
        sys.exit(__doc__)
    flags = pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8")
    if " avx2 " not in flags:
        print("This processor has no AVX2, so its counts cannot be compared.")
        print("0 passed, 0 failed, 6 skipped")
        return 0
    found = measure(sys.argv[1])
    if sys.argv[2:]:
        lines = [f"{name}\t{now}\n" for name, now in found.items()]
        TABLE.write_text("job\tthousand instructions\n" + "".join(lines), encoding="utf-8")
        return 0
    rows = TABLE.read_text(encoding="utf-8").splitlines()[1:]
    expected = {name: int(now) for name, now in (row.split("\t") for row in rows)}
    return 1 if compare(found, expected) else 0


if __name__ == "__main__":
    sys.exit(main())
