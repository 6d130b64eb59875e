#!/usr/bin/python3
"""Measures what each feature of a scene costs in a step: absent, idle and working.

usage: measure.py [--quick] --output FILE.json

Takes from the environment INCISION_REPORT, the folder of the report's programs, and INCISION_OBJECTS, that of the
object files. Instructions are counted on one thread; the other figures are those of two. Markers are measured where
the ROS node is built.
"""

import argparse
import concurrent.futures
import contextlib
import json
import os
import pathlib
import statistics
import sys

import claims
import functions
import ros_master
from cases import BASE, CASES, FULL, MARKERS, QUICK, ROS_CASES, SCENE, STEPS

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'support'))
import callgrind  # noqa: E402

PROGRAMS = pathlib.Path(os.environ['INCISION_REPORT'])
REPEATS = 5  # runs for a time; one in a quick run

# Only in the steps, and, on the thread that publishes, while it builds and sends a message.
COUNT = ('--instr-atstart=no', '--toggle-collect=*takeMeasuredStep*', '--toggle-collect=*MarkerPublisher7publish*')


def command(case, threads, quick):
    return [PROGRAMS / case.program, *case.parameters, SCENE, case.first, STEPS, f'solver.threads={threads}', *BASE,
            *(QUICK if quick else FULL), *case.settings]


def timed(case, quick, environment):
    """What the program says of the run, with the median over several runs for the time of a step."""
    runs = [json.loads(callgrind.run(command(case, 2, quick), environment)) for _ in range(1 if quick else REPEATS)]
    return {**runs[0], 'ms': statistics.median(ms for run in runs for ms in run['step_ms'])}


def counted(case, quick, environment, file_of):
    """Instructions a step: all, and those in the functions of each source file."""
    costs, _ = callgrind.count(command(case, 1, quick), options=COUNT, environment=environment)
    return {'instructions': sum(costs.values()) / STEPS, 'functions': functions.shares(costs, file_of, STEPS)}


def measure(cases, quick, environment, file_of):
    figures = [timed(case, quick, environment) for case in cases]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = list(pool.map(lambda case: counted(case, quick, environment, file_of), cases))
    return {case.key: {'feature': case.feature, 'state': case.state, 'text': case.text, 'against': case.against,
                       **figure, **count} for case, figure, count in zip(cases, figures, counts)}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--quick', action='store_true')
    parser.add_argument('--output', required=True)
    arguments = parser.parse_args()
    has_ros = (PROGRAMS / MARKERS).exists()
    file_of = functions.files(pathlib.Path(os.environ['INCISION_OBJECTS']))
    with ros_master.running() if has_ros else contextlib.nullcontext({}) as environment:
        cases = measure(CASES + (ROS_CASES if has_ros else ()), arguments.quick, environment, file_of)
    checked = claims.check(cases)
    with open(arguments.output, 'w', encoding='utf-8') as file:
        json.dump({'quick': arguments.quick, 'cases': cases, 'claims': checked}, file, indent=1)
    for claim in checked:
        print(f"{claim['claim']}: {claim['measured']} ({claim['wanted']}){'' if claim['holds'] else '  FAILS'}")
    return 0 if all(claim['holds'] for claim in checked) else 1


if __name__ == '__main__':
    sys.exit(main())
