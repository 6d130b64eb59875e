import unittest

from dynamic.figures import at_step, order, problem
from measured import measured

DATA = measured('dynamic')


class Dynamic(unittest.TestCase):
    def test_free_oscillation_follows_the_formulas(self):
        self.assertEqual(len(DATA['oscillation']), 4)
        for curve in DATA['oscillation']:
            for point in curve['points']:
                self.assertLess(point['off'], 1e-8, curve['name'])

    def test_bdf2_gains_no_energy_in_steps_up_to_20_ms(self):
        undisturbed = [p for p in DATA['integrators'] if p['name'] != 'swinging']
        self.assertTrue(undisturbed)
        for of in undisturbed:
            bdf2 = problem(DATA, of['name'], of['young_modulus'])['BDF2']
            for point in bdf2['points']:
                if point['time_step'] <= 0.02:
                    self.assertLess(point['energy_growth'], 1e-3, of['name'])

    def test_bdf2_has_a_fifth_of_eulers_error(self):
        euler, bdf2 = (problem(DATA, 'swinging')[name] for name in ('implicit Euler', 'BDF2'))
        self.assertLess(5 * at_step(bdf2, 0.005)['error'], at_step(euler, 0.005)['error'])

    def test_newton_iterations_do_not_pay(self):
        euler, newton = (problem(DATA, 'swinging')[name] for name in ('implicit Euler', 'Euler, 2 Newton iterations'))
        self.assertGreater(at_step(newton, 0.005)['error'], 0.95 * at_step(euler, 0.005)['error'])

    def test_euler_is_of_first_order(self):
        self.assertGreater(order(problem(DATA, 'swinging')['implicit Euler']), 0.8)

    def test_bdf2_is_of_second_order(self):
        self.assertGreater(order(problem(DATA, 'spinning')['BDF2'], (0.02, 0.005)), 1.8)

    def test_tolerance_of_1e_4_is_as_exact_as_the_direct_solver(self):
        self.assertEqual(len(DATA['solvers']), 2)
        for of in DATA['solvers']:
            curves = {curve['name']: curve['points'] for curve in of['curves']}
            for loose, direct in zip(curves['iterative, 1e-04'], curves['direct']):
                self.assertLess(abs(loose['error'] / direct['error'] - 1), 0.05, of['scheme'])
