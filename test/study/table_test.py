#!/usr/bin/python3
"""The table has a row for each run that has come to an end, with what varied and what it said; pictures take any
columns."""

import unittest

from study_case import StudyCase
from study.table import flat

STUDY = '''
scene: scene.yaml
steps: 2
record: true
repetitions: 2
vary:
  cuts.0.point: [[0.3, 0, 0], [9, 0, 0]]
  body.material.young_modulus: {log_uniform: [1e4, 1e6]}
'''


class Table(StudyCase):
    def test_rows_are_those_of_the_runs_and_cells_what_they_said(self):
        self.study(self.write(STUDY))
        rows, lines = self.table(), self.lines('*.json')
        self.assertEqual(len(rows), 4)
        self.assertEqual({row['run'] for row in rows}, set(lines))
        for row in rows:
            line = lines[row['run']]
            for column, value in (('steps', line['steps']), ('momentum.2', line['momentum'][2]),
                                  ('step_ms.p99', line['step_ms']['p99']), ('bounds.1.0', line['bounds'][1][0]),
                                  ('regions.body', line['regions']['body'])):
                self.assertEqual(float(row[column]), value)
            self.assertEqual(row['state_hash'], line['state_hash'])
            self.assertEqual(row['version'], line['version'])
            self.assertIn(f'body.material.young_modulus={float(row["body.material.young_modulus"])!r}', line['set'])
            self.assertEqual(row['cuts.missed'], '1' if row['cuts.0.point'] == '[9,0,0]' else '0')
            self.assertEqual(row['cuts.applied'], '0' if row['cuts.0.point'] == '[9,0,0]' else '1')
            self.assertEqual((self.out / row['record']).read_text().count('\n'), 3)
        self.assertEqual([row['repetition'] for row in rows], ['0', '1', '0', '1'])
        self.assertNotIn('interrupted', rows[0])

    def test_long_lists_do_not_widen_the_table(self):
        cells = dict(flat({'a': {'b': list(range(100))}, 'c': None, 'd': [[1, 2]]}))
        self.assertEqual(len(cells), 10)
        self.assertEqual((cells['a.b.7'], cells['d.0.1']), (7, 2))

    def test_any_column_is_drawn_against_any(self):
        study = self.write(STUDY)
        self.assertIn('has no run that is done', self.study(study, '--plot', 'a', 'b', status=2)[1])
        self.study(study)
        for x, y in (('body.material.young_modulus', 'max_displacement'), ('cuts.0.point', 'pieces')):
            path = self.study(study, '--plot', x, y)[0].rstrip('\n')
            self.assertEqual(path, str(self.out / f'{x}_{y}.png'))
            with open(path, 'rb') as file:
                self.assertEqual(file.read(8), b'\x89PNG\r\n\x1a\n')
        self.assertIn('did you mean mass?', self.study(study, '--plot', 'repetition', 'masss', status=2)[1])


if __name__ == '__main__':
    unittest.main()
