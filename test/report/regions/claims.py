import unittest

from measured import measured
from regions.figures import LAYERS, apart, balls, beams, finest, limit, more_iterations, order, rounding

DATA = measured('regions')

TOLERANCE = 1e-6  # of the iteration, the default


class Regions(unittest.TestCase):
    def test_linear_fields_of_two_materials_are_exact_to_rounding(self):
        self.assertEqual({(body['problem'], body['unstructured']) for body in DATA['exact']['bodies']},
                         {(problem, on) for problem in ('rod', 'patch') for on in (False, True)})
        for body in DATA['exact']['bodies']:
            self.assertLess(body['direct'], 10 * rounding(DATA, body['contrast']), body)

    def test_iteration_has_linear_fields_to_ten_times_its_tolerance(self):
        for body in DATA['exact']['bodies']:
            self.assertLess(body['iterative'], 10 * TOLERANCE, body)

    def test_ball_like_its_matrix_does_not_show(self):
        same = [curve for curve in DATA['ball']['curves'] if curve['contrast'] == 1]
        self.assertEqual(len(same), 2)
        for curve in same:
            for point in curve['points']:
                self.assertLess(max(abs(point['error']), point['displacement']), TOLERANCE)

    def test_ball_of_faces_converges_at_second_order(self):
        for curve in balls(DATA, True):
            self.assertGreater(order(curve['points']), 1.7, curve['contrast'])
            self.assertGreater(order(curve['points'], 'displacement'), 1.7, curve['contrast'])

    def test_staircase_converges_at_first_order(self):
        for curve in balls(DATA, False):
            self.assertGreater(order(curve['points'], 'displacement'), 0.7, curve['contrast'])
            self.assertLess(order(curve['points'], 'displacement'), 1.5, curve['contrast'])

    def test_faces_on_the_ball_at_least_halve_the_error_of_the_displacement(self):
        for stairs, faces in zip(balls(DATA, False), balls(DATA, True)):
            self.assertEqual(stairs['contrast'], faces['contrast'])
            self.assertLess(finest(faces)['displacement'], 0.5 * finest(stairs)['displacement'], faces['contrast'])

    def test_staircase_makes_a_stiff_ball_stretch_more(self):
        for curve in balls(DATA, False):
            if curve['contrast'] > 1:
                self.assertGreater(finest(curve)['error'], 0.05)

    def test_error_of_a_ball_no_longer_grows_from_a_contrast_of_100_on(self):
        for conforming in (False, True):
            for some, much in ((100, 1e4), (0.01, 1e-4)):
                at = [finest(balls(DATA, conforming, [contrast])[0])['displacement'] for contrast in (some, much)]
                self.assertLess(at[1], 1.25 * at[0], (conforming, much))

    def test_ball_is_solved_by_the_iteration_at_any_contrast(self):
        for curve in DATA['ball']['curves']:
            self.assertFalse(any(point['gave_up'] for point in curve['points']), curve['contrast'])

    def test_contrast_less_than_trebles_the_iterations(self):
        for contrast in (1e4, 1e-4):
            found = more_iterations(DATA, contrast)
            self.assertGreater(len(found), 2)
            self.assertLess(max(found), 3, contrast)

    def test_both_solvers_find_one_answer(self):
        for at in DATA['ball']['solvers'] + [curve['solvers'] for curve in DATA['layers']['curves']]:
            self.assertLess(apart(at), 1e-4)

    def test_layered_beams_converge_at_second_order(self):
        for curve in beams(DATA):
            self.assertGreater(order(curve['points']), 1.9, (curve['beam'], curve['contrast']))

    def test_layered_beams_are_the_transformed_section_at_edge_0(self):
        for curve in beams(DATA):
            self.assertLess(abs(limit(curve)), 0.01, (curve['beam'], curve['contrast']))

    def test_shear_hardly_matters(self):
        for curve in beams(DATA):
            self.assertLess(curve['shear'], 0.01)

    def test_error_of_layers_is_by_the_cells_across_what_is_stiff(self):
        scaled = [finest(curve)['error'] * finest(curve)['stiff_cells'] ** 2 for name in LAYERS
                  for curve in beams(DATA, name, [1, 1e4])]
        self.assertLess(max(scaled), 1.1 * min(scaled))

    def test_solvers_agree_on_beams_bent_by_a_thousandth_or_more(self):
        for beam in DATA['layers']['small_loads']:
            for point in beam['points']:
                if point['deflection'] >= 1e-3:
                    self.assertLess(apart(point), 1e-4, beam['contrast'])
