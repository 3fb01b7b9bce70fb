#!/usr/bin/env bash
# Draws the pictures of docs/images that need no further meshes: tools/pictures.sh SURPASS FOLDER
set -euo pipefail
surpass=$1 out=$2
cd "$(dirname "$0")/.."

# Every style that shows how good a surface is, on the plain Loop surface of a mesh.
"$surpass" render data/jug.obj -o "$out/styles.png" --levels 4 --size 560x440 --columns 2 \
  --style reflection,curvature,gaussian,error --camera 25,15 --quiet

# The README's: a mesh and the surface through its vertices.
control=$(mktemp --suffix=.ply)
trap 'rm -f "$control"' EXIT
"$surpass" interpolate data/jug.obj -o "$control" --quiet
"$surpass" render "$control" --beside data/jug.obj --points -o "$out/hero.png" --levels 4 \
  --size 800x700 --quiet
