#!/usr/bin/python3
"""Measures what each feature of a scene costs in a step: absent, idle and working.

usage: measure.py [--quick] --output FILE.json

Takes from the environment INCISION_REPORT, the folder of the report's programs, and INCISION_OBJECTS, that of the
core's object files. Instructions are counted on one thread; the other figures are those of two.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import statistics
import sys

import claims
import stages
from cases import BASE, CASES, COARSE, FIRST, SCENE, STEPS

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / 'support'))
import callgrind  # noqa: E402

REPEATS = 5


def command(program, case, threads, quick):
    return [program, SCENE, FIRST, STEPS, f'solver.threads={threads}', *BASE, *(COARSE if quick else ()),
            *case.settings]


def timed(program, case, quick):
    """What the program says of the run, with the median over several runs for the time of a step."""
    runs = [json.loads(callgrind.run(command(program, case, 2, quick))) for _ in range(REPEATS)]
    return {**runs[0], 'ms': statistics.median(ms for run in runs for ms in run['step_ms'])}


def counted(program, case, quick, stage_of):
    """Instructions a step: all, and those in the functions of each stage."""
    costs, _ = callgrind.count(command(program, case, 1, quick), inside=['*takeMeasuredSteps*'])
    return {'instructions': sum(costs.values()) / STEPS,
            'stages': {stage: count / STEPS for stage, count in stages.shares(costs, stage_of).items()}}


def measure(quick):
    program = pathlib.Path(os.environ['INCISION_REPORT']) / 'report_cost'
    stage_of = stages.functions(pathlib.Path(os.environ['INCISION_OBJECTS']))
    figures = [timed(program, case, quick) for case in CASES]
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = list(pool.map(lambda case: counted(program, case, quick, stage_of), CASES))
    return {case.key: {'feature': case.feature, 'state': case.state, 'text': case.text, 'against': case.against,
                       **figure, **count} for case, figure, count in zip(CASES, figures, counts)}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--quick', action='store_true')
    parser.add_argument('--output', required=True)
    arguments = parser.parse_args()
    cases = measure(arguments.quick)
    checked = claims.check(cases)
    with open(arguments.output, 'w', encoding='utf-8') as file:
        json.dump({'quick': arguments.quick, 'steps': STEPS, 'cases': cases, 'claims': checked}, file, indent=1)
    for claim in checked:
        print(f"{claim['claim']}: {claim['measured']} ({claim['wanted']}){'' if claim['holds'] else '  FAILS'}")
    return 0 if all(claim['holds'] for claim in checked) else 1


if __name__ == '__main__':
    sys.exit(main())
