#!/usr/bin/python3
"""The study file is read strictly: what is wrong is told in a line that names the file, the key and what is allowed."""

import unittest

from study_case import StudyCase

BEGIN = 'scene: scene.yaml\n'


class StudyFile(StudyCase):
    def test_unknown_keys_are_told_with_a_guess(self):
        self.refused(BEGIN + 'step: 3', 'study.yaml: step: unknown key (did you mean steps?) (allowed: scene, steps,')
        self.refused(BEGIN + 'vary: {a.b: {rnge: [1, 2], count: 3}}',
                     'vary.a.b.rnge: unknown key (did you mean range?)')

    def test_what_is_no_study(self):
        for text in ('', '[1, 2]', '3', 'scene'):
            self.refused(text, 'study.yaml: no study')
        self.refused('a: [', 'study.yaml: line ')
        self.refused('[' * 3000, 'study.yaml: ')
        self.refused(BEGIN + 'steps: 1\nsteps: 2', 'study.yaml: line 3: steps: the key stands twice')
        self.refused('steps: 1', 'scene: is missing')
        self.refused(self.folder / 'none.yaml', 'none.yaml: cannot be read: No such file')
        self.refused(self.folder, 'cannot be read: Is a directory')
        (self.folder / 'bytes.yaml').write_bytes(b'scene: \xff\xfe')
        self.refused(self.folder / 'bytes.yaml', 'bytes.yaml: cannot be read: ')

    def test_scenes_that_are_not_there(self):
        self.refused('scene: none.yaml', 'scene: ', 'none.yaml is no file')
        self.refused('scene: 3', 'scene: 3 (allowed: the path of a scene)')
        self.refused('scene: package://other/a.yaml', 'allowed: a path, or package://incision/PATH')

    def test_numbers_beyond_their_ranges(self):
        for key, value in (('steps', -1), ('steps', 1.5), ('steps', '.nan'), ('steps', 'true'), ('steps', 'many'),
                           ('steps', 10_000_001), ('threads', 0), ('threads', 65), ('repetitions', 0),
                           ('repetitions', 1e9), ('time_limit', -1), ('time_limit', '.inf'), ('time_limit', '[1]')):
            self.refused(f'{BEGIN}{key}: {value}', f'study.yaml: {key}: ', '(allowed: ')
        self.refused(BEGIN + 'record: 1', 'record: 1 (allowed: true or false)')

    def test_what_varies(self):
        for text, part in (('3', 'what does not vary goes under set'), ('[]', 'at least one value'),
                           ('{}', 'has no kind'), ('{range: [1, 2], uniform: [1, 2]}', 'range and uniform'),
                           ('{range: [1, 2]}', 'count: None'), ('{range: [1, 2], count: 0}', 'count: 0'),
                           ('{range: [1, 2], count: 1.5}', 'count: 1.5'),
                           ('{range: [1], count: 2}', 'two finite numbers'),
                           ('{range: [.nan, 1], count: 2}', 'two finite numbers'),
                           ('{range: [1, .inf], count: 2}', 'two finite numbers'),
                           ('{range: 3, count: 2}', 'two finite numbers'),
                           ('{log_range: [0, 1], count: 2}', 'numbers above 0'),
                           ('{log_uniform: [-1, 1]}', 'numbers above 0'),
                           ('{normal: [0, -1]}', 'deviation of 0 or more'),
                           ('{uniform: [0, 1], seed: -1}', 'seed: -1'),
                           ('{uniform: [0, 1], count: 3}', 'count: unknown key'),
                           ('{range: [0, 1], count: 3, seed: 1}', 'seed: unknown key')):
            self.refused(f'{BEGIN}vary: {{gravity: {text}}}', 'study.yaml: vary.gravity', part)
        self.refused(BEGIN + 'vary: [a]', 'vary: ')
        self.refused(BEGIN + 'set: {1: 2}', 'set: ')
        self.refused(BEGIN + 'set: {gravity: [0, 0, 0]}\nvary: {gravity: [[0, 0, 1]]}', 'stands under set too')
        self.refused(BEGIN + 'set: {solver.threads: 2}', 'say threads at the top level')
        self.refused(BEGIN + 'set: {"a=b": 2}', 'no scene key')

    def test_more_runs_than_anyone_waits_for(self):
        wide = '{range: [0, 1], count: 10000}'
        self.refused(f'{BEGIN}vary: {{gravity.0: {wide}, gravity.1: {wide}}}', '100000000 runs (allowed: 100000)')
        self.refused(f'{BEGIN}vary: {{gravity.0: {wide}}}\nrepetitions: 1000', '10000000 runs')

    def test_what_the_scene_refuses_is_told_before_the_first_run(self):
        self.refused(BEGIN + 'set: {solver.time_stepp: 1}', 'study.yaml: set.solver.time_stepp: ', 'unknown key')
        self.refused(BEGIN + 'vary: {solver.time_step: [.nan, 0.1]}', 'study.yaml: vary.solver.time_step: ')
        self.assertEqual(list((self.out / 'runs').iterdir()), [])

    def test_options(self):
        study = self.write(BEGIN + 'steps: 1')
        for options in (('--jobs', '0'), ('--jobs', 'x'), ('--tasks', '1001'), ('--list', '--collect'), ('--plt',)):
            self.study(study, *options, status=2)
        self.study(study, batch=self.folder / 'none', status=2)
        self.assertFalse(self.out.exists())
        self.out.mkdir()
        (self.out / 'thesis.tex').write_text('')
        self.assertIn('holds something else', self.study(study, status=2)[1])
        self.out = self.folder / 'scene.yaml'
        self.assertIn('cannot be used', self.study(study, status=2)[1])


if __name__ == '__main__':
    unittest.main()
