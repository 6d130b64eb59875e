"""Measures against CalculiX, an independent finite element program: that the references are right, and that its linear
tetrahedra are incision's.
"""

import pathlib
import tempfile

from calculix import references, same
from calculix.problems import H, L, STRESS

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


def measure(quick):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        return {'same': same.same_displacements(folder, quick), 'frequencies': same.frequencies(folder, quick),
                'locking': locking(folder, quick), 'references': references.references(folder, quick)}
