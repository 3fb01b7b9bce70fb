#!/usr/bin/env bash
# Builds what runs in a browser: tools/web.sh report | studio | packages. The report's frame needs npm alone, the
# studio the WebAssembly module as well. Does nothing, and quickly, if all is newer than its sources.
set -euo pipefail
what=${1:?usage: tools/web.sh report|studio|packages}
cd "$(dirname "$0")/../web"

# The packages of the lock file, fetched anew only when it changes.
stamp=node_modules/.surpass-installed
if [ ! -f "$stamp" ] || [ package-lock.json -nt "$stamp" ]; then
  npm ci --ignore-scripts --no-audit --no-fund --loglevel=error
  touch "$stamp"
fi

case $what in
  packages) exit 0 ;;
  report) made=../build/report/report.html sources=(src/viewer src/report src/core report.html) ;;
  studio)
    ../tools/wasm.sh
    made=../build/studio/index.html
    sources=(src/viewer src/studio src/core index.html ../data ../build/wasm/surpass_core.js
             ../build/wasm/surpass_core.wasm)
    ;;
  *)
    echo "tools/web.sh: there is no page '$what'" >&2
    exit 1
    ;;
esac
newer=$([ -f "$made" ] && find "${sources[@]}" build vite.config.ts package-lock.json -newer "$made" -type f -print -quit || echo all)
if [ -n "$newer" ]; then
  npx --no-install vite build --mode "$what"
fi
