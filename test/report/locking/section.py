"""Locking in nearly incompressible tissue, and what it takes to be rid of it."""

import math

from locking.figures import at_ratio, number_of
from plots import curve, plain_numbers

ASKED = {'cantilever': 'deflection of a cantilever', 'held block': 'force on a held block',
         'pressed block': 'depth in a pressed block'}

# Of the panels of errors by ν: key, name, which curve.
BY_RATIO = (('plain', 'elements, grid', 1), ('plain unstructured', 'elements, unstructured', 3),
            ('averaged', 'averaged, grid', 0), ('averaged unstructured', 'averaged, unstructured', 2))
KINDS = (('plain', 'elements'), ('averaged', 'averaged'))


def percent(value, digits=0):
    return f'{100 * value:.{digits}f} %' if abs(value) < 10 else f'×{1 + value:.0f}'


def energy(share):
    if abs(share) < 1e-9:  # rounding
        return '0'
    return f'{100 * share:.2f} %' if share < 0.01 else f'{100 * share:.0f} %'


def milliseconds(value):
    return f'{value:.0f} ms' if value >= 10 else f'{value:.2g} ms'


def along_ratios(axes, ratios):
    axes.set_xticks(range(len(ratios)), [f'{r:g}' for r in ratios])
    axes.set_xlabel("Poisson's ratio")


def draw_errors(errors, draw):
    with draw.panels('errors', 3) as panels:
        for axes, of in zip(panels, errors):
            for key, name, k in BY_RATIO:
                axes.semilogy(range(len(of['ratios'])), [100 * abs(e) for e in of[key]], label=name, **curve(k))
            along_ratios(axes, of['ratios'])
            if max(map(abs, of['plain'])) < 10:
                plain_numbers(axes.yaxis)
            axes.set_ylabel('error [%]')
            axes.set_title(f"{ASKED[of['problem']]}, {of['elements']:,} elements", fontsize=9)
        panels[0].legend()


def draw_times(problem, data, draw):
    names = {'plain': 'elements', 'capped': f"elements, ν = {data['capped']:g}", 'averaged': 'averaged',
             'moderate': f"averaged, ν = {data['moderate']:g}"}
    shown = [of for of in data['times'] if of['problem'] == problem]
    with draw.panels(f"times_{problem.replace(' ', '_')}", len(shown)) as panels:
        for axes, of in zip(panels, shown):
            for (key, label), k in zip(names.items(), (1, 3, 0, 2)):
                if key in of:
                    axes.loglog([p['ms'] for p in of[key]], [100 * abs(p['error']) for p in of[key]], label=label,
                                **curve(k))
            plain_numbers(axes.yaxis)
            axes.set(xlabel='time of a step [ms]', ylabel='error [%]')
            axes.set_title(f"{ASKED[problem]}, tissue of ν = {of['ratio']:g}", fontsize=9)
            axes.legend()


def draw_solvers(steps, draw):
    ratios = [at['ratio'] for at in steps]
    with draw.panels('solvers', 2) as (iterations, times):
        for key, name, k in (('plain', 'elements', 1), ('averaged', 'averaged', 0)):
            for axes, figure, label, number in ((iterations, 'iterations', name, k),
                                                (times, 'iterative', f'{name}, iterative', k),
                                                (times, 'direct', f'{name}, direct', k + 2)):
                axes.semilogy(range(len(ratios)), [at[key][figure] for at in steps], label=label, **curve(number))
        for axes, label in ((iterations, 'iterations a step'), (times, 'time of a step [ms]')):
            along_ratios(axes, ratios)
            plain_numbers(axes.yaxis)
            axes.set_ylabel(label)
            axes.legend()


def time_at(points, error):
    """Time of a step for this error, between the meshes measured; of the coarsest where that does already."""
    if abs(points[0]['error']) <= error:
        return points[0]['ms']
    for coarse, fine in zip(points, points[1:]):
        high, low = abs(coarse['error']), abs(fine['error'])
        if high >= error >= low:
            share = math.log(high / error) / math.log(high / low)
            return coarse['ms'] ** (1 - share) * fine['ms'] ** share
    return points[-1]['ms']


def gain(of):
    """What the least error of plain elements costs, with them and averaged."""
    best = min(of['plain'], key=lambda point: abs(point['error']))
    return {'asked': ASKED[of['problem']], 'ratio': of['ratio'], 'error': percent(abs(best['error'])),
            'plain': milliseconds(best['ms']), 'averaged': milliseconds(time_at(of['averaged'], abs(best['error'])))}


def model(of):
    return {'asked': ASKED[of['problem']],
            'cells': [percent(of['model'][key], 1) for key in ('capped', 'moderate')] +
                     [percent(of[key][number_of(of['ratios'], r)]) for key, _ in KINDS for r in (0.3, 0.49, 0.4999)]}


def cut_rows(cut, jump):
    rows = [{'name': f'error of the split beam, {layers:g} cells deep, {name}',
             'cells': [percent(at[key]) for at in cut if at['layers'] == layers]}
            for layers in sorted({at['layers'] for at in cut}) for key, name in KINDS]
    return rows + [{'name': f'{name}, {kind}', 'cells': [energy(at[key][figure]) for at in jump]}
                   for figure, name in (('added', 'elastic energy that a cut adds'),
                                        ('kinetic', 'kinetic energy a step later')) for key, kind in KINDS]


def fields(data, draw):
    steps = data['solvers']['steps']
    draw_errors(data['errors'], draw)
    draw_solvers(steps, draw)
    for problem in ('cantilever', 'pressed block'):
        draw_times(problem, data, draw)
    return {'change': percent(data['change'], 1),
            'models': [model(of) for of in data['errors']], 'gains': [gain(of) for of in data['times']],
            'first': steps[0], 'last': steps[-1], 'middle': at_ratio(steps, data['moderate']),
            'nodal': [{'problem': of['problem'], 'ratio': of['ratio'], **nodal, 'nodes': percent(nodal['error'], 1),
                       'edges': percent(ours['error'], 1)}
                      for of in data['times'] for nodal, ours in zip(of['nodal'], of['averaged'])],
            'ratios': [f"ν = {at['ratio']:g}" for at in data['jump']], 'cuts': cut_rows(data['cut'], data['jump'])}
