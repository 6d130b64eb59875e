import unittest

from measured import measured
from tool.figures import (CUCUMBER_FIRST, CUCUMBER_PLATEAU, CUCUMBER_TO, POTATO_LAST, POTATO_PLATEAU, TOLERANCE,
                          cucumber_plateau, entering, force_at, largest_step, off_rest, potato_plateau, resolution,
                          spread, steady)

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


class Knife(unittest.TestCase):
    def setUp(self):
        self.potato, self.cucumber = DATA['published']['potato'], DATA['published']['cucumber']

    def test_a_prism_of_potato_takes_the_published_force_all_the_way_at_each_speed(self):
        for run in self.potato['runs']:
            least, _, most = potato_plateau(run)
            self.assertGreater(least, POTATO_PLATEAU - TOLERANCE)
            self.assertLess(most, POTATO_PLATEAU + TOLERANCE)

    def test_the_prism_misses_the_last_printed_forces_by_less_than_a_seventh(self):
        self.assertLess(abs(force_at(self.potato['runs'][0], 1.1) / POTATO_LAST - 1), 1 / 7)

    def test_a_cylinder_of_cucumber_starts_as_was_fitted(self):
        time, force = CUCUMBER_FIRST
        self.assertLess(abs(force_at(self.cucumber['runs'][0], time) / force - 1), 0.05)

    def test_the_cylinder_then_stays_within_the_published_force(self):
        least, mean, most = cucumber_plateau(self.cucumber['runs'][0])
        self.assertGreater(least, CUCUMBER_PLATEAU - TOLERANCE)
        self.assertLess(most, CUCUMBER_PLATEAU + TOLERANCE)
        self.assertLess(abs(mean - CUCUMBER_PLATEAU), 0.5 * TOLERANCE)

    def test_a_cylinder_of_fifty_millimetres_would_not(self):
        time, force = CUCUMBER_FIRST
        self.assertGreater(force_at(self.cucumber['large_run'], time), force + TOLERANCE)
        self.assertLess(force_at(self.cucumber['large_run'], CUCUMBER_TO), CUCUMBER_PLATEAU - TOLERANCE)

    def test_the_force_at_a_depth_does_not_depend_on_the_speed(self):
        for body in (self.potato, self.cucumber):
            self.assertLess(spread(body['runs']), 0.02)


class Soft(unittest.TestCase):
    def setUp(self):
        self.materials = DATA['published']['soft']
        self.assertEqual([of['name'] for of in self.materials], ['gelatin', 'elastomer'])

    def test_the_edge_enters_where_it_was_seen_to_at_ten_times_the_speed_and_on_a_finer_mesh(self):
        for of in self.materials:
            for run in ('fitted', 'faster', 'finer'):
                depth = entering(of[run])['depth']
                self.assertGreater(depth, of['before'])
                self.assertLess(depth, of['after'])

    def test_until_then_nothing_is_cut(self):
        for of in self.materials:
            for run in ('fitted', 'faster', 'finer', 'finest'):
                self.assertEqual(entering(of[run])['area_before'], 0)

    def test_the_indentation_is_nearly_linear(self):
        for of in self.materials:
            self.assertLess(abs(entering(of['fitted'])['half'] - 0.5), 0.05)

    def test_to_the_end_of_the_travel_the_force_is_steady(self):
        for of in self.materials:
            for run in ('fitted', 'faster', 'finer'):
                self.assertLess(entering(of[run])['ripple'], 0.03)

    def test_the_force_falls_to_the_cutting_force(self):
        thickness = DATA['published']['block'][1]
        for of in self.materials:
            wanted = of['steady'] * of['reached'] * of['young_modulus'] * thickness
            found = entering(of['fitted'])
            self.assertLess(abs(found['steady'] / wanted - 1), 0.05)
            self.assertLess(found['steady'], found['first'])

    def test_a_finer_mesh_gives_way_farther(self):
        for of in self.materials:
            depths = [entering(of[run])['depth'] for run in ('fitted', 'finer', 'finest')]
            self.assertEqual(depths, sorted(depths))
            self.assertLess(depths[2], 2 * depths[0])
