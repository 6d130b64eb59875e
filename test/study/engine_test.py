#!/usr/bin/python3
"""How runs are handed on: in chunks that cost little and end together, with what they need of the environment."""

import os
import pathlib
import subprocess
import unittest
from unittest import mock

from study_case import BATCH, StudyCase
from study import engine
from study.runs import runs_of
from study.study_file import read_study


class Engine(StudyCase):
    def test_chunks_have_all_runs_and_get_smaller(self):
        for count in (1, 2, 3, 39, 40, 1000, 99_999):
            for workers in (1, 2, 64, 10_000):
                sizes = list(engine.guided_sizes(count, workers))
                self.assertEqual(sum(sizes), count)
                self.assertEqual(sizes, sorted(sizes, reverse=True))
                self.assertLessEqual(sizes[0], engine.MAX_CHUNK)
                self.assertEqual(sizes[-1], 1)
        self.assertLess(len(list(engine.guided_sizes(1000, 2))), 100)

    def test_tasks_are_no_more_than_asked_and_alike(self):
        for count in (1, 7, 100, 10_000):
            for tasks in (1, 3, 100, 1000):
                sizes = list(engine.even_sizes(count, tasks))
                self.assertEqual(sum(sizes), count)
                self.assertEqual(len(sizes), min(tasks, count))
                self.assertLessEqual(max(sizes) - min(sizes), 1)

    def test_a_chunk_runs_where_the_environment_is_bare(self):
        """As over ssh; what the libraries and packages need is written down."""
        study = read_study(self.write('scene: scene.yaml\nsteps: 1\n'))
        runs = runs_of(study)
        (self.out / 'runs').mkdir(parents=True)
        batch = self.fake_batch('[ "$LD_LIBRARY_PATH" = "/a b" ] && unset LD_LIBRARY_PATH && exec "$REAL" "$@"')
        with mock.patch.dict(os.environ, {'LD_LIBRARY_PATH': '/a b'}):
            chunk, = engine.write_chunks(self.out, study, runs, batch, [1])
        for _ in range(2):  # what is done already is passed over
            subprocess.run(['/bin/sh', self.out / 'run_chunk', chunk], check=True, env={'PATH': '/usr/bin:/bin'}, cwd='/')
            self.assertEqual(list(self.lines('*.json')), [runs[0].name])
            batch.write_text('#!/bin/sh\nexit 9\n')
        self.assertEqual(sorted(path.name for path in (self.out / 'runs').iterdir()), [runs[0].name + '.json'])

    def test_each_start_has_lists_of_its_own(self):
        """An array job that still waits keeps those that it was submitted with."""
        study = read_study(self.write('scene: scene.yaml\nrepetitions: 5\n'))
        (self.out / 'runs').mkdir(parents=True)
        first = engine.write_chunks(self.out, study, runs_of(study), BATCH, [2, 3])
        second = engine.write_chunks(self.out, study, runs_of(study), BATCH, [5])
        self.assertEqual((first, second), (['lists/1/1', 'lists/1/2'], ['lists/2/1']))
        self.assertEqual([(self.out / chunk).read_text().count('\n') for chunk in first + second], [2, 3, 5])
        script = pathlib.Path(engine.write_slurm(self.out, study, first, 7)).read_text()
        self.assertIn('#SBATCH --array=1-2%7\n', script)
        subprocess.run(['sh', '-n'], input=script, text=True, check=True)


if __name__ == '__main__':
    unittest.main()
