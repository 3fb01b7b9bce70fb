"""Closed meshes: platonic starts, spheres, tori, polygons."""

import math

from mesh import Mesh, dual, flipped, merged, moved, smoothed, triangulated, unit


def octahedron():
    points = [(1., 0., 0.), (-1., 0., 0.), (0., 1., 0.), (0., -1., 0.), (0., 0., 1.), (0., 0., -1.)]
    faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
    return Mesh(points, faces)


def tetrahedron():
    points = [(1., 1., 1.), (-1., -1., 1.), (-1., 1., -1.), (1., -1., -1.)]
    return Mesh(points, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])


def icosahedron():
    g = (1 + math.sqrt(5)) / 2
    points = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g),
              (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [[0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11], [1, 5, 9], [5, 11, 4],
             [11, 10, 2], [10, 7, 6], [7, 1, 8], [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8],
             [3, 8, 9], [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1]]
    return Mesh([unit(p) for p in points], faces)


def cube():
    points = [(float(x), float(y), float(z)) for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)]
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return Mesh(points, faces)


def pentagonal_bipyramid():
    ring = [(math.cos(0.4 * math.pi * i), math.sin(0.4 * math.pi * i), 0.) for i in range(5)]
    faces = [[i, (i + 1) % 5, 5] for i in range(5)] + [[(i + 1) % 5, i, 6] for i in range(5)]
    return Mesh(ring + [(0., 0., 0.8), (0., 0., -0.8)], faces)


