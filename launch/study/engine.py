"""Hands a study's runs to GNU parallel, here or over ssh, or to Slurm: chunks of command lines, see run_chunk."""

import contextlib
import ctypes
import os
import pathlib
import select
import shlex
import shutil
import signal
import subprocess
import sys
import time

from study.errors import InputError
from study.runs import json_of, record_of, runs_folder

# Most runs of a chunk: starting one costs some milliseconds, as one short run's twentieth part.
MAX_CHUNK = 20
# Towards the end chunks are as small as a share of what is left, so that no worker is long alone.
CHUNKS_LEFT = 4

# How long a run may take to end when it is told to [s].
KILL_AFTER = 10

# What a run elsewhere needs of the environment here: the libraries, and where packages are.
ENVIRONMENT = ('LD_LIBRARY_PATH', 'ROS_PACKAGE_PATH', 'CMAKE_PREFIX_PATH')

LOGGED_EVERY = 10  # [s], where no terminal shows how far it is
SHOWN_EVERY = 1

PR_SET_PDEATHSIG = 1  # of prctl(2)


def command_of(run, study, program, folder):
    """The command line of a run, for a shell."""
    words = [str(program), *run.arguments]
    if study.record:
        words += ['--record', str(record_of(folder, run.name))]
    words += ['--summary', str(json_of(folder, run.name))]
    return ' '.join(shlex.quote(word) for word in words)


