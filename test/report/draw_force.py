#!/usr/bin/python3
"""Draws the force on a tool over time from what `incision_batch --record` wrote, as a PNG. Several records are several
curves. From a `--series` of the first it marks when a region was cut. Needs Debian's python3-matplotlib.
"""

import argparse
import csv
import pathlib
import xml.etree.ElementTree as ElementTree

import matplotlib
import numpy as np

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402

from draw_snapshot import read_triangles  # noqa: E402
from plots import COLOURS, DASHES, DPI  # noqa: E402

SIZE = (7, 3)   # width and height of the picture [inch]
MARKED = '#e0a030'
NEARLY_ALL = 0.9  # of the area of cut faces; they stretch later, and slivers come after


def read_force(path):
    """Times [s] and magnitudes of the force on the tool [N]."""
    with open(path, newline='', encoding='ascii') as record:
        rows = [[float(row[name]) for name in ('time', 'tool_scalpel_force_x', 'tool_scalpel_force_y', 'tool_scalpel_force_z')]
                for row in csv.DictReader(record)]
    rows = np.array(rows)
    return rows[:, 0], np.linalg.norm(rows[:, 1:], axis=1)


def cut_area(path, region):
    """Area of a region's cut faces [m^2]."""
    triangles, cut, regions = read_triangles(path)
    a, b, c = np.moveaxis(triangles[cut & (regions == region)], 1, 0)
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def cutting_interval(series, region):
    """Times [s] of the last snapshot of a series without cut faces of a region, and of the first with nearly all."""
    series = pathlib.Path(series)
    times, areas = np.array(sorted((float(entry.get('timestep')), cut_area(series.parent / entry.get('file'), region))
                                   for entry in ElementTree.parse(series).iter('DataSet')
                                   if entry.get('name') == 'surface')).T
    if not areas.any():
        raise SystemExit(f'draw_force.py: {series}: nothing of region {region} is cut')
    return times[np.flatnonzero(areas > 0)[0] - 1], times[np.flatnonzero(areas > NEARLY_ALL * areas.max())[0]]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('records', nargs='+', metavar='RUN.csv')
    parser.add_argument('picture', metavar='PICTURE.png')
    parser.add_argument('--labels', nargs='+', default=(), metavar='TEXT', help='of the records, in their order')
    parser.add_argument('--mark', nargs=3, metavar=('RUN.pvd', 'REGION', 'TEXT'),
                        help="marks while a region is cut: the series, the region's number there and what to write")
    parser.add_argument('--start', type=float, default=0, metavar='SECONDS', help='where the time axis starts')
    return parser.parse_args()


def main():
    options = arguments()
    figure, axes = plt.subplots(figsize=SIZE)
    for i, path in enumerate(options.records):
        time, force = read_force(path)
        axes.plot(time, force, color=COLOURS[i % len(COLOURS)], linestyle=DASHES[i % len(DASHES)],
                  label=options.labels[i] if i < len(options.labels) else None)
    axes.set_xlim(options.start, time[-1])
    axes.set_ylim(0)
    if options.mark:
        series, region, text = options.mark
        start, end = cutting_interval(series, int(region))
        axes.axvspan(start, end, color=MARKED, alpha=0.25, linewidth=0)
        axes.annotate(text, ((start + end) / 2, 0.03), xycoords=('data', 'axes fraction'), ha='center')
    axes.set_xlabel('time [s]')
    axes.set_ylabel('force on the blade [N]')
    if options.labels:
        axes.legend(loc='upper left')
    figure.tight_layout()
    figure.savefig(options.picture, dpi=DPI)


if __name__ == '__main__':
    main()
