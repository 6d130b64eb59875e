#!/usr/bin/python3
"""A study as an array job of Slurm: cancelled in the middle and submitted again, it does each run once."""

import pathlib
import re
import tempfile
import unittest

from slurm_cluster import SlurmCluster, is_there
from study_case import StudyCase

STUDY = '''
scene: scene.yaml
steps: 3
vary: {body.material.young_modulus: {log_range: [1e4, 1e6], count: 60}}
'''


@unittest.skipUnless(is_there(), 'needs Slurm, munge and root')
class Slurm(StudyCase):
    def test_a_study_that_is_cancelled_in_the_middle_goes_on(self):
        files = self.enterContext(tempfile.TemporaryDirectory())
        with SlurmCluster(files) as cluster:
            study = self.write(STUDY)
            batch = self.fake_batch('sleep 0.1\nexec "$REAL" "$@"')
            job = self.submit(cluster, study, '--tasks', '12', '--jobs', '2', batch=batch, says='60 runs in 12 tasks')
            cluster.wait_until(lambda: self.ended() >= 10)
            self.assertLessEqual(sum('RUNNING' in line for line in cluster.jobs()), 2)
            cluster.run('scancel', job)
            cluster.wait_until(lambda: not cluster.jobs())
            done = {path: path.stat().st_mtime_ns for path in (self.out / 'runs').glob('*.json')}
            self.assertTrue(10 <= len(done) < 60, len(done))
            self.assertEqual(list((self.out / 'runs').glob('*.failed')), [])
            self.assertIn(f'{60 - len(done)} are still to be run', self.study(study, '--collect', status=1)[1])

            self.submit(cluster, study, says=f'{60 - len(done)} runs in {60 - len(done)} tasks')
            cluster.wait_until(lambda: not cluster.jobs())
            self.study(study, '--collect')
            self.assertEqual(len(self.table()), 60)
            for path, changed in done.items():
                self.assertEqual(path.stat().st_mtime_ns, changed)
        self.assertTrue(all(daemon.returncode is not None for daemon in cluster.daemons))

    def ended(self):
        return len(list((self.out / 'runs').glob('*.json')))

    def submit(self, cluster, study, *options, says, **batch):
        said = self.study(study, '--slurm', *options, **batch)[1]
        self.assertIn(says, said)
        script = pathlib.Path(self.out / 'study.sbatch')
        return re.search(r'\d+', cluster.run('sbatch', script)).group()


if __name__ == '__main__':
    unittest.main()
