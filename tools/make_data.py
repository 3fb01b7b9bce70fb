#!/usr/bin/env python3
"""Makes the meshes of data/ and the table in data/README.md. Run it without arguments after a
change; `--check` makes nothing and fails if the folder differs from what would be made."""

import random
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent / 'data'))

import closed  # noqa: E402
import files  # noqa: E402
import opened  # noqa: E402
import pictures  # noqa: E402
import sharp  # noqa: E402
from mesh import check, is_closed  # noqa: E402

# File, format where the ending does not say it, maker (with its own random numbers), purpose.
MESHES = [
    ('octahedron.obj', '', lambda r: closed.octahedron(), 'smallest smooth case: its control points are 55/24 of it'),
    ('tetrahedron.stl', 'stl (text)', lambda r: closed.tetrahedron(), 'valence 3 only; STL as text'),
    ('bipyramid.off', '', lambda r: closed.pentagonal_bipyramid(), 'valences 4 and 5'),
    ('sphere_irregular.obj', '', lambda r: closed.irregular_sphere(3, 500, r), 'valences 4 to 12 by random edge flips'),
    ('torus_irregular.off', '', closed.torus, 'genus 1'),
    ('double_torus.obj', '', closed.double_torus, 'genus 2'),
    ('stellated.off', '', lambda r: closed.stellated(), 'valences 3 and 10 side by side'),
    ('blob.stl', '', closed.blob, 'six times as long as wide; binary STL'),
    ('pole40.obj', '', lambda r: closed.pole(40, 5), 'two vertices of valence 40'),
    ('touching_octahedra.obj', '', lambda r: closed.touching_octahedra(), 'bow-tie of two closed fans'),
    ('three_parts.ply', '', opened.three_parts, 'three components, two closed and one open; binary PLY'),
    ('patch_irregular.obj', '', opened.patch_of_all_cases, 'a boundary with all six cases of the rule `hoppe`'),
    ('disc.ply', 'ply (big endian)', lambda r: opened.disc(5, 9), 'valence 9 in the middle; big-endian PLY'),
    ('tube.obj', '', opened.tube, 'two boundary loops'),
    ('patch_holes.off', '', opened.holed_patch, 'four boundary loops'),
    ('triangle.off', '', lambda r: opened.triangle(), 'a single face'),
    ('strip.obj', '', lambda r: opened.strip(9), 'no interior vertex'),
    ('bowtie.obj', '', lambda r: opened.bowtie(), 'bow-tie of two open fans'),
    ('isolated.obj', '', opened.isolated, 'three vertices without faces'),
    ('cube.obj', '', lambda r: closed.cube(), 'quads, every valence 3'),
    ('truncated_octahedron.off', '', lambda r: closed.truncated_octahedron(), 'squares and hexagons'),
    ('dual_sphere.ply', 'ply (text)', closed.dual_sphere, 'polygons of many sizes, every valence 3; PLY as text'),
    ('mixed_polygons.obj', '', closed.mixed_polygons, 'triangles, quads, pentagons, hexagons'),
    ('quad_torus.obj', '', lambda r: closed.quad_torus(16, 10), 'regular quads, genus 1'),
    ('quad_patch.ply', 'ply (text)', lambda r: opened.quad_patch(), 'open quads and one triangle'),
    ('half_torus.obj', '', lambda r: opened.half_torus(), 'open quads, two loops'),
    ('crease_loop.obj', '', lambda r: sharp.crease_loop(), 'a closed sharp crease'),
    ('crease_semi_sharp.obj', '', sharp.semi_sharp_box, 'twelve different sharpnesses'),
    ('crease_darts.obj', '', sharp.darts, 'creases that end inside'),
    ('crease_corners.obj', '', sharp.corners, 'sharp vertices and three creases that meet'),
    ('crease_boundary.obj', '', sharp.crease_to_boundary, 'creases that meet a boundary'),
    ('crease_bowtie.obj', '', lambda r: sharp.creased_bowtie(), 'creases through a bow-tie'),
    ('crease_cone.obj', '', sharp.creased_cone, 'sharp boundary vertices and a crease with darts'),
    ('crease_quads.ply', 'ply (text)', lambda r: sharp.creased_quads(), 'creases and corners as PLY elements'),
    ('hole_faces.obj', '', lambda r: sharp.hole_faces(), 'faces marked as holes'),
    ('coloured.ply', '', sharp.coloured, 'eight-bit colours per vertex'),
    ('textured.obj', '', lambda r: sharp.textured(), 'texture coordinates with seams, two groups'),
    ('jug.obj', '', lambda r: pictures.jug(), 'for pictures: spout, handle, thick wall'),
    ('twisted_ring.obj', '', lambda r: pictures.twisted_ring(), 'for pictures: a ring that turns by a third'),
    ('trefoil.ply', '', lambda r: pictures.trefoil(), 'for pictures: a knotted tube'),
]

HEAD = """# Meshes

Made by `tools/make_data.py`; nothing here was drawn or measured by anyone else. The meshes are in
the public domain (CC0 1.0). Creases, corners and holes in OBJ files are OpenSubdiv's `t` lines.

| file | vertices | faces | closed | what it is for | licence |
|---|---:|---:|---|---|---|
"""


def make():
    """The bytes of every file of the folder."""
    made, table = {}, HEAD
    for name, kind, maker, purpose in MESHES:
        mesh = maker(random.Random(name))
        mesh.points = files.rounded(mesh.points)
        check(name, mesh)
        made[name] = files.WRITERS[kind or name.rsplit('.', 1)[1]](mesh)
        closed_word = 'yes' if is_closed(mesh) else 'no'
        table += (f'| {name} | {len(mesh.points)} | {len(mesh.faces)} | {closed_word} '
                  f'| {purpose} | CC0 |\n')
    made['README.md'] = table.encode()
    return made


def main():
    folder = Path(__file__).resolve().parent.parent / 'data'
    made = make()
    if '--check' in sys.argv[1:]:
        different = [n for n, b in made.items()
                     if not (folder / n).is_file() or (folder / n).read_bytes() != b]
        different += sorted(p.name for p in folder.iterdir() if p.name not in made)
        if different:
            sys.exit('data/ is not what tools/make_data.py makes: ' + ', '.join(different))
        return
    folder.mkdir(exist_ok=True)
    for name, content in made.items():
        (folder / name).write_bytes(content)
    print(f'{len(MESHES)} meshes, {sum(map(len, made.values()))} bytes in {folder.name}/')


if __name__ == '__main__':
    main()
