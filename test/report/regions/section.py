"""Bodies of several materials: error against wall time, by contrast."""

import math

from plots import curve, plain_numbers
from regions.figures import LAYERS, apart, at_error, balls, beams, finest, more_iterations, order
from static.figures import column
from static.section import log_axes, span

ERRORS = (0.1, 0.03, 0.01)  # that one may be content with
EXTREMES = (1e4, 1e-4)


def mesh_name(conforming):
    return 'Gmsh' if conforming else 'grid'


def power(contrast):
    return f'{contrast:g}' if 1e-3 < contrast < 1e4 else f'1e{round(math.log10(contrast))}'


def draw_ball(axes, data, key, title):
    drawn = [(found, 2 * k + conforming) for k, contrast in enumerate(EXTREMES) for conforming in (False, True)
             for found in balls(data, conforming, [contrast])]
    for found, number in drawn:
        axes.plot(column(found['points'], 'ms'), 100 * abs(column(found['points'], key)), **curve(number),
                  label=f"{mesh_name(found['conforming'])}, contrast {power(found['contrast'])}")
    log_axes(axes, title)
    axes.legend()


def draw_layers(axes, data):
    for number, (name, contrast) in enumerate((name, contrast) for name in LAYERS for contrast in (1, 1e4)):
        for found in beams(data, name, [contrast]):
            axes.plot(column(found['points'], 'ms'), 100 * column(found['points'], 'error'), **curve(number),
                      label=f'{name}, contrast {power(contrast)}')
    log_axes(axes, 'layered cantilever, deflection')
    axes.legend()


def draw_iterations(axes, data):
    for conforming in (False, True):
        found = [c for c in data['ball']['curves'] if c['conforming'] == conforming]
        axes.plot([c['contrast'] for c in found], [finest(c)['iterations'] for c in found], **curve(conforming),
                  label=mesh_name(conforming))
    axes.set(xscale='log', title='ball, finest meshes', xlabel='contrast', ylabel='iterations', ylim=(0, None))
    axes.legend()


def draw_all(data, draw):
    with draw.panels('errors', 4, width=3.9, height=4) as (strain, displacement, layers, iterations):
        draw_ball(strain, data, 'error', 'ball, mean strain in it')
        draw_ball(displacement, data, 'displacement', 'ball, L² of displacement')
        plain_numbers(displacement.yaxis)
        draw_layers(layers, data)
        draw_iterations(iterations, data)


def solver(point):
    return 'factorised' if point['iterations'] == 0 else 'gave up' if point['gave_up'] else 'iterated'


def row(found, what, mesh):
    fine = finest(found)
    shown = {**fine, 'what': what, 'mesh': mesh, 'contrast': power(found['contrast']), 'solver': solver(fine),
             'off': f"{100 * fine['error']:+.1f}", 'order': f"{order(found['points']):.1f}",
             'norm': '–', 'norm_order': '–'}
    if what != 'ball':
        return shown
    if found['contrast'] == 1:
        return {**shown, 'off': '0', 'order': '–', 'norm': '0'}
    return {**shown, 'norm': f"{100 * fine['displacement']:.2f}",
            'norm_order': f"{order(found['points'], 'displacement'):.1f}"}


def rows(data):
    return [row(found, 'ball', mesh_name(found['conforming'])) for found in data['ball']['curves']] + \
           [row(found, found['beam'], 'grid') for found in data['layers']['curves']]


def needed(points, across, key='error'):
    """For each of ERRORS, how many elements across what is asked about, and the time."""
    cells = [{**point, 'across': across(point)} for point in points]
    found = []
    for error in ERRORS:
        number, ms = (at_error(cells, error, key, value) for value in ('across', 'ms'))
        found.append(f'{number:.1f}, {ms:.0f} ms' if number else f"more than {cells[-1]['across']:.0f}")
    return found


