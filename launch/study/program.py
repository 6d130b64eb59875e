"""What incision_study does from its arguments on."""

import argparse
import contextlib
import fcntl
import os
import pathlib
import shlex
import shutil
import signal
import subprocess
import sys

from study import engine
from study.errors import InputError
from study.runs import FAILED, WAITING, forget, outcome_of, runs_folder, runs_of
from study.study_file import ROOT, read_study
from study.table import collect, table_of

DONE, NOT_ALL_DONE, BAD_INPUT = 0, 1, 2

MAX_JOBS = 10_000
# Slurm takes as many tasks of a job by default.
MAX_TASKS = 1000


def positive(most):
    def parse(text):
        value = int(text)
        if not 1 <= value <= most:
            raise argparse.ArgumentTypeError(f'{text} (allowed: 1 to {most})')
        return value
    parse.__name__ = 'number'
    return parse


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(
        prog='incision_study', allow_abbrev=False,
        description='Runs a scene many times with other values, and gathers what the runs say in one table. '
                    'What is done already is not run again.',
        epilog='Exit status: 0 all runs are done, 1 some failed or are still to be run, 2 bad input, 130 Ctrl-C, '
               '143 ended by SIGTERM.')
    parser.add_argument('study', metavar='STUDY.yaml')
    parser.add_argument('--out', metavar='FOLDER', help='the folder of the study (default: its name here)')
    instead = parser.add_mutually_exclusive_group()
    instead.add_argument('--list', action='store_true', help='only print the runs that are to be run, a command each')
    instead.add_argument('--collect', action='store_true', help='only gather the table, FOLDER/study.csv')
    instead.add_argument('--plot', nargs=2, metavar=('X', 'Y'),
                         help='only gather the table and draw one of its columns against another, FOLDER/X_Y.png')
    instead.add_argument('--slurm', action='store_true', help='only write FOLDER/study.sbatch, an array job for sbatch')
    parser.add_argument('--jobs', type=positive(MAX_JOBS), metavar='N',
                        help='runs at a time (default: one a core; Slurm: as many as it lets)')
    parser.add_argument('--sshlogin', metavar='HOSTS', help='run on these hosts, as GNU parallel takes them')
    parser.add_argument('--tasks', type=positive(MAX_TASKS), default=100, metavar='N',
                        help='most tasks of the array job (default 100)')
    parser.add_argument('--retry-failed', action='store_true', help='run again what has failed')
    parser.add_argument('--batch', metavar='PROGRAM', help='incision_batch (default: beside this program, or on PATH)')
    return parser.parse_args(arguments)


def find_batch(given):
    """The program of the runs: as given, beside this one, in the default build, or on PATH."""
    places = [given] if given else [
        pathlib.Path(sys.argv[0]).absolute().parent / 'incision_batch',
        ROOT / 'build' / 'devel' / 'lib' / 'incision' / 'incision_batch', shutil.which('incision_batch')]
    for place in places:
        if place and os.access(place, os.X_OK) and pathlib.Path(place).is_file():
            return pathlib.Path(place).absolute()
    raise InputError(f'{given or "incision_batch"}: no such program (--batch PROGRAM says where it is)')


def make_folder(folder):
    """Throws InputError where the folder is not one for this."""
    try:
        if folder.is_dir() and any(folder.iterdir()) and not runs_folder(folder).is_dir():
            raise InputError(f'{folder}: holds something else (--out FOLDER names another)')
        runs_folder(folder).mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f'{folder}: cannot be used: {error.strerror}') from None


@contextlib.contextmanager
def locked(folder):
    """A file descriptor. As long as it or a copy of it is open, no other study uses the folder."""
    descriptor = os.open(folder / 'lock', os.O_RDWR | os.O_CREAT, 0o644)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield descriptor
    except BlockingIOError:
        raise InputError(f'{folder}: another incision_study, or a run of it, is at work here') from None
    finally:
        os.close(descriptor)


def try_first(study, run, program):
    """Loads the scene of one run, so that a mistake in the study is told at once, with the study's own key."""
    done = subprocess.run([program, *run.arguments, '--steps', '0'], stdin=subprocess.DEVNULL, check=False,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, errors='replace')
    if done.returncode == 2:
        wrong = done.stderr.strip().rpartition('\n')[2].removeprefix('incision_batch: ')
        said_at = [f'{study.path}: {section}.{key}: ' for section, keys in (('set', study.fixed), ('vary', study.varied))
                   for key in keys if f'{key}:' in wrong]
        raise InputError(''.join(said_at[:1]) + wrong)


def say(text):
    print(f'incision_study: {text}', file=sys.stderr, flush=True)


