"""Curves of errors over the time step."""

import math


def usable(points):
    return [point for point in points if point['error'] is not None and point['error'] < 10]


def at_step(curve, time_step):
    return next(p for p in curve['points'] if p['time_step'] == time_step)


def order(curve, steps=()):
    """Between these two steps; of the two smallest ones unless told otherwise."""
    coarse, fine = [at_step(curve, step) for step in steps] or curve['points'][-2:]
    return math.log(coarse['error'] / fine['error']) / math.log(coarse['time_step'] / fine['time_step'])


def problem(data, name, young_modulus=1e6):
    """The curves of a bar, by the name of the integrator."""
    found = next(p for p in data['integrators'] if (p['name'], p['young_modulus']) == (name, young_modulus))
    return {curve['name']: curve for curve in found['curves']}
