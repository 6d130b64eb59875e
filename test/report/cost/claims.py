import re
import unittest

from measured import measured

CASES = measured('cost')['cases']
HAS_ROS = 'markers' in CASES

# Instructions in a step that a feature may take which the scene has and which has nothing to do, as a share of all.
IDLE_SHARE = 0.3

ROTATIONS, FACTORISATIONS, MASS_PRODUCTS, MESSAGES = 'polarRotation', '::factorise', 'multiplyMass', '::toMarkers'

TOUCHING = tuple((feature, state) for feature in ('contact', 'self-contact') for state in ('idle', 'working'))
DRAWN = ('markers', 'working')  # the first message asks the mesh for its surface

# Of each of these: what the names of its functions have in them, and the scenes, by feature and state, that run it.
USERS = {
    'cutting': (('CutMesh::', 'Polytope'), (('cracks', 'working'), ('fracture', 'working'), ('tool', 'working'), DRAWN)),
    'surface': (('::interpolate', *(('[sS]urface',) if HAS_ROS else ())), (*TOUCHING, DRAWN)),
    'fracture': (('CrackGrowth', 'SmoothedStress', 'Cohesion'), (('fracture', 'idle'), ('fracture', 'working'))),
    'contact': (('::Contact', 'Fragment'), TOUCHING),
    'tool': (('CuttingEdge', 'Stroke', 'Ties'), (('tool', 'idle'), ('tool', 'working'))),
}


def name_of(function):
    """Without arguments and what it returns; of a template, with the names it is made for."""
    return function.replace('(anonymous namespace)::', '').split('(')[0]


def inside(case, word):
    """Instructions a step in the functions with such names."""
    return sum(count for function, count in case['functions'].items() if re.search(word, name_of(function)))


class Cost(unittest.TestCase):
    def only(self, word, without, having):
        """Functions run in the one case and not in the other."""
        self.assertEqual(inside(CASES[without], word), 0)
        self.assertGreater(inside(CASES[having], word), 0)

    def test_absent_features_run_nothing(self):
        for feature, (words, users) in USERS.items():
            for case in CASES.values():
                with self.subTest(f"{feature}, where there is {case['feature']}: {case['text']}"):
                    instructions = sum(inside(case, word) for word in words)
                    if (case['feature'], case['state']) in users:
                        self.assertGreater(instructions, 0)
                    else:
                        self.assertEqual(instructions, 0)

    def test_names_of_features_are_those_of_functions_that_run(self):
        for words, users in USERS.values():
            using = [case for case in CASES.values() if (case['feature'], case['state']) in users]
            for word in words:
                self.assertGreater(max(inside(case, word) for case in using), 0, word)

    def test_linear_steps_extract_no_rotations(self):
        self.only(ROTATIONS, 'linear', 'warped')

    def test_linear_steps_factorise_nothing(self):
        self.only(FACTORISATIONS, 'linear', 'warped')

    def test_lumped_mass_multiplies_by_no_matrix(self):
        self.only(MASS_PRODUCTS, 'plain', 'consistent')

    def test_idle_features_allocate_nothing(self):
        quiet = [case for case in CASES.values() if case['state'] != 'working' and case['feature'] != 'markers']
        self.assertGreaterEqual(len(quiet), 10)
        for case in quiet:
            self.assertEqual(case['allocations'], 0, case['text'])

    def test_cuts_that_wait_cost_nothing(self):
        self.assertLess(abs(CASES['cut waits']['instructions'] - CASES['plain']['instructions']), 1000)

    def test_fracture_uses_the_rotations_of_the_step(self):
        self.assertGreater(inside(CASES['plain'], ROTATIONS), 0)
        self.assertEqual(inside(CASES['fracture waits'], ROTATIONS), inside(CASES['plain'], ROTATIONS))

    def test_idle_features_cost_little(self):
        for key in ('fracture waits', 'ground below', 'one piece', 'tool still', 'tool away'):
            self.assertLess(CASES[key]['instructions'], (1 + IDLE_SHARE) * CASES['plain']['instructions'], key)

    @unittest.skipUnless(HAS_ROS, 'the node is not built')
    def test_markers_without_a_subscriber_cost_nothing(self):
        self.only(MESSAGES, 'no markers', 'markers')
        self.only(MESSAGES, 'nobody listens', 'markers')
        self.assertLess(CASES['nobody listens']['instructions'], CASES['no markers']['instructions'] + 10000)