def tell(folder, runs):
    """Says what has become of the runs. Returns whether all are done."""
    outcomes = [outcome_of(folder, run) for run in runs]
    states = [state for state, _, _ in outcomes]
    failed, waiting = states.count(FAILED), states.count(WAITING)
    say(f'{len(runs) - failed - waiting} of {len(runs)} runs are done' + (f', {failed} failed' if failed else '') +
        (f', {waiting} are still to be run: start it again to go on' if waiting else '') + f'; the table: {table_of(folder)}')
    if failed:
        i = states.index(FAILED)
        say(f'the first that failed, {runs[i].name}: {outcomes[i][2]}')
    return not failed and not waiting


def run_here(folder, study, pending, program, arguments, descriptor):
    """Runs what is pending. Returns the signal that has ended it, or None."""
    ended_by = []
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda n, _: ended_by.append(n))
    for part in runs_folder(folder).glob('*.tmp'):  # of runs that were killed
        part.unlink(missing_ok=True)
    hosts = arguments.sshlogin.count(',') + 1 if arguments.sshlogin else 1
    workers = (arguments.jobs or os.cpu_count()) * hosts
    chunks = engine.write_chunks(folder, study, pending, program, engine.guided_sizes(len(pending), workers))
    progress = engine.Progress(folder, len(pending))
    last, held = os.pipe()
    process = engine.start_parallel(folder, chunks, arguments.jobs, arguments.sshlogin, (descriptor, held))
    os.close(held)
    status = engine.wait_for(process, last, progress, lambda: bool(ended_by))
    os.close(last)
    progress.clear()
    if status != 0 and not ended_by:
        say(f'GNU parallel has ended with exit status {status}')
    return ended_by[0] if ended_by else None


def print_list(study, folder, runs, program, retry_failed):
    for run in runs:
        state = outcome_of(folder, run)[0]
        if state == WAITING or (retry_failed and state == FAILED):
            print(engine.command_of(run, study, program, folder))


def run_study(arguments, study, folder, runs, program, descriptor):
    """Runs what is to be run, or writes the script that will. Returns the program's exit status."""
    outcomes = [(run, outcome_of(folder, run)[0]) for run in runs]
    pending = [run for run, state in outcomes if state == WAITING or (arguments.retry_failed and state == FAILED)]
    ended_by = None
    if pending:
        try_first(study, pending[0], program)
    forget(folder, pending)  # what is not whole, or has failed
    if pending and arguments.slurm:
        chunks = engine.write_chunks(folder, study, pending, program, engine.even_sizes(len(pending), arguments.tasks))
        script = engine.write_slurm(folder, study, chunks, arguments.jobs)
        say(f'{len(pending)} runs in {len(chunks)} tasks: sbatch {shlex.quote(str(script))}')
        return DONE
    if pending:
        ended_by = run_here(folder, study, pending, program, arguments, descriptor)
    collect(study, folder, runs)
    all_done = tell(folder, runs)
    return 128 + ended_by if ended_by else DONE if all_done else NOT_ALL_DONE


def work(arguments):
    study = read_study(arguments.study)
    folder = pathlib.Path(arguments.out or pathlib.Path(arguments.study).stem).absolute()
    for path in (folder, study.scene, study.path.absolute()):
        if not str(path).isprintable():
            raise InputError(f'{str(path)!r}: cannot be used (allowed: a path of printable characters)')
    runs = runs_of(study)
    if arguments.collect or arguments.plot:
        make_folder(folder)
        return gather(arguments, study, folder, runs)
    program = find_batch(arguments.batch)
    make_folder(folder)
    if arguments.list:
        print_list(study, folder, runs, program, arguments.retry_failed)
        return DONE
    with locked(folder) as descriptor:
        return run_study(arguments, study, folder, runs, program, descriptor)


def gather(arguments, study, folder, runs):
    rows = collect(study, folder, runs)
    if arguments.plot:
        from study.plot import draw
        x, y = arguments.plot
        if not rows:
            raise InputError(f'--plot: {folder} has no run that is done')
        path = folder / f'{x}_{y}.png'.replace('/', '_')
        draw(rows, list(study.varied), x, y, path)
        print(path)
    return DONE if tell(folder, runs) else NOT_ALL_DONE


def main(arguments):
    arguments = parse_arguments(arguments)
    try:
        with contextlib.suppress(BrokenPipeError):
            return work(arguments)
        return DONE
    except InputError as error:
        say(error)
        return BAD_INPUT
    except OSError as error:  # of the disk
        say(f'{error.filename or "the study"}: {error.strerror}')
        return NOT_ALL_DONE
    except KeyboardInterrupt:
        return 128 + signal.SIGINT