def guided_sizes(count, workers):
    """How many runs each chunk has: many at first, one in the end."""
    while count > 0:
        size = min(MAX_CHUNK, max(1, count // (CHUNKS_LEFT * workers)))
        yield size
        count -= size


def even_sizes(count, chunks):
    for i in range(min(chunks, count)):
        yield count * (i + 1) // min(chunks, count) - count * i // min(chunks, count)


def write_chunks(folder, study, runs, program, sizes):
    """Writes what run_chunk needs. Returns the chunks' paths within the study's folder."""
    folder = pathlib.Path(folder)
    limit = f'timeout -k {KILL_AFTER} {study.time_limit:.17g} ' if study.time_limit else ''
    lists = folder / 'lists'
    lists.mkdir(exist_ok=True)
    number = max((int(entry.name) for entry in lists.iterdir() if entry.name.isdecimal()), default=0) + 1
    (lists / str(number)).mkdir()
    chunks, first = [], 0
    for i, size in enumerate(sizes, 1):
        chunk = f'lists/{number}/{i}'
        (folder / chunk).write_text(''.join(
            f'{run.name}\t{limit}{command_of(run, study, program, folder)}\n' for run in runs[first:first + size]),
            encoding='utf-8')
        first += size
        chunks.append(chunk)
    (folder / 'environment').write_text(''.join(
        f'export {name}={shlex.quote(os.environ[name])}\n' for name in ENVIRONMENT if os.environ.get(name)),
        encoding='utf-8')
    shutil.copy(pathlib.Path(__file__).resolve().parent / 'run_chunk', folder / 'run_chunk')
    return chunks


def find_parallel():
    """Another program of that name, in the package moreutils, is no script."""
    path = shutil.which('parallel')
    if not path or b'perl' not in pathlib.Path(path).read_bytes()[:100]:
        raise InputError('GNU parallel is not there (allowed: Debian\'s package parallel installed)')
    return path


def end_with_parent():
    """In the child: where the study is killed, parallel ends its jobs and itself."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGTERM)


def start_parallel(folder, chunks, jobs, hosts, kept_open):
    """`kept_open`: file descriptors that stay open as long as any run here goes on."""
    folder = pathlib.Path(folder)
    command = [find_parallel(), '--plain', '--will-cite', '--jobs', str(jobs) if jobs else '100%',
               '--joblog', str(folder / chunks[0]) + '.joblog', '--halt', 'soon,fail=1']
    script = './run_chunk'
    if hosts:
        if any(c in str(folder) for c in '{}'):
            raise InputError(f'{folder}: has braces, which GNU parallel would replace')
        command += ['--sshlogin', hosts]
        script = shlex.quote(str(folder / 'run_chunk'))
    environment = {**os.environ, 'PARALLEL_SHELL': '/bin/sh', 'INCISION_STUDY': str(os.getpid())}
    environment.pop('PARALLEL', None)  # options of the user's own
    return subprocess.Popen([*command, 'sh', script, '{}', ':::', *chunks], cwd=folder, env=environment,
                            stdin=subprocess.DEVNULL, start_new_session=True, pass_fds=kept_open,
                            preexec_fn=end_with_parent)


class Progress:
    """How many runs have come to an end, on a terminal in one line that changes, elsewhere in a line each 10 s."""

    def __init__(self, folder, count):
        self.folder, self.count = runs_folder(folder), count
        self.before = self.ended()
        self.on_terminal = sys.stderr.isatty()
        self.next = time.monotonic() + self.period()

    def period(self):
        return SHOWN_EVERY if self.on_terminal else LOGGED_EVERY

    def ended(self):
        return sum(entry.name.endswith(('.json', '.failed')) for entry in os.scandir(self.folder))

    def show(self):
        if time.monotonic() < self.next:
            return
        self.next = time.monotonic() + self.period()
        text = f'{self.ended() - self.before} of {self.count} runs'
        print(f'\r{text}  ' if self.on_terminal else f'incision_study: {text}',
              end='' if self.on_terminal else '\n', file=sys.stderr, flush=True)

    def clear(self):
        if self.on_terminal:
            print('\r\033[K', end='', file=sys.stderr, flush=True)


def session_of(process):
    """What else is alive in the session that a process leads, by process ids."""
    for path in pathlib.Path('/proc').glob('[0-9]*/stat'):
        try:
            state, _, _, session = path.read_text(errors='replace').rpartition(')')[2].split()[:4]
        except (OSError, ValueError):
            continue  # it has ended by now
        if int(session) == process.pid and state not in 'ZX' and path.parent.name != str(process.pid):
            yield int(path.parent.name)


def wait_for(process, last, progress, asked_to_end):
    """Waits for parallel and all that it has started, and ends it where `asked_to_end()`. `last`: a pipe that is closed
    when all that is here has ended. Returns parallel's exit status."""
    kill_at = None
    while not select.select([last], [], [], 0.1)[0]:
        progress.show()
        if asked_to_end() and kill_at is None:
            kill_at = time.monotonic() + KILL_AFTER
            process.terminate()
        elif kill_at is not None:
            # What parallel has just started when it was told to end it leaves alone, and of what has ended it may wait
            # for news.
            others = list(session_of(process))
            for pid in others:
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGTERM if time.monotonic() < kill_at else signal.SIGKILL)
            if not others:
                process.kill()
    return process.wait()


SBATCH = '''#!/bin/sh
# The runs of the study {study}: sbatch [OPTION]... THIS FILE
#SBATCH --job-name=incision_study
#SBATCH --array=1-{tasks}{limit}
#SBATCH --cpus-per-task={threads}
#SBATCH --output=/dev/null
cd {folder} || exit 1
exec ./run_chunk "lists/{number}/$SLURM_ARRAY_TASK_ID" >"lists/{number}/$SLURM_ARRAY_TASK_ID.slurm" 2>&1
'''


def write_slurm(folder, study, chunks, jobs):
    """A script for sbatch: an array job with a chunk a task. Returns its path."""
    path = pathlib.Path(folder) / 'study.sbatch'
    number = chunks[0].split('/')[1]
    path.write_text(SBATCH.format(study=study.path.name, tasks=len(chunks), limit=f'%{jobs}' if jobs else '',
                                  threads=study.threads, folder=shlex.quote(str(folder)), number=number),
                    encoding='utf-8')
    return path
