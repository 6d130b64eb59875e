"""Measures locking: errors of incision's answers against those of CalculiX on quadratic bricks with reduced integration.

The problems are those of problem.cpp beside this file, cut at their planes of symmetry.
"""

import json
import os
import pathlib
import subprocess
import tempfile

import numpy as np

from calculix.bodies import bricks
from calculix.ccx import run

E = 1e5  # [Pa]
GRADING = 10  # cells are so much smaller at both ends of an axis: stress is singular where held sides end
PLATE = 0.005  # the way of the plate that presses a held block [m]

# The size of what is modelled [m], which of its axes begin at a plane of symmetry, which axis begins at a held side, and
# the traction [Pa] on the other end of that axis; None where it is a plate.
PROBLEMS = {'cantilever': ((1, 0.125, 0.25), (False, True, False), 0, (0, 0, -10)),
            'half cantilever': ((1, 0.125, 0.125), (False, True, False), 0, (0, 0, -10)),
            'held block': ((0.5, 0.5, 0.5), (True, True, False), 2, None),
            'pressed block': ((0.5, 0.5, 0.5), (True, True, False), 2, (0, 0, -1000))}


def places(length, cells, symmetric):
    s, waves = np.linspace(0, 1, cells + 1), 2 * np.pi * (2 if symmetric else 1)
    return length * (s - (1 - 1 / GRADING) * np.sin(waves * s) / waves)


def reference(name, ratio, along):
    """The answer, with so many cells along a side of 1 m: displacement along the load in the mean [m], or force [N]."""
    size, symmetric, axis, stress = PROBLEMS[name]
    cells = [max(4, 2 * round(along * length / 2)) for length in size]
    body = bricks(cells, size, {a: places(size[a], cells[a], symmetric[a]) for a in range(3)})
    held = {}
    for a in range(3):
        for n in body.at(a, 0) if symmetric[a] else ():
            held[n] = (*held.get(n, ()), a)
    held.update({n: (0, 1, 2) for n in body.at(axis, 0)})
    if stress is None:
        plate = body.at(axis, size[axis])
        held.update({n: (0, 1, 2) for n in plate})
        energy = run(body, E, ratio, held, {}, moved={(n, axis): -PLATE for n in plate})['energy']
        return 2 ** sum(symmetric) * 2 * energy / PLATE
    pressed = [lambda centres: (centres[:, :2] < 0.25).all(axis=1)] if name == 'pressed block' else []
    forces = body.traction(axis, size[axis], stress, *pressed)
    return 2 * run(body, E, ratio, held, forces)['energy'] / abs(sum(forces.values()))


def measure(quick):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / 'locking.json'
        program = os.path.join(os.environ['INCISION_PROGRAMS'], 'report_locking')
        subprocess.run([program, *(['--quick'] if quick else []), path], check=True)
        data = json.loads(path.read_text(encoding='utf-8'))
    ratios = data['errors'][0]['ratios']
    along = {name: (16 if quick else 24) * (2 if 'cantilever' in name else 1) for name in PROBLEMS}
    answers = {(name, ratio): reference(name, ratio, along[name]) for name in PROBLEMS for ratio in ratios}

    def error(name, ratio, answer):
        return answer / answers[name, ratio] - 1

    for of in data['errors']:
        name = of['problem']
        for key in ('plain', 'averaged', 'plain unstructured', 'averaged unstructured'):
            of[key] = [error(name, ratio, answer) for ratio, answer in zip(ratios, of[key])]
        of['model'] = {key: error(name, ratios[-1], answers[name, data[key]]) for key in ('capped', 'moderate')}
    for of in data['times']:
        for point in [point for key in of if key not in ('problem', 'ratio') for point in of[key]]:
            point['error'] = error(of['problem'], of['ratio'], point.pop('answer'))
    for at in data['cut']:
        for key in ('plain', 'averaged'):
            at[key] = error('half cantilever', at['ratio'], at[key])
    # How much of the reference two thirds as many bricks a side change.
    data['change'] = max(abs(error(name, ratios[-1], reference(name, ratios[-1], 2 * along[name] // 3)))
                         for name in PROBLEMS)
    return data
