#!/usr/bin/env bash
# From a mesh to its interpolating control mesh, proved and shown: tools/demo.sh SURPASS FOLDER
set -euo pipefail
surpass=$1 out=$2
cd "$(dirname "$0")/.."
mkdir -p "$out"

# Shows a command as one would type it, then runs it.
run() {
  echo
  echo "\$ surpass $*"
  "$surpass" "$@"
}

echo "Each mesh is given; Surpass looks for the control mesh whose Loop surface passes through every"
echo "one of its vertices. OpenSubdiv then measures the distance, and both are drawn."
for given in data/jug.obj data/twisted_ring.obj data/trefoil.ply; do
  name=$(basename "${given%.*}")
  run interpolate "$given" -o "$out/$name.control.obj" --tolerance 1e-12 \
    --surface "$out/$name.surface.ply" --levels 3 --report "$out/$name.json"
  run check "$out/$name.control.obj" --against "$given" --tolerance 1e-12 --oracle
  run render "$out/$name.surface.ply" --beside "$given" --points -o "$out/$name.png"
done

echo
echo "The files are in $out: for every mesh NAME.control.obj, the control mesh; NAME.surface.ply,"
echo "its surface; NAME.json, the report; and NAME.png, the given mesh beside the surface."
