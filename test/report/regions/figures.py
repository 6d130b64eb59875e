"""Curves of errors over meshes of many sizes, by contrast."""

import math

from static.figures import order  # noqa: F401  (the slope over the finest four)

LAYERS = ('two layers', 'three layers')


def balls(data, conforming, contrasts=None):
    """Curves of the ball on grids or on Gmsh's meshes, without that of contrast 1, which has no error to show."""
    return [curve for curve in data['ball']['curves'] if curve['conforming'] == conforming and
            (curve['contrast'] != 1 if contrasts is None else curve['contrast'] in contrasts)]


def beams(data, name=None, contrasts=None):
    return [curve for curve in data['layers']['curves'] if name in (None, curve['beam']) and
            (contrasts is None or curve['contrast'] in contrasts)]


def finest(curve):
    return curve['points'][-1]


def limit(curve):
    """The error at edge 0, by the straight line through the finest two over the square of the edge."""
    a, b = ((p['edge'] ** 2, p['error']) for p in curve['points'][-2:])
    return b[1] - b[0] * (a[1] - b[1]) / (a[0] - b[0])


def at_error(points, error, key, value):
    """The value that this |error| takes, on the straight line between logarithms of the two meshes beside it. None: the
    finest mesh has a larger error."""
    for coarse, fine in zip(points, points[1:]):
        high, low = abs(coarse[key]), abs(fine[key])
        if high >= error >= low:
            share = math.log(high / error) / math.log(high / low)
            return coarse[value] ** (1 - share) * fine[value] ** share
    return points[0][value] if abs(points[0][key]) <= error else None


def more_iterations(data, contrast):
    """By how many times a ball takes more iterations than one like its matrix, on each mesh that both are iterated on."""
    pairs = [pair for on in (False, True) for pair in zip(*(balls(data, on, [c])[0]['points'] for c in (contrast, 1)))]
    return [point['iterations'] / same['iterations'] for point, same in pairs
            if point['iterations'] and same['iterations']]


def apart(solvers):
    """By which share the two solvers' answers differ."""
    return abs(solvers['iterative'] / solvers['direct'] - 1)


def rounding(data, contrast):
    """ε times the condition of a rod's matrix, some (cells along)² times the contrast where the stiff part is the far
    one."""
    return 2 ** -52 * data['exact']['cells'] ** 2 * max(1, contrast)
