"""Static problems with known answers: error against wall time."""

import math

import numpy as np

from plots import curve, plain_numbers
from static.figures import column, finest_errors, limit, missing, order, quantities

WAYS = ('grid, crack on faces', 'grid, crack inside elements', 'grid, inside, made longer',
        'Gmsh, crack on faces', 'Gmsh, crack inside elements', 'Gmsh, inside, made longer')


def kind(found):
    return 'Gmsh' if found['unstructured'] else 'grid'


def label(found):
    return WAYS[3 * found['unstructured'] + (not found['faces']) + found['longer']]


def find(data, problem, name):
    return next(quantity for of, quantity in quantities(data) if (of, quantity['name']) == (problem, name))


def ratio_at_equal_time(top, bottom):
    """Median of the ratio of two curves' errors over the times that both cover; None where they share none."""
    curves = [(np.log(column(c['points'], 'ms')), np.log(abs(column(c['points'], 'error')))) for c in (top, bottom)]
    start, end = max(c[0][0] for c in curves), min(c[0][-1] for c in curves)
    if start >= end:
        return None
    times = np.linspace(start, end, 21)
    logs = [np.interp(times, *zip(*sorted(zip(*c)))) for c in curves]
    return math.exp(np.median(logs[0] - logs[1]))


def inside_over_faces(quantity):
    """The ratio of the error of a crack inside elements to that on faces at equal time, on the grid and Gmsh's mesh."""
    ways = {(c['unstructured'], c['faces']): c for c in quantity['curves'] if not c['longer']}
    return [ratio_at_equal_time(ways[u, False], ways[u, True]) for u in (False, True)]


def log_axes(axes, title, vertical='error [%]'):
    axes.set(xscale='log', yscale='log', title=title, xlabel='wall time [ms]', ylabel=vertical)
    for axis in (axes.xaxis, axes.yaxis):
        low, high = axis.get_view_interval()
        plain_numbers(axis, (1, 2, 5) if high < 100 * low else (1,))


def draw_errors(axes, title, quantity, name=label):
    for found in quantity['curves']:
        axes.plot(column(found['points'], 'ms'), 100 * abs(column(found['points'], 'error')), label=name(found),
                  **curve(WAYS.index(label(found))))
    log_axes(axes, title)


def draw_whole(data, draw):
    with draw.panels('whole', 3) as (bending, cantilever, solvers):
        for k, found in enumerate(data['bending']):
            for norm, name in (('displacement', 'L² of displacement'), ('energy', 'energy norm')):
                bending.plot(column(found['points'], 'ms'), 100 * column(found['points'], norm),
                             label=f'{kind(found)}, {name}', **curve(2 * k + (norm == 'energy')))
        log_axes(bending, 'bar bent to a circle, exact field')
        draw_errors(cantilever, 'cantilever, deflection', find(data, 'cantilever', 'deflection'), kind)
        freedoms = column(data['solvers'], 'freedoms')
        for k, method in enumerate(('direct', 'iterative')):
            solvers.plot(freedoms, column(data['solvers'], method + '_ms'), label=method, **curve(k))
        log_axes(solvers, 'cantilever, one solve', 'wall time [ms]')
        solvers.set_xlabel('freedoms')
        for axes in (bending, cantilever, solvers):
            axes.legend()


def draw_beams(data, draw):
    shown = (('split cantilever', 'deflection'), ('double cantilever beam', 'opening of an arm'),
             ('double cantilever beam', 'energy release rate'))
    with draw.panels('beams', 3) as panels:
        for axes, (problem, quantity) in zip(panels, shown):
            draw_errors(axes, f'{problem}, {quantity}', find(data, problem, quantity))
            axes.title.set_fontsize(9)
        panels[0].legend()


def draw_cracks(data, draw):
    with draw.panels('cracks', 4, width=3.9, height=4) as (*panels, shorter):
        for axes, shown in zip(panels, (('edge crack', 'K_I'), ('penny crack', 'opened volume'),
                                        ('penny crack', 'K_I'))):
            draw_errors(axes, ', '.join(shown), find(data, *shown))
        for found in find(data, 'penny crack', 'opened volume')['curves']:
            shorter.plot(column(found['points'], 'edge'), column(found['points'], 'missing_edges'), label=label(found),
                         **curve(WAYS.index(label(found))))
        shorter.set(title='penny crack acts as if shorter by', xlabel='edge of the elements / radius', ylabel='edges',
                    ylim=(-0.3, 1.5))
        shorter.legend()


def order_row(problem, quantity, found):
    fine = found['points'][-1]
    return {**fine, 'problem': problem, 'quantity': quantity['name'],
            'mesh': label(found) if len(quantity['curves']) > 2 else kind(found),
            'order': '–' if found['longer'] else f'{order(found["points"]):.2f}', 'off': 100 * fine['error'],
            'limit': 100 * limit(found)}


def span(values):
    return [min(values), max(values)]


def fields(data, draw):
    draw_whole(data, draw)
    draw_beams(data, draw)
    draw_cracks(data, draw)
    cut = [(problem, quantity) for problem, quantity in quantities(data) if len(quantity['curves']) > 2]
    points = [p for _, quantity in quantities(data) for found in quantity['curves'] for p in found['points']]
    largest, quicker = data['solvers'][-1], [s for s in data['solvers'] if s['iterative_ms'] < s['direct_ms']]
    beams = (find(data, 'split cantilever', 'deflection'), find(data, 'double cantilever beam', 'opening of an arm'))
    per_cent = {'conforming': finest_errors(data, faces=True), 'plain': finest_errors(data, faces=False, longer=False),
                'longer': finest_errors(data, faces=False, longer=True)}
    return {'largest': largest, 'slower': largest['direct_ms'] / largest['iterative_ms'],
            'quicker': f', which was the faster one from {quicker[0]["freedoms"]} freedoms on' if quicker else '',
            'gave_up': sum(p['gave_up'] for p in points), 'points': len(points),
            'ratios': [{'problem': problem, 'quantity': quantity['name'], 'ratios': inside_over_faces(quantity)}
                       for problem, quantity in cut],
            'beams': span([ratio for beam in beams for ratio in inside_over_faces(beam) if ratio]),
            'on_faces': span(sum(missing(data, True), [])), 'inside': span(sum(missing(data, False), [])),
            **{name: span([100 * error for error in errors]) for name, errors in per_cent.items()},
            'orders': [order_row(problem, quantity, found) for problem, quantity in quantities(data)
                       for found in quantity['curves']]}
