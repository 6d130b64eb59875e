import unittest

from measured import measured

DATA = measured('benchmark')


class Benchmark(unittest.TestCase):
    def test_zones_move_by_themselves(self):
        self.assertEqual(len(DATA['exact']), 9)
        for found in DATA['exact']:
            self.assertEqual(found['pieces'], found['zones'], found['problem'])
            self.assertLess(found['roundings'], 4, found['problem'])
