"""Shapes worth looking at."""

import math

from closed import grid
from mesh import Mesh, without, triangulated


def twisted_ring():
    """A ring whose cross-section, a rounded triangle, turns by a third while it goes round."""
    rows, columns = 64, 15

    def at(i, j):
        a = 2 * math.pi * i / rows
        # A third of a turn brings the triangle onto itself, so the ring closes.
        b = 2 * math.pi * j / columns
        r = 0.36 + 0.09 * math.cos(3 * b) + 0.05 * math.cos(3 * a)
        t = b + a / 3
        return ((1 + r * math.cos(t)) * math.cos(a), (1 + r * math.cos(t)) * math.sin(a),
                r * math.sin(t))

    mesh = grid(rows, columns, at)
    # The last row meets the first one, a third of the columns further.
    shift = columns // 3
    faces = []
    for i in range(rows):
        for j in range(columns):
            k = (j + 1) % columns
            if i + 1 < rows:
                below = [(i + 1) * columns + j, (i + 1) * columns + k]
            else:
                below = [(j + shift) % columns, (k + shift) % columns]
            faces.append([i * columns + j, below[0], below[1], i * columns + k])
    return triangulated(Mesh(mesh.points, faces))


def trefoil():
    """A tube along a trefoil knot, its frame carried along without spin."""
    rows, columns = 96, 9

    def curve(t):
        return (math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t),
                -1.2 * math.sin(3 * t))

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    def unit(a):
        length = math.sqrt(sum(x * x for x in a))
        return tuple(x / length for x in a)

    centres = [curve(2 * math.pi * i / rows) for i in range(rows)]
    tangents = [unit(tuple(centres[(i + 1) % rows][k] - centres[i - 1][k] for k in range(3)))
                for i in range(rows)]
    frames, side = [], (0., 0., 1.)
    for t in tangents + tangents[:1]:
        up = unit(cross(t, side))
        side = cross(up, t)
        frames.append((side, up))
    # What the frame has turned after one round is undone evenly along the way.
    (s, u), (s0, _) = frames[-1], frames[0]
    turn = math.atan2(sum(a * b for a, b in zip(s0, u)), sum(a * b for a, b in zip(s0, s)))

    def at(i, j):
        a = -2 * math.pi * j / columns + turn * i / rows
        s, u = frames[i]
        return tuple(centres[i][k] + 0.55 * (math.cos(a) * s[k] + math.sin(a) * u[k])
                     for k in range(3))

    return triangulated(grid(rows, columns, at, True, True))


# Radius and height of the jug's wall, from the middle of the foot outside, over the lip, to the
# middle of the floor inside.
PROFILE = [(0.30, 0.00), (0.52, 0.00), (0.60, 0.06), (0.66, 0.20), (0.74, 0.40), (0.80, 0.62),
           (0.82, 0.85), (0.79, 1.08), (0.71, 1.30), (0.60, 1.50), (0.51, 1.68), (0.47, 1.85),
           (0.48, 2.02), (0.54, 2.17), (0.57, 2.22), (0.53, 2.23), (0.45, 2.12), (0.40, 1.98),
           (0.39, 1.84), (0.43, 1.66), (0.52, 1.47), (0.63, 1.27), (0.71, 1.06), (0.73, 0.85),
           (0.71, 0.63), (0.65, 0.42), (0.57, 0.26), (0.46, 0.16), (0.26, 0.13)]
SECTORS = 28


def jug_wall():
    def at(i, j):
        radius, height = PROFILE[i]
        a = 2 * math.pi * j / SECTORS
        # The lip is drawn out into a spout opposite the handle.
        spout = 0.22 * math.exp(-((height - 2.3) / 0.22) ** 2) * max(0.0, -math.cos(a)) ** 5
        r = radius + spout
        return (r * math.cos(a), height + 0.3 * spout, r * math.sin(a))

    mesh = grid(len(PROFILE), SECTORS, at, False, True)
    foot, floor = len(mesh.points), len(mesh.points) + 1
    last = (len(PROFILE) - 1) * SECTORS
    for j in range(SECTORS):
        k = (j + 1) % SECTORS
        mesh.faces += [[foot, j, k], [floor, last + k, last + j]]
    return Mesh(mesh.points + [(0., 0., 0.), (0., 0.12, 0.)], mesh.faces)


def ring_around(row):
    """The eight vertices around the 2 by 2 quads whose middle is in this row, at the handle."""
    way = ((-1, -1), (-1, 0), (-1, 1), (0, 1), (1, 1), (1, 0), (1, -1), (0, -1))
    return [(row + i) * SECTORS + j % SECTORS for i, j in way]


def handle_ring(t):
    """The eight points of the handle's cross-section at t of the way along a Bezier curve."""
    control = ((0.48, 1.85), (1.15, 2.10), (1.60, 1.00), (0.80, 0.85))
    weights = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
    slopes = (-3 * (1 - t) ** 2, 3 * (1 - t) * (1 - 3 * t), 3 * t * (2 - 3 * t), 3 * t * t)
    x, y = (sum(w * p[k] for w, p in zip(weights, control)) for k in range(2))
    dx, dy = (sum(w * p[k] for w, p in zip(slopes, control)) for k in range(2))
    length = math.hypot(dx, dy)
    ring = []
    for k in range(8):
        angle = math.pi * (k - 1) / 4
        out, across = -0.10 * math.cos(angle), 0.13 * math.sin(angle)
        ring.append((x - out * dy / length, y + out * dx / length, across))
    return ring


def jug():
    """A jug: a wall of two sides, a spout, and a handle that is grown between two openings."""
    wall = jug_wall()
    low, high, steps = 6, 11, 12
    opened = {(row + i) * SECTORS + j % SECTORS for row in (low, high) for i in (-1, 0)
              for j in (-1, 0)}
    points, faces = list(wall.points), [f for k, f in enumerate(wall.faces) if k not in opened]
    previous = ring_around(high)
    # The lower opening is met upside down.
    end = [ring_around(low)[k] for k in (6, 5, 4, 3, 2, 1, 0, 7)]
    for s in range(1, steps + 1):
        ring = end if s == steps else list(range(len(points), len(points) + 8))
        points += [] if s == steps else handle_ring(s / steps)
        for k in range(8):
            n = (k + 1) % 8
            faces.append([previous[n], previous[k], ring[k], ring[n]])
        previous = ring
    return triangulated(without(Mesh(points, faces), set()))
