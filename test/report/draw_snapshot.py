#!/usr/bin/python3
"""Draws what `incision_batch --snapshot` wrote, cut faces lighter, as a PNG.

usage: draw_snapshot.py SNAPSHOT.vtu PICTURE.png [ELEVATION AZIMUTH]

The angles [degrees] say from where the body is seen, z upwards. Needs Debian's python3-matplotlib.
"""

import math
import sys
import xml.etree.ElementTree as ElementTree

import matplotlib
import numpy as np

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import PolyCollection  # noqa: E402

SKIN, CUT_FACE = (0.80, 0.36, 0.33), (0.95, 0.72, 0.55)  # as in rviz
SIZE, DPI = (6, 4), 100


def read_triangles(path):
    """Corners [m] of every triangle, and which were made by a crack."""
    arrays = {array.get('Name'): np.array(array.text.split(), dtype=float)
              for array in ElementTree.parse(path).iter('DataArray')}
    points = arrays['Points'].reshape(-1, 3)
    return points[arrays['connectivity'].astype(int).reshape(-1, 3)], arrays['cut_face'] > 0


def camera(elevation, azimuth):
    """Rows: the directions right, up and towards the eye."""
    e, a = math.radians(elevation), math.radians(azimuth)
    towards = np.array([math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e)])
    right = np.array([-math.sin(a), math.cos(a), 0])
    return np.array([right, np.cross(towards, right), towards])


def draw(triangles, cut, view, path):
    """The triangles that face the eye, the farthest first, lit from it."""
    seen = triangles @ view.T
    normals = np.cross(seen[:, 1] - seen[:, 0], seen[:, 2] - seen[:, 0])
    facing = normals[:, 2] / np.maximum(np.linalg.norm(normals, axis=1), np.finfo(float).tiny)
    order = [t for t in np.argsort(seen[:, :, 2].mean(axis=1)) if facing[t] > 0]
    colours = (np.where(cut[:, None], CUT_FACE, SKIN) * (0.6 + 0.4 * facing[:, None]))[order]
    axes = plt.figure(figsize=SIZE).add_axes([0.02, 0.02, 0.96, 0.96])
    axes.add_collection(PolyCollection(seen[order, :, :2], facecolors=colours, edgecolors=0.85 * colours,
                                       linewidths=0.4))
    axes.autoscale_view()
    axes.set_aspect('equal')
    axes.set_axis_off()
    plt.savefig(path, dpi=DPI)


def main():
    if len(sys.argv) not in (3, 5):
        sys.exit(__doc__)
    elevation, azimuth = map(float, sys.argv[3:] or (25, -65))
    triangles, cut = read_triangles(sys.argv[1])
    draw(triangles, cut, camera(elevation, azimuth), sys.argv[2])


if __name__ == '__main__':
    main()
