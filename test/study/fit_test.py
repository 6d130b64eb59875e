#!/usr/bin/python3
"""The fit finds a known Young's modulus from a noisy force curve of the program itself, and says what it cannot use."""

import json
import subprocess
import unittest

import numpy
from fit_case import COLUMNS, FIT, KEY, NOISE, PRESS, TRUE, FitCase, load


class Fit(FitCase):
    def fit(self, measured, *options):
        done = subprocess.run([FIT, self.out / 'study.csv', measured, *options], check=True, text=True,
                              stdout=subprocess.PIPE)
        return json.loads(done.stdout)

    def test_a_known_modulus_is_found_within_the_stated_interval(self):
        x, force = self.measure()
        self.study(PRESS)
        exact = self.fit(self.write_curve(x, force))
        self.assertAlmostEqual(exact['value'], TRUE, delta=2e-4 * TRUE)  # what the spline leaves between eight values
        noisy = force + numpy.random.default_rng(1).normal(0, NOISE, len(x))
        picture = self.folder / 'fit.png'
        said = self.fit(self.write_curve(x, noisy), '--plot', picture)
        self.assertTrue(said['low'] < TRUE < said['high'], said)
        self.assertAlmostEqual(said['rms'], NOISE, delta=0.35 * NOISE)
        self.assertLess(said['high'] - said['low'], 0.1 * TRUE)
        self.assertTrue(picture.read_bytes().startswith(b'\x89PNG'))
        self.check_mistakes(x, force)

    def check_mistakes(self, x, force):
        module = load()
        study = self.out / 'study.csv'

        def refused(part, function, *arguments):
            with self.assertRaises(module.InputError) as error:
                function(*arguments)
            self.assertIn(part, str(error.exception))
        curves = module.read_study(study, KEY, COLUMNS)
        refused('end of the study\'s range', module.fit, curves, x, 10 * force)
        refused('the measured curve from', module.fit, curves, x + 1, force)
        refused('allowed: 3 or more', module.fit, curves, x[:2], force[:2])
        refused('not finite', module.read_curve, self.write_curve(x, force * numpy.nan))
        refused('no number', module.read_curve, self.write('a,b\n1,x\n', 'measured.csv'))
        refused('has no columns', module.read_curve, self.write('a\n1\n', 'measured.csv'))
        refused('has no columns', module.read_study, study, KEY, ('time', 'no_such'))
        refused('has no runs', module.read_study, study, 'gravity', COLUMNS)
        refused('cannot be read', module.read_curve, self.folder / 'none.csv')


if __name__ == '__main__':
    unittest.main()
