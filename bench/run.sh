#!/bin/sh
# bench/run.sh [BUILD [RESULTS [OPTION...]]]: runs the benchmarks built in BUILD (build/bench), leaves
# the raw figures in RESULTS/figures.json (bench/results) and the table in RESULTS/table.md, and
# prints the table. Options go to the program, such as --benchmark_filter=/16384/
set -eu
cd "$(dirname "$0")/.."
build=${1:-build/bench}
results=${2:-bench/results}
[ $# -lt 2 ] && shift $# || shift 2

# One thread for everybody, the rivals' linear algebra included; our rows say where they use more.
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
# The same kind of memory for everybody: malloc asks the kernel for huge pages (glibc 2.35 or later)
# and keeps what was freed, or else a third of all times would be the handing out of fresh ones.
export GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.mmap_max=0:glibc.malloc.trim_threshold=17179869184
mkdir -p "$results"
status=0
"$build/surpass_bench" --benchmark_out="$results/figures.json" --benchmark_out_format=json \
  --benchmark_display_aggregates_only=true "$@" >&2 || status=$?
python3 bench/table.py "$results/figures.json" >"$results/table.md"
cat "$results/table.md"
exit $status
