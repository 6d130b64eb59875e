#!/usr/bin/python3
"""What a study's keys take: ranges end where they say, draws follow their laws, and each value reaches the
scene whole."""

import json
import math
import shlex
import statistics
import subprocess
import unittest

import yaml
from study_case import BATCH, StudyCase
from study.study_file import read_study
from study.runs import runs_of
from study.values import as_yaml, parse_variation


class Values(StudyCase):
    def runs(self, text):
        return runs_of(read_study(self.write('scene: scene.yaml\n' + text)))

    def test_ranges_begin_and_end_where_they_say(self):
        for first, last, count in ((0.1, 0.7, 7), (5, -5, 3), (2, 2, 2), (0.3, 9, 1), (1e-3, 1e7, 50)):
            values = parse_variation('a', {'range': [first, last], 'count': count}, 'a').values
            self.assertEqual(len(values), count)
            self.assertEqual(values[0], first)
            self.assertEqual(values[-1], last if count > 1 else first)
            steps = [b - a for a, b in zip(values, values[1:])]
            self.assertTrue(all(math.isclose(step, steps[0], rel_tol=1e-9) for step in steps))
        values = parse_variation('a', {'log_range': ['1e4', 1e6], 'count': 5}, 'a').values
        self.assertEqual((values[0], values[-1], len(values)), (1e4, 1e6, 5))
        self.assertTrue(all(math.isclose(b / a, 10 ** 0.5) for a, b in zip(values, values[1:])))

    def test_draws_follow_their_laws(self):
        def drawn(form):
            draw = parse_variation('a', form, 'a').draw
            return [draw(i) for i in range(4000)]
        uniform = drawn({'uniform': [2, 4]})
        self.assertTrue(2 <= min(uniform) < 2.01 and 3.99 < max(uniform) <= 4)
        self.assertAlmostEqual(statistics.mean(uniform), 3, delta=4 * 0.577 / math.sqrt(4000))
        logs = [math.log10(v) for v in drawn({'log_uniform': [1, 100]})]
        self.assertAlmostEqual(statistics.mean(logs), 1, delta=4 * 0.577 / math.sqrt(4000))
        normal = drawn({'normal': [10, 3]})
        self.assertAlmostEqual(statistics.mean(normal), 10, delta=4 * 3 / math.sqrt(4000))
        self.assertAlmostEqual(statistics.stdev(normal), 3, delta=0.15)

    def test_draws_depend_on_the_key_the_seed_and_the_repetition_alone(self):
        def drawn(key='body.material.density', seed=0, more=''):
            form = f'{more}repetitions: 3\nvary: {{{key}: {{uniform: [1, 2], seed: {seed}}}'
            return [run.values[key] for run in self.runs(form + ('}' if not more else '}'))]
        self.assertEqual(drawn(), drawn())
        self.assertEqual(drawn(), drawn(more='steps: 7\n'))
        self.assertEqual(len({*drawn(), *drawn('body.material.mass_damping'), *drawn(seed=1)}), 9)

    def test_runs_are_all_combinations_each_once(self):
        runs = self.runs('repetitions: 2\nvary: {gravity: [[0, 0, 0], [0, 0, 1]], solver.time_step: [0.1, 0.2, 0.1]}')
        self.assertEqual(len(runs), 8)
        self.assertEqual(len({run.name for run in runs}), 8)
        self.assertEqual(len(self.runs('steps: 3')), 1)

    def test_names_tell_studies_apart_and_outlast_their_growth(self):
        def names(text):
            return [run.name for run in self.runs(text)]
        small = names('vary: {solver.time_step: [0.1, 0.2]}')
        self.assertEqual(names('vary: {solver.time_step: [0.3, 0.2, 0.1]}')[1:], small[::-1])
        self.assertFalse(set(small) & set(names('steps: 7\nvary: {solver.time_step: [0.1, 0.2]}')))
        (self.folder / 'scene.yaml').write_text('body: {}')
        self.assertFalse(set(small) & set(names('vary: {solver.time_step: [0.1, 0.2]}')))

    def test_values_are_read_back_as_they_were(self):
        for value in (1, -3, 0.1, 1e-300, 1e22, math.inf, -math.inf, True, False, None, '1e6', 'true', 'no', 'a b',
                      "it's", 'x: y', '[1', '', '~', '# c', 'direct', 'package://incision/a.msh', 'ünïcode', 'line\nbreak',
                      '-',
                      [0, 0, -9.81], [[1, 2], [3, 4]], {'box': [[0, 0, 0], [1, 1, 1]], 'frame': 'a b'}, [], {}):
            self.assertEqual(yaml.safe_load(as_yaml(value)), value)
            self.assertNotIn('\n', as_yaml(value))

    def test_lists_and_maps_reach_the_scene(self):
        study = self.write('''
scene: scene.yaml
steps: 1
vary:
  cuts.0.point: [[0.3, 0, 0], [9, 0, 0]]
  cuts.0.label: ["it's; $(rm -rf /) \\"here\\"", 'a  b']
  gravity: [[0, 0, -9.81]]
''')
        self.study(study)
        cuts = {(line['cuts'][0]['label'], line['cuts'][0]['status']) for line in self.lines('*.json').values()}
        self.assertEqual(cuts, {(label, status) for label in ('it\'s; $(rm -rf /) "here"', 'a  b')
                                for status in ('applied', 'missed')})
        self.assertEqual({row['cuts.0.point'] for row in self.table()}, {'[0.3,0,0]', '[9,0,0]'})
        self.assertEqual(sorted(row['cuts.missed'] for row in self.table()), ['0', '0', '1', '1'])

    def test_each_line_of_the_list_is_a_command_that_does_that_run(self):
        study = self.write('scene: scene.yaml\nsteps: 2\nvary: {gravity: [[0, 0, -9], [0, 0, 9]]}')
        listed = self.study(study, '--list')[0].splitlines()
        self.assertEqual(len(listed), 2)
        said = [subprocess.run(line, shell=True, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
                for line in listed]
        self.assertEqual(len({json.loads(line)['state_hash'] for line in said}), 2)
        self.study(study, '--collect')
        self.assertEqual({row['state_hash'] for row in self.table()}, {json.loads(line)['state_hash'] for line in said})
        self.assertEqual(shlex.split(listed[0])[0], str(BATCH))
        self.assertIn('--threads 1', listed[0])
        self.assertEqual(self.study(study, '--list')[0], '')


if __name__ == '__main__':
    unittest.main()
