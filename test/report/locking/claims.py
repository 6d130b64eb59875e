import unittest

from locking.figures import at_ratio
from measured import measured

DATA = measured('locking')


class Locking(unittest.TestCase):
    def errors(self, kind):
        """|error| of the three problems at the largest ν."""
        self.assertEqual([of['ratios'][-1] for of in DATA['errors']], [0.4999] * 3)
        return [abs(of[kind][-1]) for of in DATA['errors']]

    def test_plain_elements_lock_on_any_mesh(self):
        self.assertGreater(min(self.errors('plain') + self.errors('plain unstructured')), 0.5)

    def test_averaged_pressure_does_not_lock_on_grids(self):
        self.assertLess(max(self.errors('averaged')), 0.2)

    def test_averaged_pressure_hardly_locks_on_unstructured_meshes(self):
        self.assertLess(max(self.errors('averaged unstructured')), 0.5)

    def test_smaller_poissons_ratio_is_a_fair_model_of_a_bent_beam(self):
        cantilever = next(of for of in DATA['errors'] if of['problem'] == 'cantilever')
        self.assertLess(abs(cantilever['model']['capped']), 0.02)

    def test_averaged_pressure_needs_no_more_iterations(self):
        for at in DATA['solvers']['steps']:
            self.assertLess(at['averaged']['iterations'], 1.1 * at['plain']['iterations'], at['ratio'])

    def test_averaged_pressure_less_than_doubles_the_matrix(self):
        self.assertLess(DATA['solvers']['blocks'], 2)

    def test_averaged_pressure_does_not_lock_in_cut_elements(self):
        for at in DATA['cut']:
            compressible = at_ratio([of for of in DATA['cut'] if of['layers'] == at['layers']], 0.3)
            self.assertLess(at['averaged'] / compressible['averaged'], 1.2, at['ratio'])

    def test_cut_adds_hardly_any_energy_up_to_moderate_ratios(self):
        at = at_ratio(DATA['jump'], DATA['moderate'])
        self.assertEqual(at['ratio'], 0.49)
        self.assertLess(at['averaged']['added'], 0.05)
