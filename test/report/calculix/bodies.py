"""Meshes for CalculiX: boxes of quadratic bricks or linear tetrahedra, Gmsh's tetrahedra, slits, and tractions."""

import dataclasses
import itertools
import subprocess

import numpy as np

# Local nodes of the faces, corners first, and the share of a uniform traction that each node takes.
TRIANGLES = [(0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)]
TET_EDGES = [(0, 1), (1, 2), (0, 2), (0, 3), (1, 3), (2, 3)]
QUADS = [(0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
BRICK_EDGES = [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)]


def with_middles(faces, edges, corners):
    """The faces with the middle nodes of their edges, which are numbered after the corners."""
    number = {frozenset(edge): corners + k for k, edge in enumerate(edges)}
    return [face + tuple(number[frozenset(pair)] for pair in zip(face, face[1:] + face[:1])) for face in faces]


FACES = {'C3D4': (TRIANGLES, [1 / 3] * 3),
         'C3D10': (with_middles(TRIANGLES, TET_EDGES, 4), [0] * 3 + [1 / 3] * 3),
         'C3D20R': (with_middles(QUADS, BRICK_EDGES, 8), [-1 / 12] * 4 + [1 / 3] * 4)}


@dataclasses.dataclass
class Body:
    """Nodes [m] and elements of one of CalculiX's types, by nodes counted from 0; weights are shares of the material's
    stiffness, by element, 1 where there are none; tissues say which of several materials an element is of, the first
    where there are none."""
    nodes: np.ndarray
    elements: np.ndarray
    kind: str
    weights: np.ndarray = None
    tissues: np.ndarray = None

    def in_box(self, low, high):
        """Whether the centroids of elements lie in a box."""
        centroids = self.nodes[self.elements].mean(axis=1)
        return ((centroids >= low) & (centroids <= high)).all(axis=1)

    def at(self, axis, place):
        """Nodes in a plane."""
        return np.flatnonzero(abs(self.nodes[:, axis] - place) < 1e-9)

    def traction(self, axis, place, stress, where=lambda centres: np.ones(len(centres), bool)):
        """{(node, direction): force [N]} of a traction [Pa] on the faces in a plane whose centres `where` accepts."""
        forces = np.zeros_like(self.nodes)
        local_faces, shares = FACES[self.kind]
        corners = 3 if len(shares) in (3, 6) and self.kind != 'C3D20R' else 4
        for local in local_faces:
            faces = self.elements[:, local]
            points = self.nodes[faces[:, :corners]]
            loaded = (abs(points[:, :, axis] - place) < 1e-9).all(axis=1) & where(points.mean(axis=1))
            a, b, c = (points[loaded, k] for k in range(3))
            area = np.linalg.norm(np.cross(b - a, c - a), axis=1) / (2 if corners == 3 else 1)
            for share, nodes in zip(shares, faces[loaded].T):
                np.add.at(forces, nodes, share * area[:, None] * np.asarray(stress))
        return {(n, d): forces[n, d] for n, d in zip(*np.nonzero(forces))}

    def slit(self, axis, place, where):
        """Gives the nodes in the plane that `where` accepts to the elements above as new ones; returns their twins,
        {node below: node above}."""
        split = np.array([n for n in self.at(axis, place) if where(self.nodes[n])])
        twins = dict(zip(split, range(len(self.nodes), len(self.nodes) + len(split))))
        above = self.nodes[self.elements].mean(axis=1)[:, axis] > place
        self.elements[above] = np.vectorize(lambda n: twins.get(n, n))(self.elements[above])
        self.nodes = np.vstack([self.nodes, self.nodes[split]])
        return twins


def bricks(cells, size, spacing=None):
    """A box of C3D20R; spacing maps an axis to its places of the corners, instead of equal cells."""
    places = [(spacing or {}).get(a, np.linspace(0, size[a], cells[a] + 1)) for a in range(3)]
    lattice = [np.sort(np.concatenate([p, (p[1:] + p[:-1]) / 2])) for p in places]  # with the middles
    counts = [len(p) for p in lattice]
    corners = [(0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)]
    offsets = corners + [tuple((np.add(corners[a], corners[b])) // 2) for a, b in BRICK_EDGES]
    starts = np.array(list(itertools.product(*(range(0, n - 1, 2) for n in counts))))
    elements = np.stack([np.ravel_multi_index((starts + o).T, counts) for o in offsets], axis=1)
    nodes = np.stack(np.meshgrid(*lattice, indexing='ij'), axis=-1).reshape(-1, 3)
    used, elements = np.unique(elements, return_inverse=True)
    return Body(nodes[used], elements.reshape(-1, 20), 'C3D20R')


def cut_through(body, place):
    """Linear tetrahedra cut by the plane z = place midway through a layer of the grid: two bodies, the lower and then
    the upper, that each have the whole of every element they own a part of, with the part's share of its volume as its
    weight. The upper body's nodes are numbered in the same order after the lower's."""
    above = (body.nodes[body.elements][:, :, 2] > place).sum(axis=1)
    share = np.array([0, 1 / 8, 1 / 2, 7 / 8, 1])[above]  # the plane halves every edge it meets
    upper, lower = above > 0, above < 4
    return Body(np.vstack([body.nodes, body.nodes]),
                np.vstack([body.elements[lower], body.elements[upper] + len(body.nodes)]), body.kind,
                np.concatenate([1 - share[lower], share[upper]]),
                None if body.tissues is None else np.concatenate([body.tissues[lower], body.tissues[upper]]))


def quadratic(body):
    """Linear tetrahedra with middle nodes on their straight edges."""
    ends = np.sort(np.concatenate([body.elements[:, edge] for edge in TET_EDGES]), axis=1)
    edges, number = np.unique(ends, axis=0, return_inverse=True)
    middles = len(body.nodes) + number.reshape(len(TET_EDGES), -1).T
    return Body(np.vstack([body.nodes, body.nodes[edges].mean(axis=1)]), np.hstack([body.elements, middles]), 'C3D10')


def grid(cells, size):
    """The grid of incision's scenes: node (i, j, k) is number (i (ny + 1) + j)(nz + 1) + k, each cell is six Kuhn
    tetrahedra round its diagonal."""
    counts = [n + 1 for n in cells]
    nodes = np.stack(np.meshgrid(*(np.linspace(0, s, n) for s, n in zip(size, counts)), indexing='ij'), axis=-1)
    starts = np.array(list(itertools.product(*(range(n) for n in cells))))
    elements = []
    for axes in itertools.permutations(range(3)):
        walk = np.cumsum([np.zeros(3, int)] + [np.eye(3, dtype=int)[a] for a in axes], axis=0)
        if np.linalg.det(walk[1:]) < 0:
            walk = walk[[0, 1, 3, 2]]
        elements.append(np.stack([np.ravel_multi_index((starts + w).T, counts) for w in walk], axis=1))
    return Body(nodes.reshape(-1, 3), np.concatenate(elements), 'C3D4')


def gmsh(script, folder, **numbers):
    """Gmsh's tetrahedra for a script; returns the body and the mesh file."""
    path = folder / 'mesh.msh'
    settings = [text for key, value in numbers.items() for text in ('-setnumber', key, str(value))]
    subprocess.run(['gmsh', '-3', '-format', 'msh22', '-v', '1', script, *settings, '-o', path],
                   check=True, stdout=subprocess.DEVNULL)
    lines = path.read_text().split('\n')
    start = lines.index('$Nodes')
    table = np.array([line.split() for line in lines[start + 2:start + 2 + int(lines[start + 1])]], float)
    start = lines.index('$Elements')
    rows = [line.split() for line in lines[start + 2:start + 2 + int(lines[start + 1])]]
    number = {int(tag): k for k, tag in enumerate(table[:, 0])}
    elements = np.array([[number[int(n)] for n in row[-4:]] for row in rows if row[1] == '4'])
    return Body(table[:, 1:], elements, 'C3D4'), path