def split(mesh):
    """Every triangle into four."""
    points, number, faces = list(mesh.points), {}, []

    def middle(a, b):
        key = (min(a, b), max(a, b))
        if key not in number:
            number[key] = len(points)
            points.append(tuple((mesh.points[a][k] + mesh.points[b][k]) / 2 for k in range(3)))
        return number[key]

    for a, b, c in mesh.faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        faces += [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
    return Mesh(points, faces)


def sphere(levels, start=icosahedron):
    mesh = start()
    for _ in range(levels):
        mesh = moved(split(mesh), unit)
    return moved(mesh, unit)


def irregular_sphere(levels, flips, rng, wobble=0.02):
    mesh = flipped(sphere(levels), rng, flips)
    return moved(mesh, lambda p: tuple(x * (1 + wobble * (rng.random() - 0.5)) for x in p))


def blob(rng):
    """Six times as long as wide, with waves."""
    def move(p):
        wave = 1 + 0.25 * math.sin(5 * p[0] + 1) * math.cos(3 * p[1])
        return (3 * p[0], 0.5 * wave * p[1], 0.5 * wave * p[2] + 0.2 * math.sin(2 * p[0]))
    return moved(flipped(sphere(2), rng, 60), move)


def grid(rows, columns, at, wrap_rows=False, wrap_columns=False):
    """Quads over at(i, j); wrapped directions close on themselves."""
    points = [at(i, j) for i in range(rows) for j in range(columns)]
    faces = []
    for i in range(rows if wrap_rows else rows - 1):
        for j in range(columns if wrap_columns else columns - 1):
            k, n = (i + 1) % rows, (j + 1) % columns
            faces.append([i * columns + j, k * columns + j, k * columns + n, i * columns + n])
    return Mesh(points, faces)


def quad_torus(rows, columns, tube=0.4):
    def at(i, j):
        a, b = 2 * math.pi * i / rows, 2 * math.pi * j / columns
        r = 1 + tube * math.cos(b)
        return (r * math.cos(a), r * math.sin(a), tube * math.sin(b))
    return grid(rows, columns, at, True, True)


def torus(rng):
    mesh = flipped(triangulated(quad_torus(24, 12), rng), rng, 250)
    return moved(mesh, lambda p: tuple(x + 0.02 * (rng.random() - 0.5) for x in p))


def pole(valence, rings):
    """A sphere with two poles of this valence."""
    def at(i, j):
        a = math.pi * (i + 1) / (rings + 1)
        b = 2 * math.pi * (j + 0.5 * (i % 2)) / valence
        return (math.sin(a) * math.cos(b), math.sin(a) * math.sin(b), math.cos(a))
    mesh = triangulated(grid(rings, valence, at, False, True))
    top, bottom = len(mesh.points), len(mesh.points) + 1
    last = (rings - 1) * valence
    faces = [[top, j, (j + 1) % valence] for j in range(valence)]
    faces += [[bottom, last + (j + 1) % valence, last + j] for j in range(valence)]
    return Mesh(mesh.points + [(0., 0., 1.), (0., 0., -1.)], mesh.faces + faces)


def stellated():
    """A spike of valence 3 on every face of an icosahedron."""
    base = icosahedron()
    points, faces = list(base.points), []
    for a, b, c in base.faces:
        tip = len(points)
        points.append(tuple(0.6 * sum(base.points[v][k] for v in (a, b, c)) for k in range(3)))
        faces += [[a, b, tip], [b, c, tip], [c, a, tip]]
    return Mesh(points, faces)


def solid(cells):
    """The quads around a set of unit cells."""
    number, points, faces = {}, [], []

    def vertex(p):
        if p not in number:
            number[p] = len(points)
            points.append(tuple(map(float, p)))
        return number[p]

    for cell in sorted(cells):
        for axis in range(3):
            u, w = (axis + 1) % 3, (axis + 2) % 3
            for side in (0, 1):
                beyond = list(cell)
                beyond[axis] += 2 * side - 1
                if tuple(beyond) in cells:
                    continue
                face = []
                for du, dw in ((0, 0), (1, 0), (1, 1), (0, 1)):
                    p = list(cell)
                    p[axis] += side
                    p[u] += du
                    p[w] += dw
                    face.append(vertex(tuple(p)))
                faces.append(face if side else face[::-1])
    return Mesh(points, faces)


def double_torus(rng):
    """Genus 2: a smoothed slab with two windows."""
    windows = {(x, y) for x in (2, 3, 6, 7) for y in (2, 3)}
    cells = {(x, y, z) for x in range(10) for y in range(6) for z in range(2)
             if (x, y) not in windows}
    return flipped(smoothed(triangulated(solid(cells), rng), 2), rng, 120)


def touching_octahedra():
    """Two octahedra that share one vertex: a bow-tie with two closed fans."""
    a = octahedron()
    points = a.points + [(p[0] + 2, p[1], p[2]) for k, p in enumerate(a.points) if k != 1]
    number = [6, 0, 7, 8, 9, 10]
    return Mesh(points, a.faces + [[number[v] for v in f] for f in a.faces])


def truncated_octahedron():
    """All permutations of (0, +-1, +-2): squares and hexagons, every valence 3."""
    points = sorted({tuple(float(x) for x in p) for a in (-1, 1) for b in (-2, 2)
                     for p in ((0, a, b), (0, b, a), (a, 0, b), (b, 0, a), (a, b, 0), (b, a, 0))})
    axes = [unit(n) for n in ((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1))]
    axes += [unit((x, y, z)) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    faces = []
    for n in axes:
        height = [sum(a * b for a, b in zip(n, p)) for p in points]
        top = [v for v, h in enumerate(height) if h > max(height) - 1e-9]
        u = unit(tuple(points[top[0]][k] - max(height) * n[k] for k in range(3)))
        w = (n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0])
        top.sort(key=lambda v: math.atan2(sum(a * b for a, b in zip(w, points[v])),
                                          sum(a * b for a, b in zip(u, points[v]))))
        faces.append(top)
    return Mesh(points, faces)


def dual_sphere(rng):
    """Polygons of 4 to 9 corners, every valence 3."""
    return moved(dual(irregular_sphere(2, 80, rng)), unit)


def mixed_polygons(rng):
    """Triangles, quads, pentagons and hexagons."""
    return merged(irregular_sphere(2, 60, rng), rng, 400)
