#!/usr/bin/env bash
# Runs ctest in a build folder: tools/test.sh BUILD DATA [ctest options]. DATA may be empty; the
# tests that need a folder of real meshes are then skipped, and the last line says how many were.
set -uo pipefail
build=$1 data=$2
shift 2

unset SURPASS_TEST_DATA
if [ -n "$data" ]; then
  SURPASS_TEST_DATA=$(realpath -e "$data") || exit 1
  export SURPASS_TEST_DATA
fi
report=$build/Testing/report.xml
mkdir -p "${report%/*}"
rm -f "$report"
ctest --test-dir "$build" -j "${JOBS:-$(nproc)}" --output-on-failure --output-junit \
  "$(realpath "$report")" "$@" |
  grep -Ev ' Start +[0-9]+: |   Passed +[0-9.]+ sec$|Skipped +[0-9.]+ sec$|\(Skipped\)$|did not run:$'
status=${PIPESTATUS[0]}
[ -f "$report" ] || exit 1

count() { sed -n "s/.*[[:space:]]$1=\"\([0-9]*\)\".*/\1/p" "$report" | head -1; }
total=$(count tests) failed=$(count failures) skipped=$(count skipped)
[ "$total" -gt 0 ] || { echo "No test was found in $build." >&2; exit 1; }
if [ "$skipped" -gt 0 ] && [ -z "$data" ]; then
  echo "$skipped cases were skipped; those that need a folder of real meshes run with DATA=DIR."
fi
echo "$((total - failed - skipped)) passed, $failed failed, $skipped skipped"
exit "$status"
