"""A folder of its own for each test, with a scene that takes next to no time, and the program on it."""

import contextlib
import csv
import io
import json
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(SOURCE / 'launch'))
from study.program import main  # noqa: E402

PROGRAM = SOURCE / 'launch/study/incision_study'
BATCH = pathlib.Path(os.environ.get('INCISION_BATCH', SOURCE / 'build/devel/lib/incision/incision_batch')).absolute()

SCENE = '''
body: {grid: {cells: [2, 1, 1], size: [1, 0.25, 0.25]}}
boundary: [{box: [[-1, -1, -1], [1.0e-6, 1, 1]]}]
solver: {method: direct}
gravity: [0, 0, -9.81]
cuts: [{time: 0, label: first, point: [0.7, 0, 0], normal: [1, 0, 0]}]
'''


class StudyCase(unittest.TestCase):
    def setUp(self):
        # A name that shells and GNU parallel could take for more than a name.
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory())) / 'it\'s "a" $(study) & more; {}'
        self.folder.mkdir()
        (self.folder / 'scene.yaml').write_text(SCENE)
        self.out = self.folder / 'out'

    def write(self, text, name='study.yaml'):
        path = self.folder / name
        path.write_text(text)
        return path

    def command(self, study, *options, batch=BATCH):
        return [str(word) for word in (PROGRAM, study, '--out', self.out, '--batch', batch, *options)]

    def study(self, study, *options, status=0, batch=BATCH):
        """Runs the program. Returns what it says on standard output and on standard error."""
        done = subprocess.run(self.command(study, *options, batch=batch), cwd=self.folder, check=False, text=True,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        self.assertNotIn('Traceback', done.stderr)
        return done.stdout, done.stderr

    def refused(self, text, *parts, study='study.yaml'):
        """What is wrong is said in one line that has these parts. The program runs within the test: that is quicker."""
        path = self.write(text, study) if isinstance(text, str) else text
        with contextlib.redirect_stderr(io.StringIO()) as err:
            self.assertEqual(main(self.command(path)[1:]), 2)
        self.assertEqual(err.getvalue().count('\n'), 1, err.getvalue())
        for part in parts:
            self.assertIn(part, err.getvalue())

    def table(self):
        with open(self.out / 'study.csv', newline='', encoding='utf-8') as file:
            return list(csv.DictReader(file))

    def lines(self, name):
        """What the runs have said in the end, by their names."""
        return {path.stem: json.loads(path.read_text()) for path in (self.out / 'runs').glob(name)}

    def fake_batch(self, body):
        """A program in place of incision_batch: a shell script, in which REAL is incision_batch."""
        path = self.folder / 'fake_batch'
        path.write_text(f'#!/bin/sh\nREAL={shlex.quote(str(BATCH))}\n{body}\n')
        path.chmod(0o755)
        return path
