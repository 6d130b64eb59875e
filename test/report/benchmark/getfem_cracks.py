#!/usr/bin/python3
"""Solves round flat cracks by GetFEM's level-set extended elements.

usage: getfem_cracks.py PROBLEM.json CELLS SINGULAR FILE.json

The problem is as report_benchmark describes it; the block, its grid and what holds it are those of incision. Writes
what incision's program writes of a mesh: jumps along the same rays, freedoms, wall time. SINGULAR is 1 with the four
singular functions round the front, 0 with the jump alone. GetFEM 5.4 has its singular functions in the plane only, so
here they stand in the weak form: u + Σ F_k w_k, with w_k in the linear elements of the nodes round the front.
"""

import json
import sys
import time

import numpy as np

import getfem as gf

from calculix.bodies import grid

FINE_HALF, FINE_SHARE, BLOCK_HALF = 1.3, 0.7, 4  # the block of support/penny_crack.h, in radii
ENRICHED = 0.35  # how far from the front nodes have singular functions, in radii
SURFACE, ROUND_FRONT = 1, 2  # regions
PENALTY = 1e3  # over Young's modulus, for what holds the surface
APART = 1e-5  # of either side of the crack where jumps are taken, in radii

# Polar coordinates round the front x = y = 0, as far as they are smooth on either side of the crack, and √r sin θ/2,
# √r cos θ/2, √r sin θ/2 sin θ, √r cos θ/2 sin θ with their gradients. The crack's axis is the third.
MACROS = {'Rho': 'sqrt(X(1)*X(1)+X(2)*X(2))', 'Px': '(Rho-{radius})', 'Py': 'X(3)', 'Pr': 'sqrt(Px*Px+Py*Py)',
          'Ex': '[X(1)/Rho;X(2)/Rho;0]', 'Ey': '[0;0;1]', 'Sin': '(Py/Pr)',
          'Turn': '(Ey/Pr-Py*(Px*Ex+Py*Ey)/(Pr*Pr*Pr))',
          'F0': '(sign(Py)*sqrt((Pr-Px)/2))', 'F1': 'sqrt((Pr+Px)/2)', 'F2': '(F0*Sin)', 'F3': '(F1*Sin)',
          'G0': '((F1*Ey-F0*Ex)/(2*Pr))', 'G1': '((F0*Ey+F1*Ex)/(2*Pr))', 'G2': '(G0*Sin+F0*Turn)',
          'G3': '(G1*Sin+F1*Turn)'}
FUNCTIONS = range(4)


def block(problem, cells):
    """The graded block in the crack's own axes, and the edge of its cells round the crack in radii."""
    body = grid((cells,) * 3, (2,) * 3)
    places = body.nodes - 1
    beyond = np.maximum(0, (abs(places) - FINE_SHARE) / (1 - FINE_SHARE))
    near = np.minimum(abs(places) / FINE_SHARE, 1)
    nodes = np.copysign(FINE_HALF * near + (BLOCK_HALF - FINE_HALF) * beyond ** 1.5, places)
    corners = nodes[body.elements]
    inside = (abs(corners.mean(axis=1)) <= FINE_HALF).all(axis=1)
    volumes = abs(np.linalg.det(corners[inside, 1:] - corners[inside, :1])) / 6
    nodes = problem['radius'] * nodes @ np.array(problem['axes'])
    return nodes, body.elements, np.cbrt(6 * volumes.mean())


def far_field(problem, places):
    """Displacement of uniform stress and of the crack's moment, as crack_problem.cpp has it, in the crack's axes."""
    axes, nu, young = np.array(problem['axes']), problem['poisson_ratio'], problem['young_modulus']
    stress, moment = (axes.T @ np.array(problem[key]) @ axes for key in ('stress', 'moment'))
    mu = young / (2 * (1 + nu))
    strain = (moment + moment.T) / 2
    force = 2 * mu * (strain + nu / (1 - 2 * nu) * np.trace(strain) * np.eye(3))
    r = np.linalg.norm(places, axis=1, keepdims=True)
    n = places / r
    pulled = n @ force
    turned = (2 - 4 * nu) * pulled - np.trace(force) * n + 3 * (n * pulled).sum(axis=1, keepdims=True) * n
    uniform = ((1 + nu) * places @ stress - nu * np.trace(stress) * places) / young
    return uniform + turned / (16 * np.pi * mu * (1 - nu) * r ** 2)


