"""The runs of a study: their values, their commands, and what has become of each."""

import contextlib
import dataclasses
import hashlib
import itertools
import json
import math
import pathlib

from study.errors import InputError
from study.values import as_yaml

MAX_RUNS = 100_000

DONE, FAILED, WAITING = 'done', 'failed', 'waiting'


@dataclasses.dataclass
class Run:
    name: str         # of its files: a hash of all that makes it up
    repetition: int
    values: dict      # of the keys that vary
    arguments: list   # of incision_batch, but for files to write


def count_runs(study):
    lists = [len(v.values) for v in study.varied.values() if v.values is not None]
    return math.prod(lists) * study.repetitions


def runs_of(study):
    """All runs, in the order of the study file. Throws InputError where they are too many."""
    count = count_runs(study)
    if count > MAX_RUNS:
        raise InputError(f'{study.path}: {count} runs (allowed: {MAX_RUNS})')
    scene_hash = hashlib.sha256(study.scene.read_bytes()).hexdigest()
    listed = [(key, v.values) for key, v in study.varied.items() if v.values is not None]
    runs = {}
    for combination in itertools.product(*(values for _, values in listed)):
        of_lists = dict(zip((key for key, _ in listed), combination))
        for repetition in range(study.repetitions):
            values = {key: of_lists[key] if variation.draw is None else variation.draw(repetition)
                      for key, variation in study.varied.items()}
            run = make_run(study, scene_hash, values, repetition)
            runs[run.name] = run  # what a list has twice is one run
    return list(runs.values())


def make_run(study, scene_hash, values, repetition):
    arguments = [str(study.scene), '--steps', str(study.steps), '--threads', str(study.threads)]
    for key, value in {**study.fixed, **values}.items():
        arguments += ['--set', f'{key}={as_yaml(value)}']
    parts = [scene_hash, *arguments[1:], str(repetition), str(study.record)]
    return Run(hashlib.sha256('\0'.join(parts).encode()).hexdigest()[:12], repetition, values, arguments)


def runs_folder(folder):
    return pathlib.Path(folder) / 'runs'


def record_of(folder, name):
    return runs_folder(folder) / f'{name}.csv'


def json_of(folder, name):
    return runs_folder(folder) / f'{name}.json'


def read_json(folder, name):
    """What a run has said in the end, or None where that is not there or not whole."""
    try:
        text = json_of(folder, name).read_text(encoding='utf-8')
        result = json.loads(text)
    except (OSError, ValueError):
        return None
    return result if isinstance(result, dict) and text.endswith('\n') else None


def outcome_of(folder, run):
    """(state, what it said in the end or None, why it failed)."""
    line = read_json(folder, run.name)
    failed = runs_folder(folder) / f'{run.name}.failed'
    with contextlib.suppress(OSError):  # there is no such file
        if line is None or failed.stat().st_mtime_ns >= json_of(folder, run.name).stat().st_mtime_ns:
            return FAILED, line, failed.read_text(errors='replace').strip()
    if line is None or line.get('interrupted'):
        return WAITING, None, ''
    return (FAILED, line, str(line['failure'])) if line.get('failure') else (DONE, line, '')


def forget(folder, runs):
    """Takes what is left of these runs away, so that they are to be run again."""
    for run in runs:
        for suffix in ('.json', '.failed'):
            (runs_folder(folder) / (run.name + suffix)).unlink(missing_ok=True)
