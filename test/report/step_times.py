#!/usr/bin/python3
"""Times steps of an uncut bar on grids of three sizes and prints a table.

usage: step_times.py [PLOT.png]

Each row takes the best of RUNS medians, since other programs can only slow a run down. With a name it also plots
time against elements, for which it needs Debian's python3-matplotlib.
"""

import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
BATCH = ROOT / 'build/devel/lib/incision/incision_batch'
SCENE = ROOT / 'config/scenes/bar.yaml'
GRIDS = ((16, 4, 4), (32, 8, 8), (64, 16, 16))
TOLERANCES = ('1e-4', '1e-6')
STEPS, RUNS = 40, 8


def run(cells, settings):
    """What the batch program says of one run."""
    changes = [f'body.grid.cells={list(cells)}', *settings]
    sets = [word for change in changes for word in ('--set', change)]
    command = [BATCH, SCENE, '--steps', str(STEPS), '--threads', '2', *sets]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)


def measure(cells, settings):
    results = [run(cells, settings) for _ in range(RUNS)]
    return min(results, key=lambda result: result['step_ms']['median'])


def table():
    rows = []
    for cells in GRIDS:
        for label, settings in [(f'iterative {tolerance}', ['solver.method=iterative', f'solver.tolerance={tolerance}'])
                                for tolerance in TOLERANCES] + [('direct', ['solver.method=direct'])]:
            if label == 'direct' and cells == GRIDS[-1]:
                continue  # seconds a step
            best = measure(cells, settings)
            rows.append((label, best['elements'], best['step_ms']['median']))
            grid = '×'.join(map(str, cells))
            print(f"| {grid} | {best['elements']} | {best['dofs']} | {label} | {best['step_ms']['median']:.1f} | "
                  f"{best['step_ms']['p99']:.1f} | {best['iterations']} |", flush=True)
    return rows


def plot(rows, path):
    import matplotlib
    matplotlib.use('Agg')
    import matplotlib.pyplot as plt
    plt.figure(figsize=(5, 3.5))
    for label in dict.fromkeys(row[0] for row in rows):
        points = [row[1:] for row in rows if row[0] == label]
        plt.loglog(*zip(*points), 'o-', label=label)
    plt.xlabel('elements')
    plt.ylabel('median step [ms]')
    plt.grid(True, which='both', alpha=0.3)
    plt.legend()
    plt.tight_layout()
    plt.savefig(path, dpi=100)


if __name__ == '__main__':
    rows = table()
    if len(sys.argv) > 1:
        plot(rows, sys.argv[1])
