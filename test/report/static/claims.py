import unittest

from measured import measured
from static.figures import constant, curves, finest_errors, limit, missing, order, quantities

DATA = measured('static')

# Grids are alike everywhere, Gmsh's meshes vary with its version. Order expected and whether unstructured, then: the
# least order, the largest error at edge 0, and that of a crack inside elements over that of one on faces.
GROUPS = {'beams on grids': (2, False, 1.9, 0.01, 1.05), "beams on Gmsh's meshes": (2, True, 1.7, 0.04, 1.2),
          'cracks that end, on grids': (1, False, 0.75, 0.15, 1.7),
          "cracks that end, on Gmsh's meshes": (1, True, 0.5, 0.15, 3.5)}


class Static(unittest.TestCase):
    def test_bent_bar_converges_in_both_norms(self):
        self.assertEqual(len(DATA['bending']), 2)
        for of in DATA['bending']:
            self.assertGreater(order(of['points'], 'displacement'), 1.8)
            self.assertGreater(order(of['points'], 'energy'), 0.9)

    def test_both_solvers_find_one_energy(self):
        for at in DATA['solvers']:
            self.assertLess(abs(at['iterative_energy'] / at['direct_energy'] - 1), 2e-4)

    def test_only_cracks_inside_elements_split_them(self):
        for problem, quantity in quantities(DATA):
            for curve in quantity['curves']:
                inside = problem != 'cantilever' and not curve['faces']
                for point in curve['points']:
                    for split in point['parts_split']:
                        self.assertEqual(split > 0, inside, problem)

    def test_errors_converge(self):
        for name, (expected, unstructured, least, _, _) in GROUPS.items():
            found = curves(DATA, expected, unstructured=unstructured, longer=False)
            self.assertGreater(min(order(curve['points']) for curve in found), least, name)

    def test_errors_vanish_at_edge_0(self):
        for name, (expected, unstructured, _, most, _) in GROUPS.items():
            found = curves(DATA, expected, unstructured=unstructured, longer=False)
            self.assertLess(max(abs(limit(curve)) for curve in found), most, name)

    def test_crack_inside_elements_is_about_as_exact_as_on_faces(self):
        for name, (expected, unstructured, _, _, most) in GROUPS.items():
            inside, faces = (curves(DATA, expected, unstructured=unstructured, longer=False, faces=on)
                             for on in (False, True))
            faces = faces[-len(inside):]  # of these, the cantilever without a crack is the first
            self.assertEqual(len(inside), len(faces))
            for a, b in zip(inside, faces):
                self.assertLess(constant(a) / constant(b), most, name)

    def test_cantilever_on_the_finest_grid_is_exact_to_3_per_cent(self):
        problem, quantity = quantities(DATA)[0]
        self.assertEqual((problem, quantity['curves'][0]['unstructured']), ('cantilever', False))
        self.assertLess(quantity['curves'][0]['points'][-1]['error'], 0.03)

    def test_longer_cracks_halve_the_error(self):
        for unstructured in (False, True):
            plain, longer = (max(finest_errors(DATA, unstructured=unstructured, faces=False, longer=way))
                             for way in (False, True))
            self.assertLess(longer, 0.5 * plain)

    def test_cracks_act_as_if_shorter_by_less_than_an_edge(self):
        for faces, most in ((True, 0.8), (False, 1)):
            self.assertLess(max(edges[-1] for edges in missing(DATA, faces)), most)
