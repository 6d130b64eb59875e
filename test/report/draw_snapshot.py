#!/usr/bin/python3
"""Draws what `incision_batch --snapshot` wrote, cut faces lighter, as a PNG. Several snapshots stand side by side, drawn
to one scale, from one point of view or each from its own. Needs Debian's python3-matplotlib.
"""

import argparse
import math
import xml.etree.ElementTree as ElementTree

import matplotlib
import numpy as np
from PIL import Image

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

SKIN, CUT_FACE, OBSTACLE = (0.80, 0.36, 0.33), (0.95, 0.72, 0.55), (0.75, 0.77, 0.80)  # the first two as in rviz
REGIONS = ((SKIN, CUT_FACE),  # skin and cut faces of the own material, then of each region: dark, light, blue, green
           ((0.70, 0.30, 0.28), (0.62, 0.22, 0.22)), ((0.86, 0.80, 0.66), (0.94, 0.90, 0.80)),
           ((0.45, 0.52, 0.70), (0.55, 0.62, 0.82)), ((0.50, 0.66, 0.52), (0.66, 0.80, 0.66)))
DPI = 100
LARGEST = (8, 3)            # width and height of the picture [inch]
MARGIN = 0.02               # round each, as a share of its larger extent
SPHERE_RINGS = 24
BLADE_CELLS, BLADE_HEIGHT = (48, 4), 0.06   # along and across; height as a share of the edge


def read_triangles(path):
    """Corners [m] of every triangle, which were made by a crack, and the number of each one's region."""
    arrays = {array.get('Name'): np.array(array.text.split(), dtype=float)
              for array in ElementTree.parse(path).iter('DataArray')}
    points = arrays['Points'].reshape(-1, 3)
    triangles = points[arrays['connectivity'].astype(int).reshape(-1, 3)]
    return triangles, arrays['cut_face'] > 0, arrays['region'].astype(int)


def sphere_triangles(x, y, z, radius):
    """Corners [m] of a sphere's triangles."""
    polar, around = np.meshgrid(np.linspace(0, math.pi, SPHERE_RINGS + 1),
                                np.linspace(0, 2 * math.pi, 2 * SPHERE_RINGS + 1), indexing='ij')
    points = np.stack([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)], axis=-1)
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    triangles = np.concatenate([np.stack(corners, axis=2).reshape(-1, 3, 3) for corners in ((a, b, c), (a, c, d))])
    return np.array([x, y, z]) + radius * triangles


def blade_triangles(ends):
    """Corners [m] of both sides of a blade, in small triangles: a strip above its edge, which goes from end to end."""
    start, end = np.reshape(ends, (2, 3))
    along = np.linspace(0, 1, BLADE_CELLS[0] + 1)[:, None, None] * (end - start)
    up = np.linspace(0, 1, BLADE_CELLS[1] + 1)[:, None] * [0, 0, BLADE_HEIGHT * np.linalg.norm(end - start)]
    points = start + along + up
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    triangles = np.concatenate([np.stack(corners, axis=2).reshape(-1, 3, 3) for corners in ((a, b, c), (a, c, d))])
    return np.concatenate([triangles, triangles[:, ::-1]])


def camera(elevation, azimuth):
    """Rows: the directions right, up and towards the eye."""
    e, a = math.radians(elevation), math.radians(azimuth)
    towards = np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])
    right = np.array([-math.sin(a), math.cos(a), 0])
    return np.array([right, np.cross(towards, right), towards])


def draw(axes, seen, colours):
    """The triangles that face the eye, the farthest first, lit from it."""
    normals = np.cross(seen[:, 1] - seen[:, 0], seen[:, 2] - seen[:, 0])
    facing = normals[:, 2] / np.maximum(np.linalg.norm(normals, axis=1), np.finfo(float).tiny)
    order = [t for t in np.argsort(seen[:, :, 2].mean(axis=1)) if facing[t] > 0]
    lit = (colours * (0.6 + 0.4 * facing[:, None]))[order]
    axes.add_collection(PolyCollection(seen[order, :, :2], facecolors=lit, edgecolors=0.85 * lit, linewidths=0.4,
                                       snap=False))
    axes.set_axis_off()


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('snapshots', nargs='+', metavar='SNAPSHOT.vtu')
    parser.add_argument('picture', metavar='PICTURE.png')
    parser.add_argument('--view', nargs=2, type=float, action='append', metavar=('ELEVATION', 'AZIMUTH'),
                        help='where the body is seen from [degrees], z upwards; given several times, of each snapshot '
                        '(default: 25 -65)')
    parser.add_argument('--regions', action='store_true', help='each region of the scene in colours of its own')
    parser.add_argument('--sphere', nargs=4, type=float, metavar=('X', 'Y', 'Z', 'RADIUS'),
                        help='also draws a sphere [m]')
    parser.add_argument('--edge', nargs=6, type=float, action='append', metavar=('X', 'Y', 'Z', 'X', 'Y', 'Z'),
                        help='also draws a blade that stands upright on its edge from end to end [m]; given several '
                        'times, of each snapshot')
    return parser.parse_args()


def seen_box(bodies):
    """Lower and upper corner of what is seen of several bodies."""
    points = np.concatenate([seen[:, :, :2].reshape(-1, 2) for seen in bodies])
    return points.min(axis=0), points.max(axis=0)


def of_each(values, count, option):
    """The values of an option for each snapshot; one is for all."""
    if len(values) not in (1, count):
        raise SystemExit(f'draw_snapshot.py: {option}: give one, or one for each snapshot')
    return values * count if len(values) == 1 else values


def main():
    options = arguments()
    count = len(options.snapshots)
    views = of_each([tuple(view) for view in options.view or [(25, -65)]], count, '--view')
    edges = of_each(options.edge or [None], count, '--edge')
    bodies = []
    for path, view, edge in zip(options.snapshots, views, edges):
        triangles, cut, region = read_triangles(path)
        palette = np.array(REGIONS)[region % len(REGIONS) if options.regions else 0 * region]
        colours = np.where(cut[:, None], palette[:, 1], palette[:, 0])
        for other in ([sphere_triangles(*options.sphere)] if options.sphere else []) + (
                [blade_triangles(edge)] if edge else []):
            triangles, colours = np.concatenate([triangles, other]), np.vstack([colours, [OBSTACLE] * len(other)])
        bodies.append((triangles @ camera(*view).T, colours))
    boxes = [seen_box(seen for (seen, _), other in zip(bodies, views) if other == view) for view in views]
    extents = np.max([upper - lower for lower, upper in boxes], axis=0)
    half = extents / 2 + MARGIN * extents.max()
    size = 2 * half * [count, 1]
    figure, axes = plt.subplots(1, count, squeeze=False, figsize=size * (LARGEST / size).min())
    figure.subplots_adjust(0, 0, 1, 1, 0, 0)
    for panel, (seen, colours), box in zip(axes[0], bodies, boxes):
        draw(panel, seen, colours)
        (left, right), (bottom, top) = np.transpose([sum(box) / 2 - half, sum(box) / 2 + half])
        panel.set_xlim(left, right)
        panel.set_ylim(bottom, top)
        panel.set_aspect('equal')
    plt.savefig(options.picture, dpi=DPI)
    with Image.open(options.picture) as picture:  # 256 colours show no difference, in less than half the bytes
        few = picture.convert('RGB').quantize(256)
    few.save(options.picture, optimize=True)


if __name__ == '__main__':
    main()
