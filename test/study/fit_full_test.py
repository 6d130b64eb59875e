#!/usr/bin/python3
"""The fit is as sure as it says: of many noisy measurements, 95 of 100 intervals hold the true Young's modulus."""

import unittest

import numpy
from fit_case import COLUMNS, KEY, NOISE, PRESS, TRUE, FitCase, load

TRIALS = 400


class FitCoverage(FitCase):
    def test_intervals_hold_the_truth_as_often_as_they_say(self):
        x, force = self.measure()
        self.study(PRESS)
        module = load()
        curves = module.read_study(self.out / 'study.csv', KEY, COLUMNS)
        random = numpy.random.default_rng(2)
        held, errors = 0, []
        for _ in range(TRIALS):
            result, _ = module.fit(curves, x, force + random.normal(0, NOISE, len(x)))
            held += result['low'] < TRUE < result['high']
            errors.append((result['value'] - TRUE) / result['standard_error'])
        # Four standard deviations of a share of 0.95 among 400 are 0.044.
        self.assertTrue(0.906 < held / TRIALS < 0.994, held)
        self.assertAlmostEqual(numpy.std(errors), 1, delta=4 / numpy.sqrt(2 * TRIALS))


if __name__ == '__main__':
    unittest.main()
