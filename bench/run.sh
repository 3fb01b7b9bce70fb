#!/bin/sh
# Builds and runs the benchmarks: raw figures to bench/results/figures.json, the table to stdout and
# bench/results/table.md. Arguments go to the program, such as --benchmark_filter=/16384/
set -eu
cd "$(dirname "$0")/.."

cmake --preset bench >&2
cmake --build build/bench --target surpass_bench >&2

# One thread for everybody, the rivals' linear algebra included; our rows say where they use more.
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
mkdir -p bench/results
status=0
./build/bench/surpass_bench --benchmark_out=bench/results/figures.json \
  --benchmark_out_format=json --benchmark_display_aggregates_only=true "$@" >&2 || status=$?
python3 bench/table.py bench/results/figures.json | tee bench/results/table.md
exit $status
