#!/usr/bin/python3
"""Latency of the tool: from a pose received until the wrench of the first step that followed it is published.

usage: latency.py [--quick] LATENCY.json PLOT.png
  --quick  10 s a body instead of 60

Needs a sourced workspace. The real node steps a block; incision_scalpel leads a blade slowly through it by a thousand
poses a second, against a cutting force. The node says in ~state how old the newest pose was when the wrench of a step
was published: it waited for the step to start, and then for the step. Any other pose since the step before is older by
what it came earlier, so a pose that comes at any time is older by a random share of the time between two steps.
"""

import contextlib
import json
import os
import pathlib
import statistics
import subprocess
import sys
import time

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / 'report' / 'cost'))
import ros_master  # noqa: E402
import roslib.packages  # noqa: E402
import rospy  # noqa: E402
from incision.msg import BodyState  # noqa: E402

BODIES = (((16, 4, 4), 0.001), ((32, 8, 8), 0.005))  # cells, and the time step [s]
SIZE = (0.4, 0.1, 0.1)  # of the block [m]
WAY = 0.36              # of the blade in the run [m]
BESIDE = 0.045          # of the cut, from a side, not to run along the elements' faces [m]
DEPTH = 0.05            # of the blade below the block's top [m]
RATE = 1000             # poses a second
SHARES = 20             # places between two steps at which any pose may come

# Of the curves: key, name, dash.
KINDS = (('newest', 'newest pose', '-'), ('any', 'any pose', '--'))
COLOURS = ('#1b2a49', '#c1443c')


def scene(cells, time_step):
    """Tissue that lies on a table; the faces of the cut press on each other."""
    return {'body': {'grid': {'cells': list(cells), 'size': list(SIZE), 'origin': [0, 0, 0]},
                     'material': {'young_modulus': 3e4, 'poisson_ratio': 0.45, 'density': 1000, 'mass_damping': 2}},
            'boundary': [{'box': [[-1, -1, -1e-6], [1, 1, 1e-6]]}],
            'solver': {'time_step': time_step, 'tolerance': 1e-4},
            'contact': {'friction': 0.3},
            'tools': {'scalpel': {'type': 'blade', 'edge': [[0, 0, 0], [0, 0, SIZE[2]]], 'cutting_force': 20}}}


def path():
    return [[x, BESIDE, SIZE[2] - DEPTH, 0, 0, 0] for x in (-0.01, WAY - 0.01)]


@contextlib.contextmanager
def running(program, name, parameters, remapped=()):
    for key, value in parameters.items():
        rospy.set_param(f'/{name}/{key}', value)
    executable = roslib.packages.find_node('incision', program)[0]  # rosrun overlooks what lies in build/ of the sources
    process = subprocess.Popen([executable, f'__name:={name}', *remapped], stdout=subprocess.DEVNULL)
    try:
        yield
    finally:
        process.terminate()
        process.wait()


def states_of(cells, time_step, seconds):
    """All states in which the blade is in the tissue, of a run of some seconds."""
    states = []
    with running('incision_node', 'body', {'scene': scene(cells, time_step), 'marker_rate': 0}):
        rospy.wait_for_message('/body/state', BodyState, timeout=60)
        subscriber = rospy.Subscriber('/body/state', BodyState, states.append, queue_size=None, tcp_nodelay=True)
        with running('incision_scalpel', 'scalpel', {'path': path(), 'speed': WAY / seconds, 'rate': RATE},
                     ['/scalpel/pose:=/body/scalpel/servo_cp']):
            time.sleep(seconds)
        subscriber.unregister()
    return [state for state in states if state.tools[0].depth > 0 and state.tools[0].latency > 0]


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def summary(milliseconds):
    return {'median': statistics.median(milliseconds), 'p99': percentile(milliseconds, 0.99)}


def measure(cells, time_step, seconds):
    states = states_of(cells, time_step, seconds)
    if len(states) < 10:
        sys.exit(f'latency.py: only {len(states)} steps followed a pose in the tissue')
    newest = [1e3 * state.tools[0].latency for state in states]
    between = [1e3 * (b.header.stamp - a.header.stamp).to_sec() for a, b in zip(states, states[1:])]
    cutting = [b.step_ms for a, b in zip(states, states[1:]) if b.parts > a.parts]
    older = [latency + (k + 0.5) / SHARES * pause for latency, pause in zip(newest[1:], between) for k in range(SHARES)]
    return {'elements': states[0].elements, 'time_step': time_step, 'crack_elements': states[-1].crack_elements, 'steps': len(states),
            'newest_ms': newest, 'any_ms': [percentile(older, k / 500) for k in range(501)],
            'newest': summary(newest), 'any': summary(older),
            'computing': summary([state.step_ms for state in states]),
            'cutting': summary(cutting),
            'waiting': summary([max(0, latency - state.step_ms) for latency, state in zip(newest, states)]),
            'between': summary(between)}


def draw(rows, file):
    plt.figure(figsize=(5.5, 3.8))
    for row, colour in zip(rows, COLOURS):
        for key, name, dash in KINDS:
            values = sorted(row[f'{key}_ms'])
            plt.semilogx(values, [100 * (k + 1) / len(values) for k in range(len(values))], dash, color=colour,
                         label=f"{row['elements']:,} elements, {name}")
    plt.xlabel('from pose received to wrench published [ms]')
    plt.ylabel('share of the poses below [%]')
    axis = plt.gca().xaxis
    axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f'{value:g}'))
    axis.set_minor_formatter(NullFormatter())
    plt.xlim(1, 4 * max(row['any']['p99'] for row in rows))
    plt.grid(True, which='both', alpha=0.3)
    plt.legend(fontsize=8, loc='lower right')
    plt.tight_layout()
    plt.savefig(file, dpi=100)


def print_table(rows):
    keys = ('newest', 'any', 'waiting', 'computing', 'cutting', 'between')
    print('| elements | Δt ms | steps | newest pose: median, p99 ms | any pose | of the newest: waiting for the step '
          '| computing | the same where an element is cut | from step to step |\n' + '|---' * 9 + '|')
    for row in rows:
        cells = [f"{row[key]['median']:.2f}, {row[key]['p99']:.2f}" for key in keys]
        print(f"| {row['elements']:,} | {1e3 * row['time_step']:g} | {row['steps']} | " + ' | '.join(cells) + ' |')


def main(seconds, data, plot):
    with ros_master.running() as environment:
        os.environ.update(environment)
        rospy.init_node('latency', disable_signals=True)
        rows = [measure(cells, time_step, seconds) for cells, time_step in BODIES]
        rospy.signal_shutdown('done')
    pathlib.Path(data).write_text(json.dumps(rows, indent=1) + '\n', encoding='utf-8')
    draw(rows, plot)
    print_table(rows)


if __name__ == '__main__':
    arguments = sys.argv[1:]
    quick = '--quick' in arguments
    files = [argument for argument in arguments if argument != '--quick']
    if len(files) != 2:
        sys.exit(__doc__)
    main(10 if quick else 60, *files)
