"""A polygon mesh for generators: plain lists, checks, and the few operations that shapes need."""

import math
from dataclasses import dataclass, field


@dataclass
class Mesh:
    points: list
    faces: list
    creases: list = field(default_factory=list)  # (a, b, sharpness)
    corners: list = field(default_factory=list)  # (vertex, sharpness)
    holes: list = field(default_factory=list)  # faces
    colours: list = field(default_factory=list)  # (red, green, blue) per vertex, 0..255
    texture: list = field(default_factory=list)  # (u, v) rows
    texture_faces: list = field(default_factory=list)  # a row of `texture` per face corner
    groups: list = field(default_factory=list)  # a name per face


def halfedges(faces):
    """The face of every directed edge."""
    return {(f[i - 1], f[i]): k for k, f in enumerate(faces) for i in range(len(f))}


def boundary_vertices(mesh):
    half = halfedges(mesh.faces)
    return {v for a, b in half if (b, a) not in half for v in (a, b)}


def neighbours(mesh):
    """A set of edge neighbours per vertex."""
    near = [set() for _ in mesh.points]
    for a, b in halfedges(mesh.faces):
        near[a].add(b)
        near[b].add(a)
    return near


def volume(mesh):
    """Signed volume of a closed mesh, positive when faces look outward."""
    total = 0.0
    for f in mesh.faces:
        a = mesh.points[f[0]]
        for i in range(1, len(f) - 1):
            b, c = mesh.points[f[i]], mesh.points[f[i + 1]]
            total += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                      + a[2] * (b[0] * c[1] - b[1] * c[0]))
    return total / 6


def is_closed(mesh):
    half = halfedges(mesh.faces)
    return all((b, a) in half for a, b in half)


def check(name, mesh):
    """Refuses what no mesh of this collection may be: every edge belongs to one or two faces that
    agree on the orientation, and closed meshes look outward."""
    seen = set()
    for f in mesh.faces:
        assert len(f) >= 3 and len(set(f)) == len(f), f'{name}: face {f}'
        assert all(0 <= v < len(mesh.points) for v in f), f'{name}: face {f}'
        for i in range(len(f)):
            edge = (f[i - 1], f[i])
            assert edge not in seen, f'{name}: edge {edge} twice in one direction'
            seen.add(edge)
    if is_closed(mesh):
        assert volume(mesh) > 0, f'{name}: faces look inward'
    for a, b, _ in mesh.creases:
        assert (a, b) in seen or (b, a) in seen, f'{name}: crease {a}-{b} is no edge'
    assert len(set(mesh.points)) == len(mesh.points), f'{name}: coincident vertices'


def flipped(mesh, rng, times, least=4):
    """Flips random edges between two triangles. Valences stay at `least` or more, and no edge is
    made twice."""
    faces = [list(f) for f in mesh.faces]
    half = halfedges(faces)
    near = neighbours(mesh)
    for _ in range(times):
        f = rng.randrange(len(faces))
        i = rng.randrange(3)
        a, b, c = faces[f][i], faces[f][(i + 1) % 3], faces[f][(i + 2) % 3]
        g = half.get((b, a))
        if g is None:
            continue
        d = next(v for v in faces[g] if v not in (a, b))
        if d in near[c] or min(len(near[a]), len(near[b])) <= least:
            continue
        faces[f], faces[g] = [a, d, c], [d, b, c]
        for k in (f, g):
            for j in range(3):
                half[(faces[k][j - 1], faces[k][j])] = k
        del half[(a, b)], half[(b, a)]
        near[a].discard(b)
        near[b].discard(a)
        near[c].add(d)
        near[d].add(c)
    return Mesh(mesh.points, faces)


def triangulated(mesh, rng=None):
    """Cuts quads along a diagonal: the first one, or a random one."""
    faces = []
    for f in mesh.faces:
        if len(f) == 3:
            faces.append(list(f))
            continue
        a, b, c, d = f if rng is None or rng.random() < 0.5 else f[1:] + f[:1]
        faces += [[a, b, c], [a, c, d]]
    return Mesh(mesh.points, faces)


def merged(mesh, rng, times, most=6):
    """Joins random neighbouring faces into polygons of at most `most` corners. Every vertex keeps
    at least three edges."""
    faces = [list(f) for f in mesh.faces]
    near = neighbours(mesh)
    for _ in range(times):
        half = halfedges([f or [] for f in faces])
        a, b = rng.choice(sorted(half))
        f, g = half[(a, b)], half.get((b, a))
        if g is None or min(len(near[a]), len(near[b])) <= 3:
            continue
        if len(set(faces[f]) & set(faces[g])) != 2 or len(faces[f]) + len(faces[g]) - 2 > most:
            continue
        i, j = faces[f].index(b), faces[g].index(a)
        faces[f] = faces[f][i:] + faces[f][:i] + (faces[g][j:] + faces[g][:j])[1:-1]
        faces[g] = []
        near[a].discard(b)
        near[b].discard(a)
    return Mesh(mesh.points, [f for f in faces if f])


def dual(mesh):
    """A vertex per face and a face per vertex of a closed mesh."""
    half = halfedges(mesh.faces)
    points = [tuple(sum(mesh.points[v][k] for v in f) / len(f) for k in range(3))
              for f in mesh.faces]
    first = {}
    for (a, _), f in half.items():
        first.setdefault(a, f)
    faces = []
    for v in range(len(mesh.points)):
        ring, f = [], first[v]
        while f not in ring:
            ring.append(f)
            corners = mesh.faces[f]
            f = half[(v, corners[corners.index(v) - 1])]
        faces.append(ring)
    return Mesh(points, faces)


def without(mesh, removed):
    """The mesh without these faces and without the vertices that nothing uses any more."""
    faces = [f for k, f in enumerate(mesh.faces) if k not in removed]
    used = sorted({v for f in faces for v in f})
    number = {v: i for i, v in enumerate(used)}
    return Mesh([mesh.points[v] for v in used], [[number[v] for v in f] for f in faces])


def together(meshes):
    """Several parts in one mesh."""
    points, faces = [], []
    for m in meshes:
        faces += [[v + len(points) for v in f] for f in m.faces]
        points += m.points
    return Mesh(points, faces)


def moved(mesh, move):
    """The same faces with move(point) for every point."""
    return Mesh([move(p) for p in mesh.points], mesh.faces)


def unit(p):
    length = math.sqrt(sum(x * x for x in p))
    return tuple(x / length for x in p)


def smoothed(mesh, steps):
    """Moves every vertex to the mean of its neighbours, several times."""
    points = list(mesh.points)
    near = [sorted(n) for n in neighbours(mesh)]
    for _ in range(steps):
        points = [tuple(sum(points[w][k] for w in n) / len(n) for k in range(3)) for n in near]
    return Mesh(points, mesh.faces)
