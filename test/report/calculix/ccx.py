"""Runs CalculiX on a body and reads its answer."""

import os
import re
import subprocess
import tempfile
import time

import numpy as np

THREADS = '2'


def run(body, young, poisson, held, forces=None, density=None, modes=0, moved=None):
    """A linear static solve under forces {(node, direction): N}, or the first natural frequencies.

    young and poisson are numbers, or lists of the tissues'. held: {node: directions}; moved: {(node, direction): m}, how far some of these go. Returns a dict of `u` [m] by
    node and `energy` [J], or `frequencies` [Hz]; and `ms`.
    """
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, 'job.inp'), 'w', encoding='ascii') as deck:
            deck.write('\n'.join(deck_lines(body, young, poisson, held, forces, density, modes, moved or {})) + '\n')
        start = time.monotonic()
        done = subprocess.run(['ccx', 'job'], cwd=folder, env={**os.environ, 'OMP_NUM_THREADS': THREADS},
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        ms = 1000 * (time.monotonic() - start)
        if done.returncode != 0 or '*ERROR' in done.stdout:
            raise RuntimeError(f'ccx failed: {done.stdout[-2000:]}')
        with open(os.path.join(folder, 'job.dat'), encoding='ascii') as answer:
            return {'ms': ms, **(read_frequencies(answer.read(), modes) if modes else
                                 read_static(answer.read(), len(body.nodes)))}


def deck_lines(body, young, poisson, held, forces, density, modes, moved):
    yield '*NODE, NSET=ALL'
    yield from (f'{n + 1}, {x:.12e}, {y:.12e}, {z:.12e}' for n, (x, y, z) in enumerate(body.nodes))
    yield from element_lines(body, young, poisson, density)
    yield '*BOUNDARY'
    yield from (f'{n + 1}, {d + 1}' for n, directions in held.items() for d in directions)
    yield '*STEP'
    if modes:
        yield from ('*FREQUENCY', str(modes))
    else:
        yield '*STATIC'
        if moved:
            yield '*BOUNDARY'
        yield from (f'{n + 1}, {d + 1}, {d + 1}, {way:.12e}' for (n, d), way in moved.items())
        if forces:
            yield '*CLOAD'
        yield from (f'{n + 1}, {d + 1}, {force:.12e}' for (n, d), force in forces.items())
        yield from ('*NODE PRINT, NSET=ALL', 'U', '*EL PRINT, ELSET=ALL, TOTALS=ONLY', 'ELSE')
    yield '*END STEP'


def element_lines(body, young, poisson, density):
    """A set of elements, a material and a section for each weight in each tissue."""
    weights = np.ones(len(body.elements)) if body.weights is None else body.weights
    tissues = np.zeros(len(body.elements), int) if body.tissues is None else body.tissues
    values = sorted(set(zip(weights, tissues)))
    young, poisson = np.atleast_1d(young), np.atleast_1d(poisson)
    for k, (weight, tissue) in enumerate(values):
        yield f'*ELEMENT, TYPE={body.kind}, ELSET=E{k}'
        for e in np.flatnonzero((weights == weight) & (tissues == tissue)):
            numbers = [str(v) for v in (e + 1, *(body.elements[e] + 1))]
            yield ', '.join(numbers[:12]) + (',' if len(numbers) > 12 else '')
            if len(numbers) > 12:
                yield ', '.join(numbers[12:])
        yield from (f'*MATERIAL, NAME=M{k}', '*ELASTIC', f'{weight * young[tissue]:.12e}, {poisson[tissue]:.12e}')
        if density:
            yield from ('*DENSITY', f'{weight * density:.12e}')
        yield f'*SOLID SECTION, ELSET=E{k}, MATERIAL=M{k}'
    yield '*ELSET, ELSET=ALL'
    yield from (f'E{k}' for k in range(len(values)))


def read_static(text, count):
    u = np.zeros((count, 3))
    for line in text.split('internal energy')[0].split('\n'):
        row = line.split()
        if len(row) == 4 and row[0].isdigit():
            u[int(row[0]) - 1] = [float(v) for v in row[1:]]
    energy = re.search(r'total internal energy[^\n]*\n\s*([-+.\dE]+)', text)
    return {'u': u, 'energy': float(energy.group(1))}


def read_frequencies(text, modes):
    block = text.split('E I G E N V A L U E')[1].split('P A R T I C I P A T I O N')[0]
    rows = [line.split() for line in block.split('\n')]
    return {'frequencies': [float(row[3]) for row in rows if len(row) == 5 and row[0].isdigit()][:modes]}
