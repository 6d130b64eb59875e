#!/usr/bin/python3
"""Runs of a study: what is done is not run again, whatever ends the study, and what fails is told and counted."""

import os
import shlex
import shutil
import signal
import subprocess
import time
import unittest

from study_case import BATCH, StudyCase

MANY = '''
scene: scene.yaml
steps: 3
vary: {body.material.young_modulus: {log_range: [1e4, 1e6], count: 20}}
'''
FEW = 'scene: scene.yaml\nsteps: 3\nvary: {gravity.2: [-1, -2, -3, -4]}\n'


class Running(StudyCase):
    def start(self, study, *options, batch=BATCH):
        process = subprocess.Popen(self.command(study, *options, batch=batch), cwd=self.folder, text=True,
                                   stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def wait_until(self, condition):
        deadline = time.monotonic() + 60
        while not condition():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.01)

    def ended(self):
        return len(list((self.out / 'runs').glob('*.json')))

    def stuck_batch(self, count):
        """Once there are so many results, runs go on until they are told to end."""
        runs = shlex.quote(str(self.out / 'runs'))
        return self.fake_batch(f"""
case "$*" in *--steps\\ 0*) exit 0 ;; esac
[ "$(ls {runs} | grep -c 'json$')" -lt {count} ] || exec sleep 1000
exec "$REAL" "$@"
""")

    def test_a_study_that_has_been_interrupted_goes_on_where_it_was(self):
        study = self.write(MANY)
        for number, status, count in ((signal.SIGINT, 130, 3), (signal.SIGTERM, 143, 8)):
            process = self.start(study, batch=self.stuck_batch(count))
            self.wait_until(lambda: self.ended() >= count)
            process.send_signal(number)
            _, err = process.communicate(timeout=30)
            self.assertEqual(process.returncode, status, err)
            self.assertIn(f'{self.ended()} of 20 runs are done, {20 - self.ended()} are still to be run', err)
            self.assertIn(f'start it again to go on; the table: {self.out / "study.csv"}', err)
            self.assertEqual(len(self.table()), self.ended())
            self.assertEqual(list((self.out / 'runs').glob('*.tmp')), [])
        self.assertLess(self.ended(), 20)
        times = {path: path.stat().st_mtime_ns for path in (self.out / 'runs').glob('*.json')}
        self.assertEqual(self.study(study, '--list')[0].count('\n'), 20 - len(times))
        self.assertIn('20 of 20 runs are done', self.study(study)[1])
        self.assertEqual(len(self.table()), 20)
        for path, changed in times.items():
            self.assertEqual(path.stat().st_mtime_ns, changed)

    def test_a_study_that_was_killed_takes_its_runs_along_and_goes_on(self):
        study = self.write(MANY)
        process = self.start(study, batch=self.stuck_batch(3))
        self.wait_until(lambda: self.ended() >= 3)
        process.kill()
        process.wait()

        def can_go_on():
            return 'at work here' not in subprocess.run(
                self.command(study, '--slurm'), cwd=self.folder, check=False, stderr=subprocess.PIPE, text=True).stderr
        self.wait_until(can_go_on)
        done = self.ended()
        self.assertLess(done, 20)
        time.sleep(0.3)
        self.assertEqual(self.ended(), done)
        self.study(study)
        self.assertEqual(len(self.table()), 20)

    def test_a_line_that_is_not_whole_is_no_result(self):
        study = self.write(FEW)
        self.study(study)
        first, second, *_ = sorted((self.out / 'runs').glob('*.json'))
        whole = first.read_text()
        first.write_text(whole[:100])
        second.write_text('')
        self.assertEqual(self.study(study, '--collect', status=1)[1].count('2 are still to be run'), 1)
        self.study(study)
        self.assertEqual(first.read_text().split('"step_ms"')[0], whole.split('"step_ms"')[0])

    def test_two_studies_at_once_in_one_folder_are_refused(self):
        study = self.write(MANY)
        process = self.start(study, batch=self.stuck_batch(1))
        self.wait_until(lambda: self.ended() >= 1)
        self.assertIn('at work here', self.study(study, status=2)[1])
        self.assertIn('at work here', self.study(self.write(FEW, 'few.yaml'), '--slurm', status=2)[1])
        self.assertIn('are done', self.study(study, '--collect', status=1)[1])
        process.terminate()
        process.wait(30)

    def test_what_fails_is_told_and_is_run_again_only_where_asked(self):
        """One run crashes, one's step fails, one is refused by the scene, one takes too long."""
        batch = self.fake_batch('''
case "$*" in
  *--steps\\ 0*) ;;
  *gravity=*-1]*) kill -SEGV $$ ;;
  *gravity=*-2]*) exec "$REAL" "$@" --set gravity=[0,0,-1.0e308] ;;
  *gravity=*-3]*) exec "$REAL" "$@" --set gravity=nothing ;;
  *gravity=*-4]*) exec sleep 1000 ;;
esac
exec "$REAL" "$@"''')
        study = self.write('scene: scene.yaml\nsteps: 1\ntime_limit: 3\nvary: {gravity: '
                           '[[0, 0, -1], [0, 0, -2], [0, 0, -3], [0, 0, -4], [0, 0, -5]]}\n')
        _, err = self.study(study, status=1, batch=batch)
        self.assertIn('1 of 5 runs are done, 4 failed', err)
        self.assertIn('the first that failed, ', err)
        reasons = {row['gravity'][-3:-1]: row['reason'] for row in self.table()}
        self.assertEqual(reasons['-1'], 'it was killed by signal 11')
        self.assertIn('step 1 failed: ', reasons['-2'])
        self.assertIn('exit status 2: incision_batch: ', reasons['-3'])
        self.assertEqual(reasons['-4'], 'it took longer than its time limit')
        self.assertEqual(reasons['-5'], '')
        self.assertEqual([row['status'] for row in self.table()], ['failed'] * 4 + ['done'])
        self.assertEqual([bool(row['steps']) for row in self.table()], [False, True, False, False, True])

        self.assertIn('4 failed', self.study(study, status=1)[1])
        self.assertEqual(self.study(study, '--list')[0], '')
        self.assertEqual(self.study(study, '--list', '--retry-failed')[0].count('\n'), 4)
        by_hand = self.study(study, '--list', '--retry-failed')[0].splitlines()[0]
        subprocess.run(by_hand, shell=True, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.assertIn('2 of 5 runs are done, 3 failed', self.study(study, status=1)[1])
        self.assertIn('5 of 5 runs are done', self.study(study, '--retry-failed')[1])
        self.assertEqual({row['status'] for row in self.table()}, {'done'})

    def test_a_disk_that_is_full_ends_the_study_and_is_told(self):
        """A folder in which nothing can be made stands for one; root may write everywhere, but not beyond a limit."""
        study = self.write(MANY)
        self.out.mkdir()
        (self.out / 'runs').mkdir()
        limited = f'ulimit -f 0; exec {shlex.join(self.command(study))}'
        done = subprocess.run(['sh', '-c', limited], cwd=self.folder, check=False, stderr=subprocess.PIPE, text=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertNotIn('Traceback', done.stderr)
        self.study(study)
        self.assertEqual(len(self.table()), 20)

    def test_runs_that_cannot_be_kept_end_the_study(self):
        batch = self.fake_batch(f"""
case "$*" in *--steps\\ 0*) ;; *) rm -rf {shlex.quote(str(self.out))}/runs ;; esac
exec "$REAL" "$@"
""")
        _, err = self.study(self.write(MANY), '--jobs', '1', status=1, batch=batch)
        self.assertIn('0 of 20 runs are done, 20 are still to be run', err)

    def test_it_needs_gnu_parallel_and_says_so(self):
        other = self.folder / 'parallel'
        shutil.copy(shutil.which('true'), other)
        study = self.write(FEW)
        done = subprocess.run(self.command(study), cwd=self.folder, check=False, stderr=subprocess.PIPE, text=True,
                              env={**os.environ, 'PATH': f'{self.folder}:{os.environ["PATH"]}'})
        self.assertEqual((done.returncode, done.stderr.count('\n')), (2, 1), done.stderr)
        self.assertIn('GNU parallel is not there', done.stderr)

    def test_options_of_the_users_own_for_parallel_change_nothing(self):
        study = self.write(FEW)
        subprocess.run(self.command(study), cwd=self.folder, check=True, stderr=subprocess.DEVNULL,
                       env={**os.environ, 'PARALLEL': '--dry-run --colsep t', 'SHELL': '/usr/bin/false'})
        self.assertEqual(len(self.table()), 4)

    def test_hosts_are_those_of_gnu_parallel(self):
        """`:` stands for this one without ssh. A path with braces is refused, since parallel would replace them."""
        study = self.write(FEW)
        self.assertIn('has braces', self.study(study, '--sshlogin', ':', status=2)[1])
        plain = self.folder.parent / "it's plain"
        shutil.move(self.folder, plain)
        self.folder, self.out = plain, plain / 'out'
        self.study(plain / 'study.yaml', '--sshlogin', '2/:')
        self.assertEqual(len(self.table()), 4)


if __name__ == '__main__':
    unittest.main()
