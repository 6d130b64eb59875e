"""Curves of errors over elements and steps."""

import math

WANTED = (0.1, 0.03, 0.01)  # errors of the table of choices


def curves(data):
    return [(problem, curve) for problem in data['problems'] for curve in problem['curves']]


def find(data, name, curve):
    return next(c['points'] for p, c in curves(data) if (p['name'], c['name']) == (name, curve))


def errors(points):
    return [abs(point['error']) for point in points]


def refined(points):
    """What a curve refines: the number of elements across, or the step."""
    return 'across' if points[0]['across'] != points[-1]['across'] else 'time_step'


def order(points):
    """With which power of the elements' edge, or of the step, the error falls between the last two runs."""
    coarse, fine = points[-2:]
    key = refined(points)
    ratio = coarse['time_step'] / fine['time_step'] if key == 'time_step' else fine['across'] / coarse['across']
    return math.log(abs(coarse['error'] / fine['error'])) / math.log(ratio)


def coarsest(points, wanted):
    """The coarsest run from which on no error is above the wanted one; None where there is none."""
    found = None
    for point in reversed(points):
        if abs(point['error']) > wanted:
            break
        found = point
    return found
