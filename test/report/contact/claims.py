import unittest

from contact.figures import coarsest, curves, errors, find, order
from measured import measured

DATA = measured('contact')


class Contact(unittest.TestCase):
    def test_every_step_settles(self):
        self.assertEqual(len(DATA['problems']), 5)
        for problem, curve in curves(DATA):
            for point in curve['points']:
                self.assertEqual(point['unsettled'], 0, (problem['name'], curve['name']))

    def test_the_force_under_a_sphere_comes_down_to_hertz_at_first_order(self):
        points = find(DATA, 'sphere pressed into a block', 'graded grid')
        for coarse, fine in zip(points, points[1:]):
            self.assertGreater(coarse['error'], fine['error'])
        self.assertGreater(points[-1]['error'], 0)
        self.assertLess(points[-1]['error'] * points[-1]['across'], 2.5)

    def test_what_friction_can_hold_it_holds(self):
        for step, most in (('10', 0.05), ('2.5', 0.01)):
            for error in errors(find(DATA, 'layer held by friction', f'steps of {step} ms')):
                self.assertLess(error, most)

    def test_a_block_slides_as_coulomb_says_to_the_error_of_the_step(self):
        for solver in ('direct', 'iterative'):
            points = find(DATA, 'block that slides', solver)
            for point in points:
                self.assertAlmostEqual(point['error'], point['time_step'] / 0.5, delta=1e-3)

    def test_both_solvers_slide_alike(self):
        for a, b in zip(*(find(DATA, 'block that slides', solver) for solver in ('direct', 'iterative'))):
            self.assertLess(abs(a['error'] - b['error']), 1e-4)

    def test_what_joints_give_way_goes_with_shorter_steps(self):
        whole, long, short = (find(DATA, 'column of three pieces', name) for name in (
            'whole, steps of 10 ms', 'cut, steps of 10 ms', 'cut, steps of 2.5 ms'))
        self.assertGreater(order(long), 0.9)
        for of_whole, of_long, of_short in zip(whole, long, short):
            self.assertGreater(of_long['error'], of_whole['error'])
            self.assertLess(of_short['error'], 0.3 * of_long['error'])

    def test_a_bar_that_beats_on_itself_converges_with_the_step(self):
        points = find(DATA, 'slit bar that beats on itself', 'shorter steps')
        for coarse, fine in zip(points, points[1:]):
            self.assertLess(abs(fine['error']), 0.6 * abs(coarse['error']))

    def test_finer_meshes_stay_within_a_per_cent_of_the_finest(self):
        points = find(DATA, 'slit bar that beats on itself', 'finer meshes')
        self.assertIsNotNone(coarsest(points, 0.0125))
