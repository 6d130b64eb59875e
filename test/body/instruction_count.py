#!/usr/bin/python3
"""Counts the instructions of a step with valgrind and fails where a scene needs more than its bound.

usage: instruction_count.py INCISION_BATCH VALGRIND

A count is that of a long run less that of a short one, so loading the scene drops out. It needs no quiet machine, but
it holds for one compiler and one set of flags: the Release build with GCC for plain x86-64.
"""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / 'support'))
import callgrind  # noqa: E402

SCENE = pathlib.Path(__file__).resolve().parents[2] / 'config/scenes/bar.yaml'
SHORT, LONG = 20, 60  # steps

# Before the 31st step, so in the long run alone.
CUT = ('cuts=[{time: 0.3, point: [0.51, 0.12, 0.12], normal: [1, 0.1, 0.05]}]',)
ITERATIVE = ('solver.method=iterative',)

# Name, settings, and bound in millions a step, some 10 % above what was counted when it was last set.
CASES = (
    ('uncut', ITERATIVE, 10.5),  # counted: 9.51
    ('cut once', ITERATIVE + CUT, 13.2),  # counted: 11.97
    ('averaged pressure', ITERATIVE + ('body.pressure=averaged',), 13.5),  # counted: 12.21
    ('without warping', ('body.warping=false',), 3.1),  # counted: 2.80
    ('fracture waits', ITERATIVE + ('fracture={tensile_strength: 1.0e+9}',), 10.9),  # counted: 9.91
    ('cohesion', ITERATIVE + ('fracture={tensile_strength: 2.0e+4, fracture_energy: 10}',), 32.6),  # counted: 29.57
)


def instructions(batch, valgrind, steps, settings):
    """Of a whole run on one thread."""
    sets = [word for setting in ('solver.tolerance=1e-4', *settings) for word in ('--set', setting)]
    costs, _ = callgrind.count([batch, SCENE, '--steps', steps, '--threads', 1, *sets], valgrind)
    return sum(costs.values())


def main(batch, valgrind):
    failed = False
    for name, settings, bound in CASES:
        long, short = (instructions(batch, valgrind, steps, settings) for steps in (LONG, SHORT))
        count = (long - short) / (LONG - SHORT) / 1e6
        failed = failed or count > bound
        print(f'{name}: {count:.2f} million instructions a step, at most {bound} allowed', flush=True)
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main(*sys.argv[1:]))
