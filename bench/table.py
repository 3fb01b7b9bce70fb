#!/usr/bin/env python3
"""Makes the table of a benchmark run: table.py FIGURES.json > TABLE.md

Medians are taken here, from the raw figures. The file is rewritten without what is derived from
them and without the name of the machine, so that it can be published.
"""
import json
import math
import pathlib
import statistics
import sys

OURS = "Surpass"
ANCHOR = "this machine"
READING_ALONE = "OpenMesh less its topology"
LARGE = 1000000
LARGEST = 4000000
BUSY = 0.9  # below this share of a core the wall clock says more about the neighbours


def load(path):
    """The run with only its raw figures left."""
    with open(path, encoding="utf-8") as file:
        run = json.load(file)
    run["context"].pop("host_name", None)
    run["benchmarks"] = [b for b in run["benchmarks"] if b["run_type"] == "iteration"]
    with open(path, "w", encoding="utf-8") as file:
        json.dump(run, file, indent=0)
        file.write("\n")
    return run


def gather(run):
    """{(step, vertices): {tool: figures}}, steps and tools in the order of first appearance."""
    groups = {}
    for b in run["benchmarks"]:
        step, vertices, tool = b["name"].split("/")[:3]
        figures = groups.setdefault((step, int(vertices)), {}).setdefault(
            tool, {"wall": [], "processor": [], "counted": b["label"], "wrong": False}
        )
        figures["wall"].append(b["real_time"])
        figures["processor"].append(b["processor_ms"])
        figures["wrong"] |= b["wrong"] != 0
        for key in ("difference", "error", "sweeps", "peak"):
            figures[key] = b.get(key)
    steps = list(dict.fromkeys(step for step, _ in groups))
    return dict(sorted(groups.items(), key=lambda item: (steps.index(item[0][0]), item[0][1])))


def median(figures, clock):
    return statistics.median(figures[clock])


def add_reading_alone(groups):
    """OpenMesh's readers always build connectivity: what it takes from arrays, in the same run, is
    taken off, so that reading is beside reading."""
    for (step, vertices), tools in groups.items():
        if step not in ("read OBJ", "read PLY"):
            continue
        both = groups.get((step + " to topology", vertices), {}).get("OpenMesh")
        topology = groups.get(("topology", vertices), {}).get("OpenMesh")
        if both is None or topology is None:
            continue
        left = {c: median(both, c) - median(topology, c) for c in ("wall", "processor")}
        if min(left.values()) <= 0:
            continue
        tools[READING_ALONE] = {
            **both, "wall": [left["wall"]], "processor": [left["processor"]],
            "counted": "IO::read_mesh less the median of its topology from arrays",
            "wrong": both["wrong"] or topology["wrong"],
        }


def number(x):
    return f"{x:.3g}" if x < 1000 else f"{x:.0f}"


def milliseconds(figures):
    """Median, and the range where there were several runs."""
    times = figures["wall"]
    text = number(statistics.median(times))
    return text if len(times) == 1 else f"{text} ({number(min(times))}..{number(max(times))})"


def row(cells):
    return "| " + " | ".join(str(c) for c in cells) + " |"


def heading(*names):
    return [row(names), row(["---"] * len(names))]


def small(x):
    return "" if x is None else "0" if x == 0 else f"{x:.0e}"


def ratio(rival, ours, clock):
    return median(rival, clock) / median(ours, clock)


def comparison(groups):
    lines = heading("step", "vertices", "ours, ms", "other", "its time, ms", "ratio",
                    "ratio of processor times", "difference", "error ours", "error other", "runs")
    for (step, vertices), tools in groups.items():
        ours = tools.get(OURS)
        for tool, figures in tools.items():
            if tool in (OURS, ANCHOR):
                continue
            if ours is None:
                cells = ["", tool, milliseconds(figures), "", ""]
            else:
                cells = [milliseconds(ours), tool, milliseconds(figures),
                         f"{ratio(figures, ours, 'wall'):.2f}",
                         f"{ratio(figures, ours, 'processor'):.2f}"]
            note = "**WRONG**" if figures["wrong"] else small(figures["difference"])
            lines.append(row([step, vertices, *cells, note,
                              small(ours["error"]) if ours else "", small(figures["error"]),
                              len(figures["wall"])]))
    return lines


def anchors(groups):
    lines = heading("step", "vertices", "ours, ms", "anchor", "its time, ms", "ours in anchors")
    for (step, vertices), tools in groups.items():
        if ANCHOR in tools and OURS in tools:
            anchor, ours = tools[ANCHOR], tools[OURS]
            lines.append(row([step, vertices, milliseconds(ours), anchor["counted"],
                              milliseconds(anchor), f"{1 / ratio(anchor, ours, 'wall'):.1f}"]))
    return lines


