#!/usr/bin/python3
"""render_points.py INPUT.ply ADDED.ply OUT.png: a picture of a point set before and after its completion.

Above the whole model, below the neighbourhood of the new points; on the left without, on the right with them (tinted).
The view is along the mean normal of the new points. Needs numpy and Pillow (Debian: python3-numpy, python3-pil).
"""
import argparse
import sys

import numpy as np
from PIL import Image, ImageDraw

TYPES = {'char': 'i1', 'int8': 'i1', 'uchar': 'u1', 'uint8': 'u1', 'short': 'i2', 'int16': 'i2', 'ushort': 'u2',
         'uint16': 'u2', 'int': 'i4', 'int32': 'i4', 'uint': 'u4', 'uint32': 'u4', 'float': 'f4', 'float32': 'f4',
         'double': 'f8', 'float64': 'f8'}
SURFACE, TINT, BACK = np.array([[0.74, 0.76, 0.80], [0.98, 0.58, 0.22], [0.20, 0.19, 0.24]])


def read_points(name):
    """Positions and normals of the vertices of a PLY file, which must be its first element."""
    with open(name, 'rb') as file:
        content = file.read()
    end = content.index(b'end_header')
    body = content.index(b'\n', end) + 1
    header = [line.split() for line in content[:end].decode('latin1').splitlines() if line.strip()]
    encoding = next(words[1] for words in header if words[0] == 'format')
    number, fields, is_vertex = 0, [], False
    for words in header:
        if words[0] == 'element':
            is_vertex = words[1] == 'vertex'
            number = int(words[2]) if is_vertex else number
        elif words[0] == 'property' and is_vertex:
            fields.append((words[-1], TYPES[words[1]]))
    if encoding == 'ascii':
        rows = content[body:].decode('latin1').split('\n')[:number]
        table = np.array([row.split() for row in rows], dtype=float).reshape(number, len(fields))
        columns = {field[0]: table[:, i] for i, field in enumerate(fields)}
    else:
        order = '>' if 'big' in encoding else '<'
        table = np.frombuffer(content, np.dtype([(field, order + kind) for field, kind in fields]), number, body)
        columns = {field: table[field].astype(float) for field, _ in fields}
    return (np.stack([columns[c] for c in ('x', 'y', 'z')], axis=1).reshape(number, 3),
            np.stack([columns[c] for c in ('nx', 'ny', 'nz')], axis=1).reshape(number, 3))


def unit(v):
    return v / np.maximum(np.linalg.norm(v, axis=-1, keepdims=True), 1e-300)


def spacing(points):
    """Median distance to the nearest neighbour, of a sample of the points."""
    chosen = points[np.random.default_rng(0).permutation(len(points))[:200]]
    distances = [np.partition(((points - p) ** 2).sum(axis=1), 1)[1] for p in chosen]
    return float(np.sqrt(np.median(distances)))


def draw(points, normals, colors, axes, center, half_width, radius, size):
    """Every point as a disc in its tangent plane, orthographic, nearest disc wins."""
    scale = size / (2 * half_width)
    q = (points - center) @ axes.T * scale
    n = normals @ axes.T
    keep = (np.abs(q[:, :2]) < size / 2 + radius * scale).all(axis=1)
    q, n, colors = q[keep], n[keep], colors[keep]
    light = unit(np.array([-0.4, 0.5, 0.75]))
    shade = 0.25 + 0.75 * np.clip(n @ light, 0, 1)
    shaded = np.where((n[:, 2] < 0)[:, None], BACK, colors * shade[:, None])
    # a disc that is seen from the side is drawn a little round, so that silhouettes do not fray
    nz = np.where(n[:, 2] < 0, -1, 1) * np.maximum(np.abs(n[:, 2]), 0.35)
    reach = max(radius * scale, 0.8)
    column, row = np.floor(q[:, 0] + size / 2).astype(int), np.floor(size / 2 - q[:, 1]).astype(int)
    pixels, depths, owners = [], [], []
    k = int(np.ceil(reach))
    for i in range(-k, k + 1):
        for j in range(-k, k + 1):
            x, y = column + i, row + j
            dx, dy = x + 0.5 - size / 2 - q[:, 0], size / 2 - y - 0.5 - q[:, 1]
            dz = -(n[:, 0] * dx + n[:, 1] * dy) / nz
            hit = (dx * dx + dy * dy + dz * dz <= reach * reach) & (x >= 0) & (x < size) & (y >= 0) & (y < size)
            pixels.append((y * size + x)[hit])
            depths.append((q[:, 2] + dz)[hit])
            owners.append(np.nonzero(hit)[0])
    pixels, depths, owners = np.concatenate(pixels), np.concatenate(depths), np.concatenate(owners)
    order = np.lexsort((depths, pixels))
    last = np.nonzero(np.diff(np.append(pixels[order], -1)))[0]
    image = np.ones((size * size, 3))
    image[pixels[order][last]] = shaded[owners[order][last]]
    return image.reshape(size, size, 3)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('input')
    parser.add_argument('added')
    parser.add_argument('out')
    parser.add_argument('--size', type=int, default=480, help='width of one picture in pixels')
    arguments = parser.parse_args()
    points, normals = read_points(arguments.input)
    new_points, new_normals = read_points(arguments.added)
    if len(points) < 2:
        sys.exit(arguments.input + ': too few points for a picture')

    low, high = points.min(axis=0), points.max(axis=0)
    whole = (low + high) / 2, 0.5 * np.linalg.norm(high - low)
    if len(new_points) > 0:
        middle = (new_points.min(axis=0) + new_points.max(axis=0)) / 2
        near = middle, 2.2 * np.linalg.norm(new_points - middle, axis=1).max()
        view = new_normals.mean(axis=0)
        if np.linalg.norm(view) < 0.3:      # new points all around a strand
            view = new_points.mean(axis=0) - whole[0]
    else:
        near, view = (whole[0], 0.5 * whole[1]), np.array([0.0, 0.0, 1.0])
    z = unit(view)
    up = np.array([0.0, 1.0, 0.0]) if abs(z[1]) < 0.95 else np.array([0.0, 0.0, -1.0])
    x = unit(np.cross(up, z))
    axes = np.stack([x, np.cross(z, x), z])

    radius = 1.3 * spacing(points)
    normals, new_normals = unit(normals), unit(new_normals)
    fine = 2 * arguments.size               # drawn twice as large, then averaged
    colors = np.tile(SURFACE, (len(points), 1))
    both = (np.concatenate([points, new_points]), np.concatenate([normals, new_normals]),
            np.concatenate([colors, np.tile(TINT, (len(new_points), 1))]))
    rows = []
    for center, half_width in (whole, near):
        row = [draw(*scene, axes, center, half_width, radius, fine) for scene in ((points, normals, colors), both)]
        rows.append(np.concatenate(row, axis=1))
    pixels = (np.clip(np.concatenate(rows), 0, 1) * 255 + 0.5).astype(np.uint8)
    picture = Image.fromarray(pixels).resize((2 * arguments.size, 2 * arguments.size), Image.LANCZOS)
    text = ImageDraw.Draw(picture)
    for i, label in enumerate(('before', 'after: %d new points' % len(new_points))):
        text.text((i * arguments.size + 8, 6), label, fill=(40, 40, 40))
    picture.save(arguments.out)


if __name__ == '__main__':
    main()
