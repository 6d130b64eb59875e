"""Measures what each feature of a scene costs in a step: absent, idle and working.

Instructions are counted on one thread; the other figures are those of two. Markers are measured where the ROS node is
built.
"""

import collections
import concurrent.futures
import contextlib
import json
import os
import pathlib
import statistics
import subprocess
import sys

from cost import ros_master
from cost.cases import BASE, CASES, FULL, MARKERS, QUICK, ROS_CASES, SCENE, STEPS

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / 'support'))
import callgrind  # noqa: E402

REPEATS = 5  # runs for a time; one in a quick run

# Only in the steps, and, on the thread that publishes, while it builds and sends a message.
COUNT = ('--instr-atstart=no', '--toggle-collect=*takeMeasuredStep*', '--toggle-collect=*MarkerPublisher7publish*')


def programs():
    return pathlib.Path(os.environ['INCISION_PROGRAMS'])


def command(case, threads, quick):
    return [programs() / case.program, *case.parameters, SCENE, case.first, STEPS, f'solver.threads={threads}', *BASE,
            *(QUICK if quick else FULL), *case.settings]


def timed(case, quick, environment):
    """What the program says of the run, with the median over several runs for the time of a step."""
    runs = [json.loads(callgrind.run(command(case, 2, quick), environment)) for _ in range(1 if quick else REPEATS)]
    return {**runs[0], 'ms': statistics.median(ms for run in runs for ms in run['step_ms'])}


def counted(case, quick, environment):
    """Instructions a step: all, and those in each function of the package."""
    costs, _ = callgrind.count(command(case, 1, quick), options=COUNT, environment=environment)
    names = subprocess.run(['c++filt'], input='\n'.join(costs), stdout=subprocess.PIPE, text=True, check=True).stdout
    functions = collections.Counter()
    for name, count in zip(names.split('\n'), costs.values()):
        if 'incision::' in name:
            functions[name] += count / STEPS
    return {'instructions': sum(costs.values()) / STEPS, 'functions': functions}


def measure(quick):
    has_ros = (programs() / MARKERS).exists()
    cases = CASES + (ROS_CASES if has_ros else ())
    with ros_master.running() if has_ros else contextlib.nullcontext({}) as environment:
        figures = [timed(case, quick, environment) for case in cases]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            counts = list(pool.map(lambda case: counted(case, quick, environment), cases))
    return {'cases': {case.key: {'feature': case.feature, 'state': case.state, 'text': case.text,
                                 'against': case.against, **figure, **count}
                      for case, figure, count in zip(cases, figures, counts)}}