def counted(groups):
    lines = heading("step", "tool", "counted")
    seen = set()
    for (step, _), tools in groups.items():
        for tool, figures in tools.items():
            if (step, tool) not in seen:
                seen.add((step, tool))
                lines.append(row([step, tool, figures["counted"]]))
    return lines


def lost(groups):
    """Where another was faster than we are, by either clock."""
    lines = []
    for (step, vertices), tools in groups.items():
        for tool, figures in tools.items():
            if OURS not in tools or tool.startswith(OURS) or tool == ANCHOR:
                continue
            wall, processor = (ratio(figures, tools[OURS], c) for c in ("wall", "processor"))
            if min(wall, processor) < 1:
                lines.append(f"- {step}, {vertices} vertices: {tool} took {wall:.2f} of our time "
                             f"({processor:.2f} of our processor time)")
    return lines or ["None in this run."]


def sweeps(groups):
    lines = heading("step", "vertices", "tool", "sweeps")
    for (step, vertices), tools in groups.items():
        for tool, figures in tools.items():
            if figures["sweeps"] is not None:
                lines.append(row([step, vertices, tool, int(figures["sweeps"])]))
    return lines


# What is striven for, at a million vertices if nothing is said: step, in terms of whom, at least
# (times as fast) or at most (times as long), and whether it is only an aim.
REACH = [
    ("read OBJ", "tinyobjloader", ">=", 6, ""),
    ("read OBJ", ANCHOR, "<=", 6, "aim"),
    ("read PLY", "Assimp", ">=", 7, ""),
    ("read PLY", "CGAL", ">=", 7, ""),
    ("read PLY", READING_ALONE, ">=", 7, ""),
    ("read PLY to topology", "OpenMesh", ">=", 7, ""),
    ("read PLY", ANCHOR, "<=", 3.5, "aim"),
    ("topology", "CGAL", ">=", 2.5, ""),
    ("topology", "OpenSubdiv", ">=", 10, ""),
    ("solve again", ANCHOR, "<=", 32, ""),
    ("solve again", OURS + ", all cores", "<=", 1 / 1.5, "aim"),
    ("whole command", "tinyobjloader", ">=", 1, ""),
    ("solve from faces", "CHOLMOD", ">=", 40, ""),
    ("solve from faces", "Eigen CG", ">=", 4, ""),
    ("solve again", "CHOLMOD", ">=", 3, ""),
    ("solve again", "Eigen CG", ">=", 10, ""),
    *((step, tool, ">=", 1, "") for step in ("refine", "refine, catmull-clark")
      for tool in ("OpenMesh", "CGAL", "OpenSubdiv")),
    ("refine again", "OpenSubdiv stencils", ">=", 1, ""),
    ("refine again, catmull-clark", "OpenSubdiv stencils", ">=", 1, ""),
    ("sweep", "Eigen product", ">=", 1, ""),
]


# Seconds, file to file on one thread, by the number of faces: the similarity paper's sizes and beyond.
GROWING = "similarity, "
SECONDS = {1024: 0.02, 99856: 2, 1000000: 10}
BYTES = 4e9


def growth(groups):
    """How time and memory grow with the number of faces, which is that of the vertices."""
    lines = heading("step", "faces", "tool", "its time, ms", "exponent", "iterations", "peak, MB", "aim")
    before = {}
    for (step, faces), tools in groups.items():
        if not step.startswith(GROWING):
            continue
        for tool, figures in tools.items():
            time = median(figures, "wall")
            exponent = ""
            if (step, tool) in before:
                fewer, less = before[step, tool]
                exponent = f"{math.log(time / less) / math.log(faces / fewer):.2f}"
            before[step, tool] = faces, time
            peak = figures["peak"] * faces
            aim = ""
            if tool == OURS and faces in SECONDS and not step.endswith("1e-6"):
                met = time <= 1e3 * SECONDS[faces] and peak <= BYTES
                aim = f"{SECONDS[faces]} s: " + ("reached" if met else "**missed**")
            lines.append(row([step, faces, tool, milliseconds(figures), exponent, int(figures["sweeps"]),
                              number(peak / 1e6), aim]))
    return lines


def judged(value, relation, bound, kind):
    met = value >= bound if relation == ">=" else value <= bound
    return [f"{relation} {bound:.3g}" + (f" ({kind})" if kind else ""), f"{value:.3g}",
            "reached" if met else "**missed**"]


