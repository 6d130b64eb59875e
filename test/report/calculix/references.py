"""CalculiX's quadratic elements against the answers that the static section uses."""

import pathlib

import numpy as np
from calculix.bodies import bricks, gmsh, quadratic
from calculix.ccx import run
from calculix.problems import E, H, HALF, L, STRESS, TENSION, deflection, mean_intensity, penny_volume

HERE = pathlib.Path(__file__).resolve().parent


def clamp(body, up_to=0.0):
    return {n: (0, 1, 2) for n in np.flatnonzero(body.nodes[:, 0] < up_to + 1e-9)}


def cantilever(cells, poisson=0.0):
    """Load times way over load: the end's deflection [m]."""
    body = bricks((5 * cells, cells, cells), (L, H, H))
    found = run(body, E, poisson, clamp(body), body.traction(0, L, (0, 0, STRESS)))
    return 2 * found['energy'] / (STRESS * H ** 2)


def split_cantilever(cells):
    body = bricks((5 * cells, cells, cells), (L, H, H))
    body.slit(2, H / 2, lambda X: X[0] > 1e-9)
    found = run(body, E, 0, clamp(body), body.traction(0, L, (0, 0, STRESS)))
    return 2 * found['energy'] / (STRESS * H ** 2)


def arm_opening(cells, crack):
    """Opening [m] of an arm of the double cantilever beam, clamped up to the crack's front."""
    body = bricks((5 * cells, cells, cells), (L, H, H))
    body.slit(2, H / 2, lambda X: X[0] > L - crack + 1e-9)
    forces = body.traction(0, L, (0, 0, STRESS), lambda centres: centres[:, 2] > H / 2)
    forces.update(body.traction(0, L, (0, 0, -STRESS), lambda centres: centres[:, 2] < H / 2))
    return 2 * run(body, E, 0, clamp(body, L - crack), forces)['energy'] / (STRESS * H ** 2)


def arm_rate(cells):
    """Mean energy release rate [J/m²] from a crack of 0.6 to one of 0.8 m."""
    return STRESS * H ** 2 / 2 * (arm_opening(cells, 0.8) - arm_opening(cells, 0.6)) / (H * 0.2)


def edge_energy(cells, crack):
    """Strain energy [J] of the whole plate, by the half above the crack, one element thick."""
    fine = np.linspace(0, 0.5, cells // 2 + 1)
    away = 0.5 + np.cumsum(np.linspace(1, 3, cells // 2)) / np.sum(np.linspace(1, 3, cells // 2))
    body = bricks((cells, 1, cells), (1, 0.1, 1.5), {2: np.concatenate([fine, away])})
    held = {n: (1,) for n in body.at(1, 0)}
    for n in body.at(2, 0):
        if body.nodes[n, 0] > crack - 1e-9:
            held[n] = held.get(n, ()) + (2,)
    corner = np.argmin(np.linalg.norm(body.nodes - (1, 0, 0), axis=1))
    held[corner] += (0,)
    return 2 * run(body, E, 0, held, body.traction(2, 1.5, (0, 0, TENSION)))['energy']


def edge_intensity(cells):
    """Root of the mean K_I² [Pa√m] from a crack of 0.3 to one of 0.5 m."""
    return np.sqrt(E * (edge_energy(cells, 0.5) - edge_energy(cells, 0.3)) / (0.1 * 0.2))


def penny(folder, edge, poisson):
    """Opened volume [m³] in the block, by an eighth of it."""
    body = quadratic(gmsh(HERE / 'octant.geo', folder, edge=edge)[0])
    held = {}
    for axis in (0, 1):
        for n in body.at(axis, 0):
            held[n] = held.get(n, ()) + (axis,)
    for n in body.at(2, 0):
        if np.hypot(*body.nodes[n, :2]) > 1 - 0.2 * edge:  # the middles of the front's chords too
            held[n] = held.get(n, ()) + (2,)
    energy = 8 * run(body, E, poisson, held, body.traction(2, HALF, (0, 0, TENSION)))['energy']
    return 2 * (energy - TENSION ** 2 / (2 * E) * (2 * HALF) ** 3) / TENSION


def references(folder, quick):
    """Values on two meshes each, the second half as coarse; the limit goes by the order that theory gives."""
    beam = (2, 4) if quick else (4, 8)
    plate = (20, 40) if quick else (40, 80)
    edges = (0.12, 0.06) if quick else (0.06, 0.03)
    arm = STRESS * H ** 2 / 2 * (deflection(0.8, 0.5) - deflection(0.6, 0.5)) / (H * 0.2)
    cases = [('cantilever, deflection', 'm', deflection(L, 1), 4, beam, cantilever),
             ('split cantilever, deflection', 'm', deflection(L, 0.5), 4, beam, split_cantilever),
             ('double cantilever beam, opening', 'm', deflection(0.8, 0.5), 4, beam,
              lambda n: arm_opening(n, 0.8)),
             ('double cantilever beam, energy release rate', 'J/m²', arm, 4, beam, arm_rate),
             ('edge crack, K_I', 'Pa√m', mean_intensity(0.3, 0.5), 2, plate, edge_intensity)]
    cases += [(f'penny crack, opened volume, ν = {nu}', 'm³', penny_volume(nu), 2, edges,
               lambda edge, nu=nu: penny(folder, edge, nu)) for nu in (0, 0.3)]
    found = []
    for name, unit, answer, gain, meshes, value in cases:
        coarse, fine = (value(m) for m in meshes)
        found.append({'name': name, 'unit': unit, 'answer': answer, 'coarse': coarse, 'fine': fine,
                      'limit': fine + (fine - coarse) / (gain - 1)})
        print(found[-1], flush=True)
    return found