class Model:
    """The body with its crack; solved when made."""

    def __init__(self, problem, nodes, elements, singular):
        self.problem, self.radius = problem, problem['radius']
        self.mesh = gf.Mesh('ptND', nodes.T, elements.T)
        self.mesh.set_region(SURFACE, self.mesh.outer_faces())
        crack = gf.LevelSet(self.mesh, 1, 'z', f'sqrt(x*x+y*y)-{self.radius!r}')
        self.levels = gf.MeshLevelSet(self.mesh)
        self.levels.add(crack)
        self.levels.adapt()
        linear = gf.MeshFem(self.mesh)
        linear.set_classical_fem(1)
        split = gf.MeshFem('levelset', self.levels, linear)
        split.set_qdim(3)
        self.model = gf.Model('real')
        self.model.add_fem_variable('u', split)
        for name, text in MACROS.items():
            self.model.add_macro(name, text.format(radius=repr(self.radius)))
        nu, young = problem['poisson_ratio'], problem['young_modulus']
        self.model.add_initialized_data('Lambda', [young * nu / ((1 + nu) * (1 - 2 * nu))])
        self.model.add_initialized_data('Mu', [young / (2 * (1 + nu))])
        within = self.integration('IM_TETRAHEDRON(2)')
        self.model.add_linear_term(within, f'{self.stress("Grad_u")}:Grad_Test_u')
        if singular:
            self.enrich(nodes, elements)
        self.hold(within)
        self.model.solve('lsolver', 'mumps')
        self.displacement = 'u' + ''.join(f'+F{k}*w{k}' for k in FUNCTIONS if singular)

    @staticmethod
    def stress(gradient):
        return f'(Lambda*Trace({gradient})*Id(3)+2*Mu*Sym({gradient}))'

    def integration(self, name):
        """On whole elements and on both sides of cut ones."""
        method = gf.MeshIm('levelset', self.levels, 'all', gf.Integ(name))
        method.set_integ(gf.Integ(name))
        method.adapt()
        return method

    def enrich(self, nodes, elements):
        def near(places):
            return np.hypot(np.hypot(places[0], places[1]) - self.radius, places[2]) < ENRICHED * self.radius

        vectors = gf.MeshFem(self.mesh, 3)
        vectors.set_classical_fem(1)
        weights = gf.MeshFem('partial', vectors, np.flatnonzero(near(vectors.basic_dof_nodes())))
        touched = np.flatnonzero(near(nodes.T)[elements].any(axis=1))
        self.mesh.set_region(ROUND_FRONT, touched.reshape(1, -1))
        for k in FUNCTIONS:
            self.model.add_fem_variable(f'w{k}', weights)
        added = '(' + '+'.join(f'F{k}*Grad_w{k}+w{k}@G{k}' for k in FUNCTIONS) + ')'
        tested = '(' + '+'.join(f'F{k}*Grad_Test_w{k}+Test_w{k}@G{k}' for k in FUNCTIONS) + ')'
        self.model.add_linear_term(
            self.integration('IM_TETRAHEDRON(6)'),
            f'{self.stress("Grad_u")}:{tested}+{self.stress(added)}:Grad_Test_u+{self.stress(added)}:{tested}',
            ROUND_FRONT)

    def hold(self, method):
        vectors = gf.MeshFem(self.mesh, 3)
        vectors.set_classical_fem(1)
        places = vectors.basic_dof_nodes()[:, ::3].T
        places[np.linalg.norm(places, axis=1) < self.radius] = self.radius  # none of the surface
        self.model.add_initialized_fem_data('held', vectors, far_field(self.problem, places).ravel())
        self.model.add_Dirichlet_condition_with_penalization(
            method, 'u', PENALTY * self.problem['young_modulus'], SURFACE, 'held')

    def jumps(self, problem):
        """By ray and place, ahead, across and along the front."""
        angles = 2 * np.pi * np.arange(problem['rays']) / problem['rays']
        behind = problem['length'] * (np.arange(problem['places']) + 0.5) / problem['places']
        ahead = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)
        places = self.radius * (ahead[:, None, :] * (1 - behind)[None, :, None]).reshape(-1, 3).T
        off = np.array([[0], [0], [APART * self.radius]])
        above, below = (np.reshape(self.model.interpolation(self.displacement, places + way, self.mesh), (-1, 3))
                        for way in (off, -off))
        jump = (above - below).reshape(len(angles), len(behind), 3)
        axes = np.stack([ahead, np.tile([0, 0, 1], (len(angles), 1)), np.cross(ahead, [0, 0, 1])], axis=1)
        return np.einsum('kij,krj->kri', axes, jump)


def main(problem_file, cells, singular, file):
    gf.util('trace level', 0)
    gf.util('warning level', 0)
    with open(problem_file, encoding='utf-8') as text:
        problem = json.load(text)
    nodes, elements, edge = block(problem, int(cells))
    start = time.monotonic()
    model = Model(problem, nodes, elements, singular == '1')
    ms = 1000 * (time.monotonic() - start)
    with open(file, 'w', encoding='utf-8') as text:
        json.dump({'cells': int(cells), 'edge': edge, 'ms': ms, 'freedoms': model.model.nbdof(),
                   'rays': model.jumps(problem).tolist()}, text)


if __name__ == '__main__':
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    main(*sys.argv[1:])
