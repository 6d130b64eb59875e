"""Problems in which bodies touch: error against wall time."""

import numpy as np

from contact.figures import WANTED, coarsest, curves, errors, find, order, refined
from plots import curve
from static.section import log_axes

PANELS = {'rest': ('sphere pressed into a block', 'layer held by friction', 'column of three pieces'),
          'moving': ('block that slides', 'slit bar that beats on itself')}


def draw_errors(axes, problem):
    for k, found in enumerate(problem['curves']):
        axes.plot([p['ms'] for p in found['points']], 100 * np.array(errors(found['points'])), label=found['name'],
                  **curve(k))
    log_axes(axes, f"{problem['name']}, {problem['quantity']}")
    axes.title.set_fontsize(9)
    axes.legend()


def choice(points, wanted):
    """In words: how fine, and in what time."""
    found = coarsest(points, wanted)
    if not found:
        return None
    fine = f"{found['across']} across" if refined(points) == 'across' else f"{1e3 * found['time_step']:g} ms"
    return f"{fine}: {found['ms']:.0f} ms"


def spring_share(point):
    """What the springs of the column's joints give way by, p h/(20 E) each, of ρ g H²/(2E)."""
    height, joints, element = 0.3, (0.107, 0.211), 0.1 / point['across']
    return sum(height - z for z in joints) * element / 20 / (height ** 2 / 2)


def row(problem, found):
    points = found['points']
    return {'problem': f"{problem['name']}, {found['name']}", 'error': points[-1]['error'],
            'order': order(points),
            'chosen': [choice(points, wanted) for wanted in WANTED]}


def fields(data, draw):
    for name, titles in PANELS.items():
        with draw.panels(name, len(titles)) as panels:
            for axes, title in zip(panels, titles):
                draw_errors(axes, next(p for p in data['problems'] if p['name'] == title))
    sphere = find(data, 'sphere pressed into a block', 'graded grid')
    held, held_short = (find(data, 'layer held by friction', f'steps of {step} ms') for step in ('10', '2.5'))
    whole, cut = (find(data, 'column of three pieces', f'{name}, steps of 10 ms') for name in ('whole', 'cut'))
    direct, iterative = (find(data, 'block that slides', name) for name in ('direct', 'iterative'))
    return {'rows': [row(problem, found) for problem, found in curves(data)],
            'wanted': [f'{100 * wanted:g} %' for wanted in WANTED],
            'unsettled': sum(point['unsettled'] for _, found in curves(data) for point in found['points']),
            'sphere': sphere[-1], **{name: [min(errors(points)), max(errors(points))]
                                     for name, points in (('held', held), ('held_short', held_short))},
            'joints': cut[0]['error'] - whole[0]['error'], 'springs': spring_share(cut[0]), 'coarse': cut[0]['across'],
            'alike': max(abs(a['error'] - b['error']) for a, b in zip(direct, iterative))}
