import unittest

from measured import measured

DATA = measured('calculix')
BAR = DATA['frequencies']


class Calculix(unittest.TestCase):
    def off(self, value, reference):
        return abs(value / reference - 1)

    def test_linear_tetrahedra_move_as_in_calculix(self):
        self.assertEqual(len(DATA['same']), 8)
        for found in DATA['same']:
            self.assertLess(found['difference'], 1e-6, found['mesh'])

    def test_quadratic_elements_confirm_the_answers(self):
        self.assertEqual(len(DATA['references']), 7)
        for found in DATA['references']:
            bound = 0.03 if 'crack' in found['name'] else 0.003
            self.assertLess(self.off(found['limit'], found['answer']), bound, found['name'])

    def test_first_frequency_is_that_of_calculix(self):
        self.assertLess(self.off(BAR['at_one_point'], BAR['calculix'][0]), 2e-5)

    def test_lumped_mass_hardly_moves_the_first_frequency(self):
        self.assertLess(self.off(BAR['lumped'], BAR['consistent']), 0.01)

    def test_quadratic_bricks_have_timoshenkos_frequencies(self):
        self.assertEqual(len(BAR['beam']), 2)
        for found, answer in zip(BAR['quadratic'], BAR['beam']):
            self.assertLess(self.off(found, answer), 0.01)

    def test_bricks_of_half_the_edge_hardly_change_the_deflection(self):
        found = DATA['locking']
        for coarse, fine, nu in zip(found['coarse'], found['quadratic'], found['poisson']):
            self.assertLess(self.off(coarse, fine), 0.03, f'ν = {nu}')
