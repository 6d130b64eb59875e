#!/usr/bin/python3
"""Plots what step_benchmark wrote, milliseconds a step against elements, and prints it as the tables of README.md beside it.

The second plot has the steps round a cut.

usage: plot_steps.py STEPS.json STEPS.png HITCH.png
"""

import json
import sys

import numpy

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt
from matplotlib.ticker import MaxNLocator

# Best of SOFA 26.06, Vega 4.0 and Bullet 3.24 on two cores, same bars and steps, E = 1e6 [ms]: SOFA each time.
PUBLISHED = {1536: 3.0, 12288: 53, 98304: 1040}

STYLES = {'auto': ('incision', 'C0', 'o'), 'plain CHOLMOD': ('CHOLMOD every step', 'C1', 's'),
          'Bullet': ('Bullet', 'C2', '^')}


def of_scene(rows, scene):
    return [row for row in rows if row['scene'] == scene]


def grid_rows(rows, program, young_modulus):
    return [row for row in of_scene(rows, 'grids')
            if row['program'] == program and row['young_modulus'] == young_modulus]


# Steps that plots of a cut begin before it, as the benchmark has them.
HITCH_BEFORE = 5


def slope(points):
    """The power of the size with which the time grows, by least squares of the logarithms."""
    sizes, times = numpy.log(numpy.array(points)).T
    return numpy.polyfit(sizes, times, 1)[0]


def plot(rows, path):
    plt.figure(figsize=(5.5, 4))
    plt.loglog(*zip(*PUBLISHED.items()), 'D', color='0.5', markersize=10, markerfacecolor='none',
               label='SOFA on another machine')
    for program, (label, color, marker) in STYLES.items():
        points = [(row['elements'], row['median_ms']) for row in grid_rows(rows, program, 1e6)]
        if program == 'auto' and of_scene(rows, 'sizes'):
            points = sorted((row['elements'], row['median_ms']) for row in of_scene(rows, 'sizes'))
            label += f', power {slope(points):.2f}'
        if points:
            plt.loglog(*zip(*points), marker + '-', color=color, label=label)
    plt.xlabel('elements')
    plt.ylabel('median step [ms]')
    plt.grid(True, which='both', alpha=0.3)
    plt.legend()
    plt.tight_layout()
    plt.savefig(path, dpi=100)


def plot_hitch(rows, path):
    """Each step over the median of those before the cut."""
    plt.figure(figsize=(5.5, 3.4))
    for row, style in zip(of_scene(rows, 'cuts'), ('o-', 'o--', 's-', 's--')):
        times = [ms / row['before']['median_ms'] for ms in row['hitch']]
        colour = 'C0' if style[0] == 'o' else 'C1'
        name = row['name'].partition(',')[2]
        plt.plot(range(-HITCH_BEFORE, len(times) - HITCH_BEFORE), times, style, color=colour, markersize=4,
                 label=f"{row['elements']:,} elements" + (f',{name}' if name else ''))
    plt.xlabel('steps after the one that cuts')
    plt.ylabel('time over the median before')
    plt.ylim(bottom=0)
    plt.gca().xaxis.set_major_locator(MaxNLocator(integer=True))
    plt.grid(True, alpha=0.3)
    plt.legend(fontsize=8)
    plt.tight_layout()
    plt.savefig(path, dpi=100)


def table(headings, lines):
    print()
    print('| ' + ' | '.join(headings) + ' |')
    print('|---' * len(headings) + '|')
    for cells in lines:
        print('| ' + ' | '.join(cells) + ' |')


def milliseconds(value):
    return f'{value:.0f}' if value >= 100 else f'{value:.1f}' if value >= 10 else f'{value:.2f}'


def beside(rows, program, ours):
    """What another program takes, and how many times our time that is."""
    found = [row for row in grid_rows(rows, program, ours['young_modulus']) if row['grid'] == ours['grid']]
    return f"{milliseconds(found[0]['median_ms'])} (×{found[0]['times_auto']:.1f})" if found else '–'


def step_table(rows):
    lines = []
    for young_modulus in (1e6, 1e8):
        for row in grid_rows(rows, 'auto', young_modulus):
            lines.append([row['grid'].replace('x', '×'), str(row['elements']), f'{young_modulus:.0e}'.replace('+0', ''),
                          milliseconds(row['median_ms']), milliseconds(row['p99_ms']), f"{row['iterations']:.0f}",
                          f"{row['kb_per_element']:.2f}", beside(rows, 'direct', row),
                          beside(rows, 'plain CHOLMOD', row), beside(rows, 'Bullet', row)])
    table(['cells', 'elements', 'E [Pa]', 'median ms', '99 % ms', 'iterations', 'kB an element', '`direct`',
           'plain CHOLMOD', 'Bullet'], lines)


def times_before(row, window):
    if window not in row:
        return '–'
    return f"{milliseconds(row[window]['median_ms'])} (×{row['times_before'][window]:.2f})"


def cut_table(rows):
    lines = []
    for scene in ('cuts', 'plate', 'organ', 'large'):
        for row in of_scene(rows, scene):
            lines.append([row['name'].replace('x', '×'), str(row['elements']), f"{row['crack_share']:.1f} %",
                          f"{row['dofs_before']} → {row['dofs']}", str(row['pieces']),
                          milliseconds(row['before']['median_ms']),
                          *(times_before(row, window) for window in ('cut', 'after', 'later')),
                          f"{row['kb_per_element']:.2f}"])
    table(['scene', 'elements', 'cut', 'freedoms', 'pieces', 'ms before', 'a step that cuts', 'after', '1 s later',
           'kB an element'], lines)


def size_table(rows):
    table(['cells', 'elements', 'median ms', 'ns an element', 'iterations', 'kB an element'],
          [[row['name'].replace('x', '×'), str(row['elements']), milliseconds(row['median_ms']),
            f"{row['ns_per_element']:.0f}", f"{row['iterations']:.0f}", f"{row['kb_per_element']:.2f}"]
           for row in of_scene(rows, 'sizes')])


def other_table(rows):
    table(['bar', 'median ms', '99 % ms'],
          [[f"{row['elements']} elements, {row['name']}", milliseconds(row['median_ms']), milliseconds(row['p99_ms'])]
           for scene in ('threads', 'linear') for row in of_scene(rows, scene)])


if __name__ == '__main__':
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    with open(sys.argv[1], encoding='utf-8') as file:
        measured = json.load(file)
    plot(measured, sys.argv[2])
    plot_hitch(measured, sys.argv[3])
    step_table(measured)
    size_table(measured)
    cut_table(measured)
    other_table(measured)
