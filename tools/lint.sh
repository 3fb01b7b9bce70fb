#!/usr/bin/env bash
# Format of every source, and clang-tidy over what ships: JOBS=2 tools/lint.sh. Needs no
# build, only a configured one for its compile commands, and the headers that it generates.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t sources < <(tools/sources.sh)
clang-format --dry-run -Werror "${sources[@]}"
echo "clang-format: ${#sources[@]} files"

# clang-tidy walks through all headers of what it reads, so it reads several sources at once: unity
# builds, in a build folder of its own. It could not read the headers that GCC has precompiled either.
cmake --preset release -B build/lint --log-level=WARNING -DSURPASS_TESTS=ON \
  -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8
mapfile -t units < <(sed -n 's/^ *"file": "\(.*\)",\{0,1\}$/\1/p' build/lint/compile_commands.json |
  grep -E '/(src|apps)/' | sort -u)
printf '%s\0' "${units[@]}" |
  xargs -0 -n 1 -P "${JOBS:-$(nproc)}" clang-tidy --quiet --warnings-as-errors='*' -p build/lint 2> /dev/null
echo "clang-tidy: $(cat "${units[@]}" | grep -c '^#include') files in ${#units[@]} units"

tools/web.sh packages
(cd web && npx --no-install tsc --noEmit && npx --no-install eslint .)
echo "tsc, eslint: $(git ls-files web | grep -c '\.[jt]s$') files"