def choices(data):
    def per_radius(point):
        return point['cells'] * data['ball']['radius'] / 2

    asked = [{'what': f'strain in a {kind} ball, {mesh_name(conforming)}',
              'cells': needed(balls(data, conforming, [contrast])[0]['points'], per_radius)}
             for kind, contrast in zip(('stiff', 'soft'), EXTREMES) for conforming in (False, True)]
    return asked + [{'what': f'deflection, {name}, contrast {power(contrast)}',
                     'cells': needed(beams(data, name, [contrast])[0]['points'], lambda point: point['stiff_cells'])}
                    for name in LAYERS for contrast in (1, 1e4)]


def small_loads(data):
    """By which share what a solver finds is off from the direct one's under the largest load, a row for each load."""
    beams_bent = data['layers']['small_loads']
    found = []
    for k, point in enumerate(beams_bent[0]['points'][:-1]):
        cells = [f"{100 * (of['points'][k][way] / of['points'][-1]['direct'] - 1):+.2f} %"
                 for of in beams_bent for way in ('direct', 'iterative')]
        found.append({'deflection': power(point['deflection']),
                      'cells': [cell.replace('-', '−').replace('+0.00', '0').replace('−0.00', '0') for cell in cells]})
    return found


def exact_rows(data):
    names = {'rod': 'rod of two parts in series', 'patch': 'patch across an interface'}
    bodies = {problem: [of for of in data['exact']['bodies'] if of['problem'] == problem] for problem in names}
    return [{'what': name, 'cells': [f'{max(body[way] for body in bodies[problem]):.0e}'
                                     for way in ('direct', 'iterative')]} for problem, name in names.items()]


def growth(curves, key, start, end):
    """By how many per cent the error on the finest mesh grows from one contrast to another."""
    at = {found['contrast']: finest(found)[key] for found in curves}
    return 100 * (at[end] / at[start] - 1)


def cost(data):
    """What contrast does to errors and solvers."""
    points = [point for found in data['layers']['curves'] for point in found['points']]
    iterated = [point for point in points if solver(point) == 'iterated']
    solvers = data['ball']['solvers'] + [found['solvers'] for found in data['layers']['curves']]

    return {'more': {'stiff': max(more_iterations(data, 1e4)), 'soft': max(more_iterations(data, 1e-4))},
            'grown': {'ball': max(growth(balls(data, on), 'displacement', *ends)
                                  for on in (False, True) for ends in ((100, 1e4), (0.01, 1e-4))),
                      'beams': max(growth(beams(data, name), 'error', 100, 1e4) for name in LAYERS)},
            'points': len(points), 'gave_up': sum(point['gave_up'] for point in points),
            'factorised': sum(solver(point) == 'factorised' for point in points), 'iterated': len(iterated),
            'iterated_up_to': max((point['freedoms'] for point in iterated), default=None),
            'apart': max(map(apart, solvers))}


def stairs(data, contrast):
    """What the staircase adds to the error of the strain on the finest mesh [%]."""
    grid, gmsh = (finest(balls(data, on, [contrast])[0]) for on in (False, True))
    return 100 * (grid['error'] - gmsh['error'])


def fields(data, draw):
    draw_all(data, draw)
    constant = [finest(found)['error'] * finest(found)['stiff_cells'] ** 2 for found in beams(data, None, [1, 1e4])]
    finest_ball = finest(balls(data, True)[0])
    return {**cost(data), 'rows': rows(data), 'choices': choices(data), 'exact': exact_rows(data),
            'small_loads': small_loads(data),
            'small_columns': [f"contrast {power(of['contrast'])}, {of['cells']} cells, {way}"
                              for of in data['layers']['small_loads'] for way in ('direct', 'iterative')],
            'stairs': {'stiff': stairs(data, 1e4), 'soft': stairs(data, 1e-4)},
            'radius_cells': data['ball']['radius'] * finest_ball['cells'] / 2,
            'shear': span([100 * found['shear'] for found in data['layers']['curves']]),
            'constant': span(constant), 'across': [math.sqrt(sum(constant) / len(constant) / e) for e in ERRORS]}
