"""Measures published problems: by the program report_benchmark, and round cracks with GetFEM's elements beside.

Both give jumps along the same rays; intensities.py makes stress intensities of them.
"""

import json
import os
import pathlib
import subprocess
import tempfile

from benchmark.intensities import END, START, Front, errors_of_fit


HERE = pathlib.Path(__file__).resolve().parent


def program(quick, folder):
    path = pathlib.Path(folder) / 'benchmark.json'
    command = os.path.join(os.environ['INCISION_PROGRAMS'], 'report_benchmark')
    subprocess.run([command, *(['--quick'] if quick else []), path], check=True)
    return json.loads(path.read_text(encoding='utf-8'))


def by_getfem(problem, sizes, singular, folder, longest):
    """A curve by GetFEM, each point in a process of its own. On some meshes its search for what a level set cuts does
    not end, and on some it crashes: those that do, or take longer [s], are left out, and told."""
    given, made = pathlib.Path(folder) / 'problem.json', pathlib.Path(folder) / 'getfem.json'
    given.write_text(json.dumps(problem), encoding='utf-8')
    curve = {'code': 'GetFEM', 'singular': singular, 'points': [], 'failed': []}
    for cells in sizes:
        try:
            subprocess.run([HERE / 'getfem_cracks.py', given, str(cells), '1' if singular else '0', made], check=True,
                           env={**os.environ, 'PYTHONPATH': str(HERE.parent)}, stdout=subprocess.DEVNULL,
                           stderr=subprocess.PIPE, timeout=longest)
            curve['points'].append(json.loads(made.read_text(encoding='utf-8')))
        except subprocess.TimeoutExpired:
            curve['failed'].append(cells)
        except subprocess.CalledProcessError as error:
            if error.returncode > 0:
                raise RuntimeError(f'GetFEM: {error.stderr.decode()[-2000:]}') from error
            curve['failed'].append(cells)
    return curve


def finish(point, front):
    """Makes errors of a point's jumps."""
    point.update(front.errors(point.pop('rays')))
    point['missing_edges'] = point.pop('shift') / (point['edge'] * front.problem['radius'])


def measure(quick):
    sizes, longest = ((9, 11, 13), 120) if quick else ((13, 19, 27), 200)
    with tempfile.TemporaryDirectory() as folder:
        data = program(quick, folder)
        for problem in data['problems']:
            if not problem['flat']:
                continue
            described = {**{key: problem[key] for key in problem if key != 'curves'},
                         **{key: data[key] for key in ('rays', 'length', 'places')}}
            for singular in (False, True):
                problem['curves'].append(by_getfem(described, sizes, singular, folder, longest))
    data['uniform'] = Front(data['problems'][0], data['rays'], data['length'], data['places']).errors(
        data['uniform']['rays'])
    for problem in data['problems']:
        front = Front(problem, data['rays'], data['length'], data['places'])
        for curve in problem['curves']:
            for point in curve['points']:
                finish(point, front)
    data.update({'start': START, 'end': END, 'fit': errors_of_fit()})
    return data
