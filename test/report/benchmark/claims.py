import unittest

from benchmark.figures import errors, order, series, ways
from measured import measured

DATA = measured('benchmark')

# Largest |error| on a grid of so many cells a side, as measured and a fifth more: of the cracks as they are cut, by the
# front where it acts, and cut longer.
CELLS = 27
BOUNDS = {('penny', 'K_I'): (0.48, 0.13, 0.032), ('penny', 'G'): (0.25, None, 0.033),
          ('inclined penny', 'K_I'): (0.44, 0.12, 0.021), ('inclined penny', 'K_II'): (0.53, 0.23, 0.13),
          ('inclined penny', 'K_III'): (0.55, 0.25, 0.096), ('inclined penny', 'G'): (0.26, None, 0.061),
          ('lens', 'K_I'): (0.46, 0.072, 0.073), ('lens', 'K_II'): (0.66, 0.46, 0.018)}
WAYS = ('incision', 'incision, front where it acts', 'incision, cut longer')


def at_cells(curve):
    return next(point for point in curve['points'] if point['cells'] == CELLS)


class Benchmark(unittest.TestCase):
    def test_zones_move_by_themselves(self):
        self.assertEqual(len(DATA['exact']), 9)
        for found in DATA['exact']:
            self.assertEqual(found['pieces'], found['zones'], found['problem'])
            self.assertLess(found['roundings'], 2, found['problem'])  # which kinds of arithmetic do not share

    def test_round_cracks_are_as_near_the_published_answers_as_measured(self):
        seen = set()
        for problem, quantity, way, curve, key in series(DATA):
            if way not in WAYS:
                continue
            seen.add((problem['name'], quantity))
            bound = BOUNDS[problem['name'], quantity][WAYS.index(way)]
            self.assertLess(abs(at_cells(curve)[quantity][key]), bound, f'{problem["name"]} {quantity}, {way}')
        self.assertEqual(seen, set(BOUNDS))

    def test_pennies_converge_as_they_are_cut(self):
        for problem, quantity, way, curve, key in series(DATA):
            if way == 'incision' and problem['flat']:
                self.assertGreater(order(curve, quantity, key), 0.6, f'{problem["name"]} {quantity}')

    def test_cracks_act_as_if_shorter_by_most_of_an_edge(self):
        for problem in DATA['problems']:
            missing = at_cells(problem['curves'][0])['missing_edges']
            self.assertTrue(0.6 < missing < 1, f'{problem["name"]}: {missing}')

    def test_what_should_be_zero_is_small(self):
        penny, _, lens = (at_cells(problem['curves'][0]) for problem in DATA['problems'])
        self.assertLess(penny['K_II']['worst'], 0.12)
        self.assertLess(penny['K_III']['worst'], 0.04)
        self.assertLess(lens['K_III']['worst'], 0.024)

    def test_fit_finds_k_of_the_exact_opening(self):
        self.assertLess(abs(DATA['fit'][0]), 0.0076)
        self.assertLess(abs(DATA['fit'][1]), 0.019)

    def test_getfem_has_the_same_grid(self):
        for problem in DATA['problems'][:2]:
            edges = [{p['cells']: p['edge'] for p in curve['points']} for _, curve, _ in ways(problem)]
            shared = set.intersection(*(set(of) for of in edges))
            self.assertTrue(shared, problem['name'])
            for cells in shared:
                for of in edges:
                    self.assertAlmostEqual(of[cells], edges[0][cells], places=9)

    def test_singular_functions_bring_getfem_nearer_than_the_jump_alone(self):
        for problem in DATA['problems'][:2]:
            found = {way: abs(errors(curve, 'K_I', key)[-1]) for way, curve, key in ways(problem)}
            self.assertLess(found['GetFEM, singular functions'], 0.5 * found['GetFEM, jump alone'])
