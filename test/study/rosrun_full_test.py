#!/usr/bin/python3
"""Someone new: the installed package, rosrun, the command lines of the page as they stand there, and Ctrl-C in between."""

import csv
import os
import sys
import unittest

from study_case import SOURCE

sys.path.insert(0, str(SOURCE / 'test/pages'))
import pages  # noqa: E402
import session as sessions  # noqa: E402

PAGE = 'launch/study/README.md'
RUN, PLOT, _, FIT, _ = [block.text for block in pages.command_lines(PAGE, pages.pages()[PAGE])]


class Rosrun(sessions.Commands):
    build = os.environ['INCISION_BUILD']

    def test_a_study_of_a_hundred_runs_is_interrupted_and_goes_on(self):
        folder = self.session.folder / 'bar_study'
        first = self.session.terminal(RUN)
        self.session.wait_for(lambda: len(list(folder.glob('runs/*.json'))) >= 5, 'some runs')
        self.assertEqual(130, self.session.interrupt(first))
        self.assertIn('are still to be run', self.session.said(first))
        self.assertIn('100 of 100 runs are done', self.session.run(RUN))
        self.session.run(PLOT)
        self.assertTrue(list(folder.glob('*.png')))

    def test_a_stiffness_is_fitted(self):
        study, fit = FIT.splitlines()
        self.session.run(study)
        folder = self.session.folder / 'press_study'
        with open(folder / 'study.csv', newline='', encoding='utf-8') as file:
            row = list(csv.DictReader(file))[3]
        with open(folder / row['record'], newline='', encoding='utf-8') as file:
            curve = [(step['time'], 1.05 * float(step['clamp_1_force_x'])) for step in csv.DictReader(file)]
        (self.session.folder / 'measured.csv').write_text(
            'time,clamp_1_force_x\n' + ''.join(f'{time},{force}\n' for time, force in curve), encoding='utf-8')
        said = sessions.last_json(self.session.run(fit))
        self.assertAlmostEqual(1.05, said['value'] / float(row['body.material.young_modulus']), delta=0.03)


if __name__ == '__main__':
    unittest.main()
