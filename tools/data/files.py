"""Writers for OBJ, PLY, OFF and STL. Positions are rounded first, so that the last digits of a
machine's sine do not decide the bytes of a file."""

import struct

DIGITS = 6


def rounded(points):
    """Points on a grid of 1e-6, without negative zeros."""
    return [tuple(round(x, DIGITS) + 0.0 for x in p) for p in points]


def number(x):
    text = f'{x:.{DIGITS}f}'.rstrip('0').rstrip('.')
    return '0' if text in ('', '-0') else text


def row(values):
    return ' '.join(number(x) for x in values)


def obj(mesh):
    lines = ['v ' + row(p) for p in mesh.points]
    lines += ['vt ' + row(t) for t in mesh.texture]
    group = None
    for k, face in enumerate(mesh.faces):
        if mesh.groups and mesh.groups[k] != group:
            group = mesh.groups[k]
            lines.append('g ' + group)
        if mesh.texture_faces:
            words = [f'{v + 1}/{t + 1}' for v, t in zip(face, mesh.texture_faces[k])]
        else:
            words = [str(v + 1) for v in face]
        lines.append('f ' + ' '.join(words))
    lines += [f't crease 2/1/0 {a} {b} {number(s)}' for a, b, s in mesh.creases]
    lines += [f't corner 1/1/0 {v} {number(s)}' for v, s in mesh.corners]
    lines += [f't hole 1/0/0 {f}' for f in mesh.holes]
    return ('\n'.join(lines) + '\n').encode()


def off(mesh):
    lines = ['OFF', f'{len(mesh.points)} {len(mesh.faces)} 0']
    lines += [row(p) for p in mesh.points]
    lines += [' '.join(map(str, [len(f)] + list(f))) for f in mesh.faces]
    return ('\n'.join(lines) + '\n').encode()


def ply_header(mesh, encoding):
    corner = dict(mesh.corners)
    lines = ['ply', f'format {encoding} 1.0', f'element vertex {len(mesh.points)}']
    lines += [f'property double {axis}' for axis in 'xyz']
    lines += [f'property uchar {c}' for c in ('red', 'green', 'blue')] if mesh.colours else []
    lines += ['property float sharpness'] if corner else []
    lines += [f'element face {len(mesh.faces)}', 'property list uchar int vertex_indices']
    if mesh.creases:
        lines += [f'element edge {len(mesh.creases)}', 'property int vertex1',
                  'property int vertex2', 'property float sharpness']
    return ('\n'.join(lines + ['end_header']) + '\n').encode()


def ply(mesh, encoding):
    """`encoding` is ascii, binary_little_endian or binary_big_endian."""
    corner = dict(mesh.corners)
    rows = []
    for v, p in enumerate(mesh.points):
        colour = list(mesh.colours[v]) if mesh.colours else []
        sharp = [corner.get(v, 0.0)] if corner else []
        rows.append(('3d%dB%df' % (len(colour), len(sharp)), list(p) + colour + sharp))
    rows += [('B%di' % len(f), [len(f)] + list(f)) for f in mesh.faces]
    rows += [('2if', list(c)) for c in mesh.creases]
    if encoding == 'ascii':
        body = ''.join(row(values) + '\n' for _, values in rows).encode()
    else:
        order = '<' if encoding == 'binary_little_endian' else '>'
        body = b''.join(struct.pack(order + kind, *values) for kind, values in rows)
    return ply_header(mesh, encoding) + body


def normal(a, b, c):
    u = [b[k] - a[k] for k in range(3)]
    w = [c[k] - a[k] for k in range(3)]
    n = (u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0])
    length = sum(x * x for x in n) ** 0.5
    return tuple(x / length for x in n)


def stl_ascii(mesh):
    lines = ['solid surpass']
    for f in mesh.faces:
        corners = [mesh.points[v] for v in f]
        lines += ['facet normal ' + row(normal(*corners)), 'outer loop']
        lines += ['vertex ' + row(p) for p in corners]
        lines += ['endloop', 'endfacet']
    return ('\n'.join(lines + ['endsolid surpass']) + '\n').encode()


def stl_binary(mesh):
    parts = [b'made by tools/make_data.py'.ljust(80), struct.pack('<I', len(mesh.faces))]
    for f in mesh.faces:
        corners = [mesh.points[v] for v in f]
        values = [x for p in [normal(*corners)] + corners for x in p]
        parts.append(struct.pack('<12fH', *values, 0))
    return b''.join(parts)


WRITERS = {
    'obj': obj,
    'off': off,
    'ply': lambda mesh: ply(mesh, 'binary_little_endian'),
    'ply (big endian)': lambda mesh: ply(mesh, 'binary_big_endian'),
    'ply (text)': lambda mesh: ply(mesh, 'ascii'),
    'stl': stl_binary,
    'stl (text)': stl_ascii,
}
