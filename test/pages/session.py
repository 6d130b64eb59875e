"""A user's folder and terminals for the command lines of the pages: the package as installed, a ROS master of its own."""

import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest

import pages

TIMEOUT = 60.0  # [s] far above what anything here takes on a busy machine

# Stands in for rviz, which wants a display: says what it was asked to show, and stays until it is told to end.
RVIZ = '#!/bin/bash\necho "shows $*" >>"$HOME/rviz.log"\nexec sleep 600\n'

# catkin_make reads it, and asks for all of this.
MANIFEST = '<package format="2"><name>rviz</name><version>0.0.0</version><description>Stands in</description>' \
           '<maintainer email="nobody@example.org">nobody</maintainer><license>none</license></package>'


def free_port():
    with socket.socket() as taken:
        taken.bind(('127.0.0.1', 0))
        return taken.getsockname()[1]


def installed(build, prefix):
    """Installs the package there. catkin has another idea of where its setup files go, so they are brought."""
    subprocess.run(['cmake', '--install', str(build), '--prefix', str(prefix)], check=True, stdout=subprocess.DEVNULL)
    for path in (pathlib.Path(build) / 'catkin_generated/installspace').glob('*setup*'):
        shutil.copy(path, prefix)
    (prefix / '.catkin').touch()


class Session:
    """Runs blocks of shell commands in `folder`, some of them in terminals of their own."""

    def __init__(self, prefix):
        self._temporary = tempfile.TemporaryDirectory()
        self.folder = pathlib.Path(self._temporary.name) / 'home'
        self.folder.mkdir()
        stand_in = self._rviz()
        self._setup = f'source {prefix}/setup.bash && export CMAKE_PREFIX_PATH={stand_in}:$CMAKE_PREFIX_PATH ' \
                      f'ROS_PACKAGE_PATH={stand_in}/share:$ROS_PACKAGE_PATH ' \
                      f'PATH={stand_in}/lib/rviz:{prefix}/lib/incision:$PATH && '
        self.port = free_port()
        self._environment = {'HOME': str(self.folder), 'PATH': '/usr/bin:/bin:/usr/sbin:/sbin', 'ROS_IP': '127.0.0.1',
                             'ROS_HOME': str(self.folder.parent / 'ros'), 'LANG': 'C.UTF-8', 'ROSCONSOLE_STDOUT_LINE_BUFFERED': '1',
                             'ROS_MASTER_URI': f'http://127.0.0.1:{self.port}'}
        for name in ('OPENBLAS_CORETYPE', 'OPENBLAS_L2_SIZE'):
            if name in os.environ:
                self._environment[name] = os.environ[name]
        self._terminals = []

    def _rviz(self):
        """A package that stands in for rviz's."""
        prefix = self.folder.parent / 'stand_in'
        program = prefix / 'lib/rviz/rviz'
        manifest = prefix / 'share/rviz/package.xml'
        for path, text in ((program, RVIZ), (manifest, MANIFEST), (prefix / '.catkin', '')):
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding='utf-8')
        program.chmod(0o755)
        return prefix

    def _start(self, commands, **streams):
        # What is started in the background by a script ignores Ctrl-C, and so do all its shells; a terminal's do not.
        return subprocess.Popen(['bash', '-c', f'set -e; {self._setup} {commands}'], cwd=self.folder, text=True,
                                env=self._environment, stdin=subprocess.DEVNULL, start_new_session=True,
                                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL), **streams)

    def run(self, commands, timeout=TIMEOUT):
        """What the commands print; all of them must succeed."""
        process = self._start(commands, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        try:
            said, _ = process.communicate(timeout=timeout)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            said, _ = process.communicate()
            raise AssertionError(f'{commands}\nstill runs after {timeout} s:\n{said}') from None
        assert process.returncode == 0, f'{commands}\nended with {process.returncode}:\n{said}'
        return said

    def terminal(self, commands):
        """Runs the commands beside all others until close()."""
        log = open(self.folder.parent / f'terminal_{len(self._terminals)}.log', 'w+', encoding='utf-8')
        process = self._start(commands, stdout=log, stderr=subprocess.STDOUT)
        self._terminals.append((process, log, commands))
        return process

    def said(self, process):
        """What a terminal has printed so far."""
        path = next(log.name for terminal, log, _ in self._terminals if terminal is process)
        return pathlib.Path(path).read_text(encoding='utf-8')

    def wait_for(self, condition, what, timeout=TIMEOUT):
        deadline = time.monotonic() + timeout
        while not condition():
            for process, _, commands in self._terminals:
                assert process.poll() in (None, 0), f'{commands}\nended:\n{self.said(process)}'
            assert time.monotonic() < deadline, f'waited {timeout} s for {what}:\n' + \
                '\n'.join(self.said(process) for process, _, _ in self._terminals)
            time.sleep(0.1)

    def state(self, steps=1):
        """Waits until the node has taken that many steps, and returns a line of what it then says."""
        self.wait_for(lambda: self.lists('/incision/state'), 'the node')
        return self.run(f"rostopic echo -p --filter 'm.step >= {steps}' -n 1 /incision/state/step")

    def lists(self, topic):
        """Whether the master knows a topic; it may not be there yet."""
        process = self._start('rostopic list', stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        return topic in process.communicate(timeout=TIMEOUT)[0].splitlines()

    def interrupt(self, process):
        """Ctrl-C in a terminal; returns its exit status."""
        os.killpg(process.pid, signal.SIGINT)
        return process.wait(TIMEOUT)

    def close(self):
        for process, log, _ in reversed(self._terminals):
            if process.poll() is None:
                os.killpg(process.pid, signal.SIGINT)
                try:
                    process.wait(20)
                except subprocess.TimeoutExpired:
                    os.killpg(process.pid, signal.SIGKILL)
                    process.wait()
            log.close()
        self._temporary.cleanup()


def last_json(said):
    """The last line of what a run printed."""
    return json.loads(said.strip().splitlines()[-1])


def copied(session, path, name=None):
    """A file of the package, into the session's folder."""
    shutil.copy(pages.ROOT / path, session.folder / (name or pathlib.Path(path).name))


class Commands(unittest.TestCase):
    """Has the package as installed, and a session for each test."""

    build = None  # the folder that the package was built in

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.prefix = pathlib.Path(cls.folder.name) / 'installed'
        installed(cls.build, cls.prefix)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def setUp(self):
        self.session = Session(self.prefix)
        self.addCleanup(self.session.close)
