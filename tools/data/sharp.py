"""Meshes with creases, corners, holes, colours and texture coordinates."""

import math

from closed import cube, irregular_sphere, octahedron, sphere, touching_octahedra
from mesh import Mesh, boundary_vertices, flipped, halfedges, moved, neighbours, triangulated
from opened import bumpy_patch, disc

INFINITE = 10.0


def edges(mesh):
    return sorted({(min(a, b), max(a, b)) for a, b in halfedges(mesh.faces)})


def crease_loop():
    """A sphere with a sharp equator, drawn in at the poles."""
    mesh = moved(sphere(3, octahedron), lambda p: (p[0], p[1], 0.6 * p[2]))
    level = [abs(p[2]) < 1e-9 for p in mesh.points]
    mesh.creases = [(a, b, INFINITE) for a, b in edges(mesh) if level[a] and level[b]]
    return mesh


def semi_sharp_box(rng):
    """A cube in triangles whose edges have sharpness 0.5 to 3.7, one of them infinite."""
    box = cube()
    mesh = triangulated(box, rng)
    mesh.creases = [(a, b, 0.5 + 0.32 * k) for k, (a, b) in enumerate(edges(box))]
    mesh.creases[5] = mesh.creases[5][:2] + (INFINITE,)
    return mesh


def path(mesh, start, steps, towards, until=frozenset()):
    """Vertices of an edge path that goes as far as it can in a direction, never back, for some
    steps or until it meets one of `until`."""
    near = neighbours(mesh)
    walk = [start]
    while len(walk) <= steps and (len(walk) < 3 or walk[-1] not in until):
        ahead = [w for w in sorted(near[walk[-1]]) if w not in walk]
        walk.append(max(ahead, key=lambda w: sum(a * b for a, b in zip(mesh.points[w], towards))))
    return walk


def darts(rng):
    """Open crease lines that end inside: two ends each."""
    mesh = irregular_sphere(2, 40, rng)
    lines = [path(mesh, 0, 4, (0, -1, 0.2)), path(mesh, 3, 3, (0, 1, -0.2))]
    assert not set(lines[0]) & set(lines[1])
    mesh.creases = [(a, b, INFINITE) for line in lines for a, b in zip(line, line[1:])]
    return mesh


def corners(rng):
    """A sphere with sharp vertices, infinitely and by parts, and three creases that meet."""
    mesh = irregular_sphere(2, 40, rng)
    near = [sorted(n) for n in neighbours(mesh)]
    mesh.corners = [(0, INFINITE), (5, 1.5), (9, 3.0)]
    mesh.creases = [(7, w, INFINITE) for w in near[7][:3]]
    return mesh


def crease_to_boundary(rng):
    """An open sheet with a crease from boundary to boundary and a semi-sharp one that ends inside."""
    mesh = bumpy_patch(rng)
    rim = boundary_vertices(mesh)
    line = path(mesh, 6, 40, (1, 0, 0), rim)
    assert line[0] in rim and line[-1] in rim
    mesh.creases = [(a, b, INFINITE) for a, b in zip(line, line[1:])]
    other = path(mesh, 13 * 13 - 4, 3, (-1, 0, 0))
    assert not set(line) & set(other)
    mesh.creases += [(a, b, 2.3) for a, b in zip(other, other[1:])]
    return mesh


def creased_bowtie():
    """Two octahedra that share a vertex, each with a crease of its own through it."""
    mesh = touching_octahedra()
    mesh.creases = [(0, 2, INFINITE), (0, 3, INFINITE), (0, 7, 1.75), (0, 8, 1.75)]
    return mesh


def creased_quads():
    """A box of quads: a sharp lid, semi-sharp sides, a sharp foot."""
    mesh = moved(cube(), lambda p: (p[0], p[1], 1.5 * p[2]))
    mesh.creases = [(4, 5, INFINITE), (5, 7, INFINITE), (6, 7, INFINITE), (4, 6, INFINITE),
                    (0, 4, 1.25), (1, 5, 2.5)]
    mesh.corners = [(0, INFINITE), (3, 1.5)]
    return mesh


def hole_faces():
    """A disc two of whose faces are in the mesh, but not drawn."""
    mesh = disc(4, 9)
    mesh.holes = [3, 40]
    return mesh


def coloured(rng):
    """Eight bits of red, green and blue per vertex."""
    mesh = irregular_sphere(2, 50, rng)
    mesh.colours = [tuple(int(127.5 * (1 + x / 1.05)) for x in p) for p in mesh.points]
    return mesh


def textured():
    """A triangulated cube unfolded into six islands: a seam along every edge; two groups."""
    box = cube()
    mesh = Mesh(box.points, [])
    for k, (a, b, c, d) in enumerate(box.faces):
        u, v = (k % 3) / 3, (k // 3) / 2
        mesh.texture += [(u, v), (u + 0.3, v), (u + 0.3, v + 0.45), (u, v + 0.45)]
        mesh.faces += [[a, b, c], [a, c, d]]
        mesh.texture_faces += [[4 * k, 4 * k + 1, 4 * k + 2], [4 * k, 4 * k + 2, 4 * k + 3]]
        mesh.groups += ['lid' if k < 2 else 'side'] * 2
    return mesh


def creased_cone(rng):
    """A flipped disc: sharp boundary corners and a crease line through the middle."""
    mesh = flipped(disc(5, 11), rng, 60)
    rim = sorted(boundary_vertices(mesh))
    mesh.corners = [(v, INFINITE) for v in rim[::4]]
    line = path(mesh, 0, 3, (math.cos(1.0), math.sin(1.0), 0))
    mesh.creases = [(a, b, INFINITE) for a, b in zip(line, line[1:])]
    return mesh
