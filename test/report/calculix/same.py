"""The same linear tetrahedra in CalculiX and in incision: displacements under a load, and natural frequencies."""

import csv
import json
import os
import pathlib
import subprocess

import numpy as np
from bodies import bricks, gmsh, grid
from ccx import run
from problems import E, H, L, STRESS, timoshenko_frequency
from references import clamp

GEOMETRY = pathlib.Path(__file__).resolve().parent.parent / 'static' / 'bar.geo'
POISSON, DENSITY = 0.3, 1000.0
WIDTH = 0.3        # of the bar that oscillates [m]: it bends at one frequency over its height, at another over this
CLAMP = [[-1, -1, -1], [1e-9, 1, 1]]
END = [[L - 1e-9, -1, -1], [L + 1, 1, 1]]


def scene(mesh, density, time_step, **more):
    return {'body': {**mesh, 'warping': False, 'mass': more.pop('mass', 'lumped'),
                     'material': {'young_modulus': E, 'poisson_ratio': more.pop('poisson', POISSON),
                                  'density': density}},
            'boundary': [{'box': CLAMP}], 'loads': [{'box': END, 'traction': [0, 0, STRESS]}],
            'solver': {'time_step': time_step, 'method': 'direct'}, **more}


def batch(folder, described, *options):
    """Runs incision_batch on a scene; returns its summary."""
    path = folder / 'scene.yaml'
    path.write_text(json.dumps(described))
    done = subprocess.run([os.environ['INCISION_BATCH'], path, *options], stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(done.stdout.split('\n')[-2])


def displacements(folder, mesh, rest, **more):
    """One long step of a body without noticeable mass: the static displacements [m] of the nodes' own copies."""
    batch(folder, scene(mesh, 1e-9, 1, **more), '--steps', '1', '--positions', folder / 'positions.txt')
    return np.loadtxt(folder / 'positions.txt') - rest


def difference(folder, name, body, mesh, own=None, **more):
    rest = body.nodes if own is None else body.nodes[:own.index(-1)]
    incision = displacements(folder, mesh, rest, **more)
    found = run(body, E, POISSON, clamp(body), body.traction(0, L, (0, 0, STRESS)))
    calculix = found['u'] if own is None else found['u'][own[:-1]]
    apart = np.linalg.norm(incision - calculix, axis=1).max() / np.linalg.norm(calculix, axis=1).max()
    return {'mesh': name, 'elements': len(body.elements), 'freedoms': 3 * len(body.nodes), 'ms': found['ms'],
            'difference': apart}


def same_displacements(folder, quick):
    """Largest difference over the largest displacement, of a grid, a Gmsh mesh, and a grid with a cut on faces."""
    n = 4 if quick else 8
    cells, size = (5 * n, n, n), (L, H, H)
    on_grid = {'grid': {'cells': cells, 'size': size}}
    found = [difference(folder, 'grid', grid(cells, size), on_grid)]
    body, path = gmsh(GEOMETRY, folder, cells=n)
    found.append(difference(folder, 'Gmsh', body, {'mesh': str(path)}))
    # The own copy of a node on the cut is that above it.
    body = grid(cells, size)
    own = list(range(len(body.nodes)))
    for below, above in body.slit(2, H / 2, lambda X: X[0] > 1e-9).items():
        own[below] = above
    cut = {'time': 0, 'label': 'middle', 'point': [0, 0, H / 2], 'normal': [0, 0, 1]}
    found.append(difference(folder, 'grid, cut on faces', body, on_grid, own + [-1], cuts=[cut]))
    return found


def first_frequency(samples, time_step, every):
    """The lowest frequency [Hz] in samples that are sums of damped oscillations under backward Euler: the roots of the
    linear recurrence they obey (Prony), each exp(i atan ωΔt) / √(1 + ω²Δt²) a step."""
    values, order = samples[::every], 8
    rows = np.stack([values[k:len(values) - order + k] for k in range(order)], axis=1)
    recurrence = np.linalg.lstsq(rows, values[order:], rcond=1e-13)[0]
    roots = np.roots(np.concatenate([[1], -recurrence[::-1]]))
    root = max((r for r in roots if r.imag > 1e-6), key=abs)
    return np.tan(np.angle(root) / every) / time_step / (2 * np.pi)


def oscillation(folder, cells, mass):
    """First frequency [Hz] of incision's bar after a sudden load, by its momentum across."""
    mesh = {'grid': {'cells': cells, 'size': [L, WIDTH, H]}}
    time_step = 0.003  # [s]
    batch(folder, scene(mesh, DENSITY, time_step, mass=mass), '--steps', '1200', '--record', folder / 'run.csv')
    with open(folder / 'run.csv', encoding='ascii') as file:
        momentum = np.array([float(row['momentum_z']) for row in csv.DictReader(file)])
    return first_frequency(momentum[200:], time_step, 20)


def frequencies(folder, quick):
    n = 4 if quick else 6
    cells = [5 * n, 3 * n // 2, n]
    body, size = grid(cells, (L, WIDTH, H)), (L, WIDTH, H)
    calculix = run(body, E, POISSON, clamp(body), density=DENSITY, modes=4)['frequencies']
    fine = bricks((20, 4, 4), size) if quick else bricks((30, 6, 6), size)
    return {'calculix': calculix, 'quadratic': run(fine, E, POISSON, clamp(fine), density=DENSITY, modes=4)['frequencies'],
            'consistent': oscillation(folder, cells, 'consistent'), 'lumped': oscillation(folder, cells, 'lumped'),
            'beam': [timoshenko_frequency(WIDTH, H, POISSON, DENSITY),
                     timoshenko_frequency(H, WIDTH, POISSON, DENSITY)], 'cells': cells}
