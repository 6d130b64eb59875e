#!/usr/bin/python3
"""Measures against CalculiX, an independent finite element program: that the references are right, and that its linear
tetrahedra are incision's. Environment: INCISION_BATCH, the path of incision_batch.
"""

import argparse
import json
import pathlib
import sys
import tempfile

import references
import same
from problems import E, H, L, STRESS

POISSON_RATIOS = (0.0, 0.3, 0.45, 0.49, 0.499)


def locking(folder, quick):
    """Deflection [m] of the cantilever by quadratic bricks on two meshes, and by incision's linear tetrahedra."""
    coarse, fine = (2, 4) if quick else (3, 6)
    tets = (4, 8) if quick else (4, 8, 12)
    found = {'poisson': POISSON_RATIOS, 'quadratic': [references.cantilever(fine, nu) for nu in POISSON_RATIOS],
             'coarse': [references.cantilever(coarse, nu) for nu in POISSON_RATIOS], 'tetrahedra': []}
    for n in tets:
        mesh = {'grid': {'cells': [5 * n, n, n], 'size': [L, H, H]}}
        runs = [same.batch(folder, same.scene(mesh, 1e-9, 1, poisson=nu), '--steps', '1') for nu in POISSON_RATIOS]
        found['tetrahedra'].append({'cells': n, 'deflection': [2 * run['elastic_energy'] / (STRESS * H ** 2)
                                                               for run in runs]})
    return found


def claims_of(data):
    claims = []

    def below(what, value, bound):
        claims.append({'claim': what, 'measured': f'{value:.3g}', 'wanted': f'< {bound:.3g}',
                       'holds': bool(value < bound)})

    for found in data['same']:
        below(f'same tetrahedra, {found["mesh"]}: largest difference of displacements from CalculiX, relative to the '
              'largest displacement', found['difference'], 1e-6)
    for found in data['references']:
        bound = 0.03 if 'crack' in found['name'] else 0.003
        below(f'{found["name"]}: CalculiX\'s quadratic elements, extrapolated, against the answer, relative',
              abs(found['limit'] / found['answer'] - 1), bound)
    bar = data['frequencies']
    below('first frequency, the same tetrahedra and mass at one point: incision against CalculiX, relative',
          abs(bar['at_one_point'] / bar['calculix'][0] - 1), 2e-5)
    below('first frequency: lumped against consistent mass, relative', abs(bar['lumped'] / bar['consistent'] - 1), 0.01)
    for k, over in enumerate(('height', 'width')):
        below(f'first frequency of bending over the {over}: CalculiX\'s quadratic bricks against Timoshenko, relative',
              abs(bar['quadratic'][k] / bar['beam'][k] - 1), 0.01)
    found = data['locking']
    below('cantilever, ν up to 0.499: quadratic bricks of half the edge change the deflection by, relative',
          max(abs(c / f - 1) for c, f in zip(found['coarse'], found['quadratic'])), 0.03)
    return claims


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('--quick', action='store_true', help='smaller meshes')
    parser.add_argument('--output', required=True, metavar='FILE.json')
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        data = {'quick': options.quick, 'same': same.same_displacements(folder, options.quick),
                'frequencies': same.frequencies(folder, options.quick), 'locking': locking(folder, options.quick),
                'references': references.references(folder, options.quick)}
    data['claims'] = claims_of(data)
    for claim in data['claims']:
        print(f'{claim["claim"]}: {claim["measured"]} ({claim["wanted"]}){"" if claim["holds"] else "  FAILS"}')
    pathlib.Path(options.output).write_text(json.dumps(data, indent=1) + '\n', encoding='utf-8')
    return 0 if all(claim['holds'] for claim in data['claims']) else 1


if __name__ == '__main__':
    sys.exit(main())