def growth_of_program(folder):
    """How the time a vertex of the whole program grew in the kept run of curve.py, from 100
    thousand to 10 million vertices; None without one."""
    path = folder / "curve.json"
    if not path.is_file():
        return None
    times = {round(math.log10(f["vertices"])): statistics.median(r["processor"] for r in f["runs"])
             / f["vertices"] for f in json.loads(path.read_text(encoding="utf-8"))}
    return times[7] / times[5] if 5 in times and 7 in times else None


def against(groups, step, vertices, tool, relation):
    """Ours and another's, as the relation wants them: >= how many times faster, <= how much
    longer; None where one of them is missing."""
    tools = groups.get((step, vertices), {})
    if OURS not in tools or tool not in tools:
        return None
    value = ratio(tools[tool], tools[OURS], "wall")
    return 1 / value if relation == "<=" and tool == ANCHOR else value


def reach(groups, folder):
    """The bounds, and what this run says of each."""
    lines = heading("step", "in terms of", "reach", "measured", "verdict")
    for step, tool, relation, bound, kind in REACH:
        value = against(groups, step, LARGE, tool, relation)
        if value is not None:
            lines.append(row([step, tool, *judged(value, relation, bound, kind)]))
    value = against(groups, "solve again", LARGEST, ANCHOR, "<=")
    if value is not None:
        lines.append(row(["solve again, four million", ANCHOR, *judged(value, "<=", 40, "")]))
    loop = groups.get(("solve again", LARGE), {}).get(OURS)
    for scheme in ("catmull-clark", "doo-sabin"):
        other = groups.get((f"solve again, {scheme} on quads", LARGE), {}).get(OURS)
        if loop and other:
            lines.append(row([f"solve again, {scheme} on quads", "the Loop solve",
                              *judged(ratio(other, loop, "wall"), "<=", 2.5, "")]))
    command = groups.get(("whole command", LARGE), {}).get(OURS)
    if command and command["peak"]:
        lines.append(row(["whole command", "bytes a vertex at its peak",
                          *judged(command["peak"], "<=", 400, "")]))
    frames = groups.get(("100 frames", LARGE), {}).get(OURS)
    if frames and loop:
        lines.append(row(["100 frames", "100 bare solves",
                          *judged(ratio(frames, loop, "wall") / 100, "<=", 1.2, "")]))
    grown = growth_of_program(folder)
    if grown:
        lines.append(row(["whole command, a vertex, of 10 million (`make curve`)", "of 100 thousand",
                          *judged(grown, "<=", 1.6, "")]))
    return lines


def circumstances(run, groups):
    standard = {"date", "executable", "num_cpus", "mhz_per_cpu", "cpu_scaling_enabled", "caches",
                "load_avg", "library_build_type", "aslr_enabled"}
    facts = [f"- {k}: {v}" for k, v in run["context"].items() if k not in standard]
    single = [f for tools in groups.values() for t, f in tools.items() if "all cores" not in t]
    share = sum(sum(f["processor"]) for f in single) / sum(sum(f["wall"]) for f in single)
    facts.append(f"- load average at the start: {run['context']['load_avg']}")
    facts.append(f"- single-threaded rows had {share:.0%} of a core" +
                 (": the machine was busy with other work, trust processor times more"
                  if share < BUSY else ""))
    return [f"Run of {run['context']['date']}.", "", *facts]


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    run = load(sys.argv[1])
    groups = gather(run)
    add_reading_alone(groups)
    wrong = any(f["wrong"] for tools in groups.values() for f in tools.values())
    print("\n".join([
        "# Surpass beside others", "",
        *circumstances(run, groups), "",
        "Times are medians with (least..most); a ratio above 1 is how many times longer the other "
        "takes. Differences and errors are relative to the largest side of the bounding box.", "",
        "## What is striven for", "", *reach(groups, pathlib.Path(sys.argv[1]).parent), "",
        "## Beside others", "", *comparison(groups), "",
        "## Growth", "",
        "Interpolation by similarity, file to file; the exponent is that of the time in the number of faces, from "
        "the size before.", "", *growth(groups), "",
        "## Against the machine", "", *anchors(groups), "",
        "## Sweeps to the tolerance", "", *sweeps(groups), "",
        "## Where another was faster", "", *lost(groups), "",
        "## What is counted", "", *counted(groups), "",
        "**Some results were wrong.**" if wrong else
        "Every result was compared with what all must reach, and agreed.",
    ]))


if __name__ == "__main__":
    main()
