"""The values that a key takes from run to run: a list, a range, or random draws."""

import dataclasses
import json
import math
import random
import re

from study.errors import InputError, check_keys

# kind -> what its two numbers are
RANGES = {'range': 'first and last', 'log_range': 'first and last'}
DRAWS = {'uniform': 'least and most', 'log_uniform': 'least and most', 'normal': 'mean and standard deviation'}

MAX_COUNT = 100_000

# Text that YAML reads as the same text, and not as a number, a truth or nothing.
PLAIN = re.compile(r'[A-Za-z_/][-\w./]*(:/[-\w./]+)?', re.ASCII)
NOT_TEXT = {'true', 'false', 'yes', 'no', 'on', 'off', 'null', 'y', 'n'}


@dataclasses.dataclass
class Variation:
    values: list = None  # of a list or range
    draw: object = None  # repetition -> value, of random draws


def evenly(first, last, count):
    if count == 1:
        return [first]
    return [first + (last - first) * i / (count - 1) for i in range(count - 1)] + [last]


def two_numbers(value, where, meaning):
    try:
        numbers = [math.nan if isinstance(v, bool) else float(v) for v in value]
    except (TypeError, ValueError):
        numbers = []
    if len(numbers) != 2 or not all(math.isfinite(v) for v in numbers):
        raise InputError(f'{where}: {value!r} (allowed: two finite numbers, {meaning})')
    return numbers


def whole_number(value, where, least, most):
    if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
        raise InputError(f'{where}: {value!r} (allowed: a whole number, {least} to {most})')
    return value


def drawer(kind, first, second, seed, key):
    """repetition -> value. The same for each repetition, whatever else varies, and other for each key."""
    def draw(repetition):
        source = random.Random(f'{seed} {key} {repetition}')
        if kind == 'normal':
            return source.gauss(first, second)
        if kind == 'log_uniform':
            return math.exp(source.uniform(math.log(first), math.log(second)))
        return source.uniform(first, second)
    return draw


def parse_variation(key, value, where):
    """Throws InputError with what is allowed."""
    if isinstance(value, list):
        if not value:
            raise InputError(f'{where}: [] (allowed: at least one value)')
        return Variation(values=value)
    allowed = (*RANGES, 'count', *DRAWS, 'seed')
    if not isinstance(value, dict):
        raise InputError(f'{where}: {value!r} (allowed: a list of values, or a map with one of '
                         f'{", ".join((*RANGES, *DRAWS))}; what does not vary goes under set)')
    check_keys(value, where + '.', allowed)
    kinds = [kind for kind in (*RANGES, *DRAWS) if kind in value]
    if len(kinds) != 1:
        raise InputError(f'{where}: has {" and ".join(kinds) or "no kind"} (allowed: one of '
                         f'{", ".join((*RANGES, *DRAWS))})')
    kind = kinds[0]
    first, second = two_numbers(value[kind], f'{where}.{kind}', {**RANGES, **DRAWS}[kind])
    if kind.startswith('log_') and min(first, second) <= 0:
        raise InputError(f'{where}.{kind}: {value[kind]!r} (allowed: numbers above 0)')
    if kind == 'normal' and second < 0:
        raise InputError(f'{where}.{kind}: {value[kind]!r} (allowed: a standard deviation of 0 or more)')
    if kind in DRAWS:
        check_keys(value, where + '.', (kind, 'seed'))
        seed = whole_number(value.get('seed', 0), where + '.seed', 0, 2**63)
        return Variation(draw=drawer(kind, first, second, seed, key))
    check_keys(value, where + '.', (kind, 'count'))
    count = whole_number(value.get('count'), where + '.count', 1, MAX_COUNT)
    if kind == 'log_range':
        inner = [math.exp(v) for v in evenly(math.log(first), math.log(second), count)]
        return Variation(values=([first] + inner[1:-1] + [second])[:count])
    return Variation(values=evenly(first, second, count))


def as_yaml(value):
    """A value as `--set` takes it: YAML in one line, from which the same value is read."""
    if isinstance(value, bool) or value is None:
        return json.dumps(value)
    if isinstance(value, float):
        if not math.isfinite(value):
            return '.nan' if math.isnan(value) else '.inf' if value > 0 else '-.inf'
        digits, e, exponent = repr(value).partition('e')
        return f'{digits if "." in digits else digits + ".0"}{e}{exponent}'  # 1.0e-300: 1e-300 is text in YAML
    if isinstance(value, dict):
        return '{' + ', '.join(f'{as_yaml(str(k))}: {as_yaml(v)}' for k, v in value.items()) + '}'
    if isinstance(value, (list, tuple)):
        return '[' + ','.join(as_yaml(v) for v in value) + ']'
    if isinstance(value, int):
        return str(value)
    text = str(value)
    try:
        float(text)
        return text  # a number that YAML took for text, such as 1e6
    except ValueError:
        is_plain = PLAIN.fullmatch(text) and text.lower() not in NOT_TEXT
        return text if is_plain else json.dumps(text, ensure_ascii=False)
