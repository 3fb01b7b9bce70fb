#!/usr/bin/env bash
# Compiles the core to WebAssembly, for the studio: build/wasm/surpass_core.js and .wasm.
set -euo pipefail
cd "$(dirname "$0")/.."
export NODE_PATH=${NODE_PATH:-/usr/share/nodejs}  # where Debian keeps acorn, which emcc needs
if [ ! -f build/wasm/CMakeCache.txt ]; then
  emcmake cmake -S bindings/wasm -B build/wasm -G Ninja -DCMAKE_BUILD_TYPE=Release \
    --log-level=WARNING > /dev/null
fi
cmake --build build/wasm -j "${JOBS:-$(nproc)}" -- --quiet
