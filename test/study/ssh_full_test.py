#!/usr/bin/python3
"""A study on another host over ssh: here this one, through an ssh server of the test's own, with keys of its own."""

import os
import pathlib
import shutil
import socket
import subprocess
import tempfile
import time
import unittest

from study_case import StudyCase

SSHD = shutil.which('sshd', path=os.environ['PATH'] + ':/usr/sbin')
PRIVILEGES = pathlib.Path('/run/sshd')  # the server does not start without it

CONFIG = '''
ListenAddress 127.0.0.1:{port}
HostKey {folder}/host
AuthorizedKeysFile {folder}/user.pub
PidFile {folder}/pid
StrictModes no
PasswordAuthentication no
UsePAM no
PermitRootLogin prohibit-password
PermitUserRC no
'''


@unittest.skipUnless(SSHD and shutil.which('ssh-keygen') and os.getuid() == 0, 'needs an ssh server and root')
class Ssh(StudyCase):
    def serve(self):
        """Starts the server. Returns how parallel is to log in."""
        folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        if not PRIVILEGES.exists():
            PRIVILEGES.mkdir()
            self.addCleanup(PRIVILEGES.rmdir)
        with socket.socket() as probe:
            probe.bind(('127.0.0.1', 0))
            port = probe.getsockname()[1]
        for name in ('host', 'user'):
            subprocess.run(['ssh-keygen', '-q', '-t', 'ed25519', '-N', '', '-f', folder / name], check=True)
        (folder / 'config').write_text(CONFIG.format(port=port, folder=folder))
        server = subprocess.Popen([SSHD, '-D', '-f', folder / 'config', '-E', folder / 'log'])
        self.addCleanup(server.wait)
        self.addCleanup(server.terminate)
        login = (f'ssh -F none -p {port} -i {folder}/user -o StrictHostKeyChecking=no '
                 f'-o UserKnownHostsFile={folder}/known 127.0.0.1')
        deadline = time.monotonic() + 30
        while subprocess.run([*login.split(), 'true'], check=False, stderr=subprocess.DEVNULL).returncode != 0:
            self.assertLess(time.monotonic(), deadline, (folder / 'log').read_text())
            time.sleep(0.1)
        return login

    def test_runs_go_to_the_host_and_come_back_by_the_folder_that_both_see(self):
        login = self.serve()
        plain = self.folder.parent / "it's plain"
        shutil.move(self.folder, plain)
        self.folder, self.out = plain, plain / 'out'
        study = self.write('scene: scene.yaml\nsteps: 3\nvary: {gravity.2: [-1, -2, -3, -4]}\n')
        batch = self.fake_batch("""
case "$*" in *--steps\\ 0*) ;; *) [ "$SSH_CONNECTION" ] || exit 9 ;; esac
exec "$REAL" "$@"
""")
        self.study(study, '--sshlogin', login, batch=batch)
        self.assertEqual([row['status'] for row in self.table()], ['done'] * 4)

    def test_a_host_that_is_not_there_ends_the_study(self):
        plain = self.folder.parent / 'plain'
        shutil.move(self.folder, plain)
        self.folder, self.out = plain, plain / 'out'
        study = self.write('scene: scene.yaml\nsteps: 3\nvary: {gravity.2: [-1, -2]}\n')
        with socket.socket() as nobody:
            nobody.bind(('127.0.0.1', 0))
            login = f'1/ssh -F none -p {nobody.getsockname()[1]} 127.0.0.1'
            self.assertIn('2 are still to be run', self.study(study, '--sshlogin', login, status=1)[1])


if __name__ == '__main__':
    unittest.main()
