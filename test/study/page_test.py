#!/usr/bin/python3
"""The page on studies keeps to the program: its command lines run, its tables have every key and option."""

import csv
import os
import pathlib
import re
import shlex
import subprocess
import sys
import unittest

from fit_case import FitCase, FIT
from study_case import BATCH, PROGRAM, SOURCE
from study import study_file, values
from study.runs import runs_of
from study.table import LEFT_OUT

sys.path.insert(0, str(SOURCE / 'test/pages'))
import pages  # noqa: E402

PAGE = 'launch/study/README.md'
TEXT = (SOURCE / PAGE).read_text(encoding='utf-8')


def column(heading, cell=0):
    """The words in code in one column of a table."""
    return [word for row in pages.table(TEXT, heading) for word in re.findall(r'`([^`]*)`', row[cell])]


class Page(FitCase):
    def setUp(self):
        super().setUp()
        self.commands = [block.text for block in pages.command_lines(PAGE, TEXT)]
        self.example, = [block.text for block in pages.blocks(PAGE, TEXT) if block.language == 'yaml']

    def shell(self, lines):
        """Runs command lines of the page with this build's programs and this source's files."""
        programs = self.folder.parent / 'programs'
        programs.mkdir(exist_ok=True)
        for name, path in (('incision_study', PROGRAM), ('incision_fit', FIT), ('incision_batch', BATCH)):
            if not (programs / name).exists():
                (programs / name).write_text(f'#!/bin/sh\nexec {shlex.quote(str(path))} "$@"\n')
                (programs / name).chmod(0o755)
        for name, body in (('rosrun', 'shift; exec "$@"'), ('rospack', f'echo {SOURCE}'), ('sbatch', 'test -f "$2"')):
            (programs / name).write_text(f'#!/bin/sh\n{body}\n')
            (programs / name).chmod(0o755)
        environment = {**os.environ, 'PATH': f'{programs}:{os.environ["PATH"]}'}
        done = subprocess.run(['sh', '-e', '-c', lines], cwd=self.folder, env=environment, check=False, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.assertEqual(done.returncode, 0, done.stdout)
        return done.stdout

    def test_its_command_lines_run(self):
        run, plot, slurm, fit, gather = self.commands
        self.assertIn('100 of 100 runs are done', self.shell(run))
        with open(self.folder / 'bar_study/study.csv', newline='', encoding='utf-8') as file:
            row = next(csv.DictReader(file))
        for name in ('run', 'repetition', 'status', 'reason', 'version', 'state_hash', 'cuts.pending', 'step_ms.median',
                     'momentum.2', 'body.material.poisson_ratio'):
            self.assertIn(name, row)
        self.assertFalse(set(LEFT_OUT) & set(row))
        self.assertTrue(pathlib.Path(self.shell(plot).splitlines()[0]).is_file())
        self.write(self.example)
        said = self.shell(slurm)
        self.assertIn('12 runs in 12 tasks: sbatch ', said)
        self.assertIn('--array=1-12%50\n', (self.folder / 'study/study.sbatch').read_text())
        self.assertIn('12 are still to be run', self.shell(gather + ' || [ $? = 1 ]'))
        x, force = self.measure()
        self.write_curve(x, force)
        said = self.shell(fit)
        self.assertEqual(set(column('| fit key |')), set(re.findall(r'"(\w+)":', said)))
        self.assertTrue((self.folder / 'fit.png').is_file())

    def test_its_study_is_as_many_runs_as_it_says(self):
        study = study_file.read_study(self.write(self.example))
        self.assertIn(f'These are {len(runs_of(study))} runs.', TEXT)

    def test_its_tables_have_every_key_and_option(self):
        self.assertEqual(tuple(column('| study key |')), study_file.KEYS)
        forms = ' '.join(column('| what `vary` takes |'))
        self.assertEqual(re.findall(r'\{(\w+):', forms), [*values.RANGES, *values.DRAWS])
        options = set(re.findall(r'--[a-z-]+', self.study('--help')[0]))
        self.assertEqual({option.split()[0] for option in column('| option |')}, options)


if __name__ == '__main__':
    unittest.main()
