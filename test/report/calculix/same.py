"""The same linear tetrahedra in CalculiX and in incision: displacements under a load, and natural frequencies."""

import csv
import json
import os
import pathlib
import subprocess

import numpy as np
from calculix.bodies import bricks, cut_through, gmsh, grid
from calculix.ccx import run
from calculix.problems import E, H, L, STRESS, timoshenko_frequency
from calculix.references import clamp

GEOMETRY = pathlib.Path(__file__).resolve().parent.parent / 'static' / 'bar.geo'
POISSON, DENSITY = 0.3, 1000.0
WIDTH = 0.3        # of the bar that oscillates [m]: it bends at one frequency over its height, at another over this
CLAMP = [[-1, -1, -1], [1e-9, 1, 1]]
END = [[L - 1e-9, -1, -1], [L + 1, 1, 1]]


# Another tissue in the bar's further half, across the cut: ten times as stiff, and less compressible.
STIFF = {'box': [[0.45 * L, -1, -1], [2 * L, 1, 1]], 'young_modulus': 10 * E, 'poisson_ratio': 0.45}


def regions():
    material = {key: STIFF[key] for key in ('young_modulus', 'poisson_ratio')}
    return [{'box': STIFF['box'], 'material': material}]


def scene(mesh, density, time_step, poisson=POISSON, mass='lumped', loaded=(END,), cuts=(), tissues=()):
    return {'body': {**mesh, 'regions': list(tissues), 'warping': False, 'mass': mass,
                     'material': {'young_modulus': E, 'poisson_ratio': poisson, 'density': density}},
            'boundary': [{'box': CLAMP}],
            'loads': [{'box': box, 'traction': [0, 0, STRESS]} for box in loaded],
            'cuts': [{'time': 0, 'label': 'middle', 'point': point, 'normal': [0, 0, 1]} for point in cuts],
            'solver': {'time_step': time_step, 'method': 'direct', 'integrator': 'euler'}}


def batch(folder, described, *options):
    """Runs incision_batch on a scene; returns its summary."""
    path = folder / 'scene.yaml'
    path.write_text(json.dumps(described))
    done = subprocess.run([os.environ['INCISION_BATCH'], path, *options], stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(done.stdout.split('\n')[-2])


def compare(folder, name, body, described, own, where=None):
    """Largest difference of the displacements, over the largest displacement. `own` has, by node of incision's mesh,
    the node of `body` that is its own copy; `where` says which of the end's faces are loaded, by their centres."""
    # One long step without noticeable inertia is the static answer.
    batch(folder, described, '--steps', '1', '--positions', folder / 'positions.txt')
    incision = np.loadtxt(folder / 'positions.txt') - body.nodes[own]
    forces = body.traction(0, L, (0, 0, STRESS), *([where] if where else []))
    found = run(body, (E, STIFF['young_modulus']), (POISSON, STIFF['poisson_ratio']), clamp(body), forces)
    calculix = found['u'][own]
    return {'mesh': name, 'elements': len(body.elements), 'freedoms': 3 * len(body.nodes), 'ms': found['ms'],
            'difference': np.linalg.norm(incision - calculix, axis=1).max() / np.linalg.norm(calculix, axis=1).max()}


def same_displacements(folder, quick):
    """Of a grid, of a Gmsh mesh, and of grids with a cut: along faces, and through elements; of one tissue, and of
    two."""
    return of_tissues(folder, quick, '', ()) + of_tissues(folder, quick, ', two tissues', regions())


def of_tissues(folder, quick, suffix, tissues):
    def with_tissues(body):
        if tissues:
            body.tissues = body.in_box(*STIFF['box']).astype(int)
        return body

    n = 4 if quick else 8
    size, middle = (L, H, H), [0, 0, H / 2]
    body = with_tissues(grid((5 * n, n, n), size))
    every = np.arange(len(body.nodes))
    on_grid = {'grid': {'cells': [5 * n, n, n], 'size': size}}
    found = [compare(folder, 'grid' + suffix, body, scene(on_grid, 1e-9, 1, tissues=tissues), every)]

    own = every.copy()  # a node on the cut is the upper side's
    for below, above in body.slit(2, H / 2, lambda X: True).items():
        own[below] = above
    found.append(compare(folder, 'grid, cut along faces' + suffix, body,
                         scene(on_grid, 1e-9, 1, cuts=[middle], tissues=tissues), own))

    n += 1  # odd, so that the middle is inside elements; their end faces stay unloaded
    whole = with_tissues(grid((5 * n, n, n), size))
    own = np.arange(len(whole.nodes)) + np.where(whole.nodes[:, 2] > H / 2, len(whole.nodes), 0)
    low, high = (n - 1) / 2 * H / n, (n + 1) / 2 * H / n
    boxes = [[[L - 1e-9, -1, -1], [L + 1, 1, low + 1e-9]], [[L - 1e-9, -1, high - 1e-9], [L + 1, 1, 1]]]
    on_grid = {'grid': {'cells': [5 * n, n, n], 'size': size}}
    found.append(compare(folder, 'grid, cut through elements' + suffix, cut_through(whole, H / 2),
                         scene(on_grid, 1e-9, 1, loaded=boxes, cuts=[middle], tissues=tissues), own,
                         lambda centres: abs(centres[:, 2] - H / 2) > H / (2 * n)))

    body, path = gmsh(GEOMETRY, folder, cells=n)
    found.append(compare(folder, 'Gmsh' + suffix, with_tissues(body),
                         scene({'mesh': str(path)}, 1e-9, 1, tissues=tissues), np.arange(len(body.nodes))))
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
    batch(folder, scene(mesh, DENSITY, time_step, mass=mass), '--steps', '2000', '--record', folder / 'run.csv')
    with open(folder / 'run.csv', encoding='ascii') as file:
        momentum = np.array([float(row['momentum_z']) for row in csv.DictReader(file)])
    return first_frequency(momentum[800:], time_step, 10)


def frequencies(folder, quick):
    """First natural frequencies [Hz] of incision's bar and of CalculiX's of the same tetrahedra; of its quadratic
    bricks and of beam theory with ν = 0, bending over the height and over the width."""
    n = 4 if quick else 6
    cells, size = [5 * n, 3 * n // 2, n], (L, WIDTH, H)
    body = grid(cells, size)
    consistent, lumped = (oscillation(folder, cells, mass) for mass in ('consistent', 'lumped'))
    # CalculiX integrates a C3D4 at its one point, which leaves out how velocities differ within the element. Lumping
    # counts a quarter of their square, the exact integral a twentieth; the period's square follows in proportion.
    at_one_point = (consistent ** -2 - (lumped ** -2 - consistent ** -2) / 4) ** -0.5
    fine = bricks((5 * n, 3 * n // 2, n), size)
    return {'cells': cells, 'consistent': consistent, 'lumped': lumped, 'at_one_point': at_one_point,
            'calculix': run(body, E, POISSON, clamp(body), density=DENSITY, modes=4)['frequencies'],
            'quadratic': run(fine, E, 0, clamp(fine), density=DENSITY, modes=4)['frequencies'],
            'beam': [timoshenko_frequency(WIDTH, H, 0, DENSITY), timoshenko_frequency(H, WIDTH, 0, DENSITY)]}
