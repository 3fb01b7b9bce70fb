"""Meshes with boundaries."""

import math

from closed import grid, irregular_sphere, quad_torus
from mesh import (Mesh, boundary_vertices, flipped, halfedges, moved, neighbours, together,
                  triangulated, without)


def boundary_configurations(mesh):
    """What Hoppe's boundary rule tells apart: is a boundary vertex regular (R, four edges) or not
    (E), and what are its two neighbours along the boundary?"""
    near = neighbours(mesh)
    rim = boundary_vertices(mesh)
    kind = {v: 'R' if len(near[v]) == 4 else 'E' for v in rim}
    half = halfedges(mesh.faces)
    along = {v: [] for v in rim}
    for a, b in half:
        if (b, a) not in half:
            along[a].append(b)
            along[b].append(a)
    return {kind[v] + ':' + ''.join(sorted(kind[w] for w in along[v])) for v in rim}


def height(x, y):
    return 0.3 * math.sin(2.1 * x) * math.cos(1.7 * y) + 0.1 * x * y


def bumpy_patch(rng):
    """Irregular valences inside and on the boundary."""
    n = 13
    def at(i, j):
        x = 4 * i / (n - 1) - 2 + 0.1 * (rng.random() - 0.5)
        y = 4 * j / (n - 1) - 2 + 0.1 * (rng.random() - 0.5)
        return (x, y, height(x, y))
    return flipped(triangulated(grid(n, n, at), rng), rng, 150)


def patch_of_all_cases(rng):
    mesh = bumpy_patch(rng)
    assert len(boundary_configurations(mesh)) == 6, boundary_configurations(mesh)
    return mesh


def disc(rings, sectors):
    """Around a vertex of valence `sectors`."""
    points, faces = [(0., 0., 0.5)], []
    for i in range(1, rings + 1):
        for j in range(sectors):
            a, r = 2 * math.pi * (j + 0.5 * (i % 2)) / sectors, i / rings
            points.append((r * math.cos(a), r * math.sin(a), 0.5 * math.cos(2 * r) + 0.0))
    faces += [[0, 1 + j, 1 + (j + 1) % sectors] for j in range(sectors)]
    for i in range(rings - 1):
        for j in range(sectors):
            k = (j + 1) % sectors
            a, b = 1 + i * sectors + j, 1 + i * sectors + k
            c, d = a + sectors, b + sectors
            faces += [[a, c, d], [a, d, b]]
    return Mesh(points, faces)


def tube(rng):
    """Two boundary loops."""
    def at(i, j):
        a = 2 * math.pi * j / 12
        r = 0.5 + 0.15 * math.sin(0.6 * i)
        return (r * math.cos(a), r * math.sin(a), -0.25 * i)
    return flipped(triangulated(grid(10, 12, at, False, True), rng), rng, 60)


def holed_patch(rng):
    """Four loops: three windows in a sheet."""
    windows = {(2, 2), (2, 3), (3, 2), (3, 3), (6, 8), (7, 8), (9, 3)}
    n = 12
    mesh = grid(n, n, lambda i, j: (0.3 * i, 0.3 * j, height(0.3 * i, 0.3 * j)))
    cut = {i * (n - 1) + j for i, j in windows}
    return triangulated(without(mesh, cut), rng)


def triangle():
    return Mesh([(0., 0., 0.), (1., 0., 0.), (0., 1., 0.25)], [[0, 1, 2]])


def strip(length):
    """Triangles in a row: no vertex inside."""
    points = [(0.5 * i, float(i % 2), 0.2 * math.sin(i)) for i in range(length + 2)]
    return Mesh(points, [[i, i + 1, i + 2] if i % 2 else [i, i + 2, i + 1] for i in range(length)])


def bowtie():
    """Two sheets that share one vertex and nothing else."""
    sheet = disc(2, 6)
    left = moved(sheet, lambda p: (p[0] - 1, p[1], p[2]))
    tip = max(range(len(left.points)), key=lambda v: left.points[v][0])
    number = [tip if v == tip else len(left.points) + v - (v > tip) for v in range(len(left.points))]
    x = left.points[tip][0]
    # Half a turn about the shared vertex keeps the orientation of the faces.
    y = left.points[tip][1]
    other = [(2 * x - p[0], 2 * y - p[1], p[2]) for k, p in enumerate(left.points) if k != tip]
    return Mesh(left.points + other, left.faces + [[number[v] for v in f] for f in left.faces])


def isolated(rng):
    """A patch and three vertices without faces, at the start, in the middle and at the end."""
    patch = moved(triangulated(grid(4, 4, lambda i, j: (float(i), float(j), height(i, j))), rng),
                  lambda p: p)
    number = [1 + v + (v >= 8) for v in range(16)]
    points = [(9., 9., 9.)] + patch.points[:8] + [(9., 0., 1.)] + patch.points[8:] + [(-9., 0., 2.)]
    return Mesh(points, [[number[v] for v in f] for f in patch.faces])


def quad_patch():
    """An open sheet of quads with one corner cut off by a triangle."""
    mesh = grid(7, 6, lambda i, j: (0.5 * i, 0.5 * j, height(0.5 * i, 0.5 * j)))
    mesh.faces[0] = mesh.faces[0][1:]
    return without(mesh, set())


def half_torus():
    """Quads: half of a torus, two loops."""
    mesh = quad_torus(16, 10)
    return without(mesh, set(range(80, 160)))


def three_parts(rng):
    """A sphere, a torus and a disc."""
    ring = flipped(triangulated(quad_torus(12, 6), rng), rng, 40)
    return together([irregular_sphere(1, 20, rng),
                     moved(ring, lambda p: (p[0] + 3, p[1], p[2])),
                     moved(disc(2, 7), lambda p: (p[0], p[1] + 3, p[2]))])
