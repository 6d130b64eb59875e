import unittest

from measured import measured
from tool.figures import largest_step, off_rest, resolution, steady

DATA = measured('tool')


class Tool(unittest.TestCase):
    def setUp(self):
        self.meshes = [(of['cells'], of, steady(DATA, of['with']), steady(DATA, of['without'])) for of in DATA['force']]
        self.assertEqual(len(self.meshes), 2)
        self.assertEqual(len(DATA['opening']), 2)

    def test_mean_force_is_cutting_force_times_thickness(self):
        for cells, _, steadily, _ in self.meshes:
            wanted = DATA['cutting_force'] * DATA['block'][2]
            self.assertLess(abs(steadily['mean'] / wanted - 1), resolution(DATA, cells))

    def test_work_by_area_is_the_cutting_force(self):
        for cells, _, steadily, _ in self.meshes:
            self.assertLess(abs(steadily['work'] / DATA['cutting_force'] - 1), resolution(DATA, cells))

    def test_no_force_before_the_blade_is_at_the_face(self):
        for _, of, steadily, _ in self.meshes:
            before = [abs(f) for d, f in zip(of['with']['depth'], of['with']['force']) if d <= 0]
            self.assertLess(max(before), 0.01 * steadily['mean'])

    def test_progressive_force_has_a_quarter_of_the_ripple(self):
        for _, _, progressive, whole in self.meshes:
            self.assertLess(progressive['ripple'], 0.25 * whole['ripple'])

    def test_progressive_force_changes_a_quarter_as_fast(self):
        for _, _, progressive, whole in self.meshes:
            self.assertLess(progressive['jump'], 0.25 * whole['jump'])

    def test_mean_force_does_not_depend_on_the_mesh(self):
        (cells, _, coarse, _), (_, _, fine, _) = self.meshes
        self.assertLess(abs(coarse['mean'] / fine['mean'] - 1), resolution(DATA, cells))

    def test_opening_at_the_end_of_a_cell_is_that_of_a_cut_at_rest(self):
        for of in DATA['opening']:
            self.assertLess(off_rest(of), 0.02)

    def test_progressive_opening_changes_more_slowly(self):
        for of in DATA['opening']:
            self.assertLess(largest_step(of['with']['opening']), 0.85 * largest_step(of['without']['opening']))
