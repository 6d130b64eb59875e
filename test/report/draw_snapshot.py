#!/usr/bin/python3
"""Draws what `incision_batch --snapshot` wrote, cut faces lighter, as a PNG. Several snapshots stand side by side, all
drawn from one point of view and to one scale. Needs Debian's python3-matplotlib.
"""

import argparse
import math
import xml.etree.ElementTree as ElementTree

import matplotlib
import numpy as np

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

SKIN, CUT_FACE, OBSTACLE = (0.80, 0.36, 0.33), (0.95, 0.72, 0.55), (0.75, 0.77, 0.80)  # the first two as in rviz
DPI = 100
LARGEST = (8, 3)            # width and height of the picture [inch]
MARGIN = 0.02               # round each, as a share of its larger extent
SPHERE_RINGS = 24


def read_triangles(path):
    """Corners [m] of every triangle, and which were made by a crack."""
    arrays = {array.get('Name'): np.array(array.text.split(), dtype=float)
              for array in ElementTree.parse(path).iter('DataArray')}
    points = arrays['Points'].reshape(-1, 3)
    return points[arrays['connectivity'].astype(int).reshape(-1, 3)], arrays['cut_face'] > 0


def sphere_triangles(x, y, z, radius):
    """Corners [m] of a sphere's triangles."""
    polar, around = np.meshgrid(np.linspace(0, math.pi, SPHERE_RINGS + 1),
                                np.linspace(0, 2 * math.pi, 2 * SPHERE_RINGS + 1), indexing='ij')
    points = np.stack([np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around), np.cos(polar)], axis=-1)
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    triangles = np.concatenate([np.stack(corners, axis=2).reshape(-1, 3, 3) for corners in ((a, b, c), (a, c, d))])
    return np.array([x, y, z]) + radius * triangles


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
    parser.add_argument('--view', nargs=2, type=float, default=(25, -65), metavar=('ELEVATION', 'AZIMUTH'),
                        help='where the body is seen from [degrees], z upwards')
    parser.add_argument('--sphere', nargs=4, type=float, metavar=('X', 'Y', 'Z', 'RADIUS'),
                        help='also draws a sphere [m]')
    return parser.parse_args()


def main():
    options = arguments()
    view = camera(*options.view)
    bodies = []
    for path in options.snapshots:
        triangles, cut = read_triangles(path)
        colours = np.where(cut[:, None], CUT_FACE, SKIN)
        if options.sphere:
            sphere = sphere_triangles(*options.sphere)
            triangles, colours = np.concatenate([triangles, sphere]), np.vstack([colours, [OBSTACLE] * len(sphere)])
        bodies.append((triangles @ view.T, colours))
    lower = np.min([seen[:, :, :2].min(axis=(0, 1)) for seen, _ in bodies], axis=0)
    upper = np.max([seen[:, :, :2].max(axis=(0, 1)) for seen, _ in bodies], axis=0)
    margin = MARGIN * (upper - lower).max()
    width, height = upper - lower + 2 * margin
    size = np.array([len(bodies) * width, height])
    figure, axes = plt.subplots(1, len(bodies), squeeze=False, figsize=size * (LARGEST / size).min())
    figure.subplots_adjust(0, 0, 1, 1, 0, 0)
    for panel, (seen, colours) in zip(axes[0], bodies):
        draw(panel, seen, colours)
        panel.set_xlim(lower[0] - margin, upper[0] + margin)
        panel.set_ylim(lower[1] - margin, upper[1] + margin)
        panel.set_aspect('equal')
    plt.savefig(options.picture, dpi=DPI)


if __name__ == '__main__':
    main()
