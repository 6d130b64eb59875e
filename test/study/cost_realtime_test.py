#!/usr/bin/python3
"""What hands the runs on costs less than 3 % of a thousand runs of the bar, in processor time. The program in place of
incision_batch does nothing but to leave a result, so that only the handing on is counted."""

import resource
import subprocess
import unittest

from study_case import BATCH, SOURCE, StudyCase

RUNS = 1000
SHARE = 0.03

STUDY = f'''
scene: package://incision/config/scenes/bar.yaml
vary: {{body.material.young_modulus: {{log_range: [1.0e5, 1.0e7], count: {RUNS}}}}}
'''

NOTHING = 'while [ $# -gt 0 ]; do [ "$1" = --summary ] && echo "{}" >"$2"; shift; done'


def processor_time(command, **options):
    """Of the command and all that it starts [s]."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(command, check=True, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   **options)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime


class Cost(StudyCase):
    def test_handing_runs_on_costs_little(self):
        study = self.write(STUDY)
        batch = self.fake_batch(NOTHING)
        lines = self.write(self.study(study, '--list', batch=batch)[0], 'lines.sh')
        plain = processor_time(['sh', lines])
        self.out = self.folder / 'other'
        handed = processor_time(self.command(study, batch=batch))
        self.assertEqual(len(self.table()), RUNS)
        bar = SOURCE / 'config/scenes/bar.yaml'
        run = min(processor_time([BATCH, bar, '--threads', '1']) for _ in range(5))
        share = (handed - plain) / RUNS / run
        print(f'{1000 * (handed - plain) / RUNS:.2f} ms a run of {1000 * run:.0f} ms: {100 * share:.2f} %')
        self.assertLess(share, SHARE)


if __name__ == '__main__':
    unittest.main()
