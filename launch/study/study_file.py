"""The study file: a scene, what all runs have in common, what varies from run to run. Read strictly."""

import dataclasses
import math
import pathlib

import yaml

from study.errors import InputError, check_keys
from study.values import parse_variation

KEYS = ('scene', 'steps', 'set', 'vary', 'repetitions', 'threads', 'record', 'time_limit')

# As incision_batch has them.
MAX_STEPS = 10_000_000
MAX_THREADS = 64

# One folder holds as many files without trouble, and no one waits for more.
MAX_REPETITIONS = 100_000
MAX_TIME_LIMIT = 1e7  # [s]: four months

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent  # what package://incision stands for


@dataclasses.dataclass
class Study:
    path: pathlib.Path
    scene: pathlib.Path
    steps: int = 100
    fixed: dict = dataclasses.field(default_factory=dict)
    varied: dict = dataclasses.field(default_factory=dict)  # key -> values.Variation
    repetitions: int = 1
    threads: int = 1
    record: bool = False
    time_limit: float = 0.0  # of a run [s]; 0: none


class StrictLoader(yaml.SafeLoader):
    """Refuses keys that stand twice, of which YAML's would take the last."""

    def construct_mapping(self, node, deep=False):
        seen = set()
        for key_node, _ in node.value:
            key = str(self.construct_object(key_node, deep=True))
            if key in seen:
                raise InputError(f'line {key_node.start_mark.line + 1}: {key}: the key stands twice')
            seen.add(key)
        return super().construct_mapping(node, deep)


def read_yaml(path):
    try:
        text = pathlib.Path(path).read_text(encoding='utf-8')
    except (OSError, ValueError) as error:
        raise InputError(f'{path}: cannot be read: {getattr(error, "strerror", None) or error}') from None
    try:
        return yaml.load(text, Loader=StrictLoader)
    except InputError as error:
        raise InputError(f'{path}: {error}') from None
    except (yaml.YAMLError, RecursionError, ValueError) as error:
        mark = getattr(error, 'problem_mark', None)
        line = f'line {mark.line + 1}: ' if mark else ''
        raise InputError(f'{path}: {line}{getattr(error, "problem", None) or error}') from None


def number(value, where, least, most, kind=float):
    """A number within these bounds; text that reads as one is one."""
    allowed = f'allowed: {kind is int and "a whole number, " or ""}{least:g} to {most:g}'
    try:
        result = float('nan') if isinstance(value, bool) else float(value)
    except (TypeError, ValueError):
        result = math.nan
    if not least <= result <= most or (kind is int and result != int(result)):
        raise InputError(f'{where}: {value!r} ({allowed})')
    return kind(result)


def section(value, where):
    if not isinstance(value, dict) or not all(isinstance(key, str) for key in value):
        raise InputError(f'{where}: {value!r} (allowed: scene keys with their values)')
    return value


def find_scene(value, where, folder):
    if not isinstance(value, str) or not value:
        raise InputError(f'{where}: {value!r} (allowed: the path of a scene)')
    package, _, rest = value.removeprefix('package://').partition('/')
    if value.startswith('package://') and package != 'incision':
        raise InputError(f'{where}: {value!r} (allowed: a path, or package://incision/PATH)')
    path = ROOT / rest if value.startswith('package://') else folder / value
    if not path.is_file():
        raise InputError(f'{where}: {path} is no file')
    return path.resolve()


def read_study(path):
    """Throws InputError with what is wrong, and in which key."""
    path = pathlib.Path(path)
    data = read_yaml(path)
    if not isinstance(data, dict):
        raise InputError(f'{path}: no study (allowed: the keys {", ".join(KEYS)})')
    try:
        check_keys(data, '', KEYS)
        if 'scene' not in data:
            raise InputError('scene: is missing')
        study = Study(path, find_scene(data['scene'], 'scene', path.resolve().parent))
        study.steps = number(data.get('steps', study.steps), 'steps', 0, MAX_STEPS, int)
        study.threads = number(data.get('threads', study.threads), 'threads', 1, MAX_THREADS, int)
        study.repetitions = number(data.get('repetitions', 1), 'repetitions', 1, MAX_REPETITIONS, int)
        study.time_limit = number(data.get('time_limit', 0), 'time_limit', 0, MAX_TIME_LIMIT)
        study.record = data.get('record', False)
        if not isinstance(study.record, bool):
            raise InputError(f'record: {study.record!r} (allowed: true or false)')
        study.fixed = section(data.get('set', {}), 'set')
        for key, value in section(data.get('vary', {}), 'vary').items():
            if key in study.fixed:
                raise InputError(f'vary.{key}: stands under set too')
            study.varied[key] = parse_variation(key, value, f'vary.{key}')
        for key in (*study.fixed, *study.varied):
            if key == 'solver.threads' or '=' in key or not key.isprintable() or not key:
                raise InputError(f'{key!r}: no scene key to set here' +
                                 (' (say threads at the top level)' if key == 'solver.threads' else ''))
    except InputError as error:
        raise InputError(f'{path}: {error}') from None
    return study
