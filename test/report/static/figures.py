"""Curves of errors over the elements' edge."""

import math

import numpy as np


def column(points, key):
    return np.array([p[key] for p in points])


def order(points, key='error'):
    """The slope of log |error| over log edge, between the first and the last of the finest four."""
    coarse, fine = points[-4:][0], points[-1]
    return math.log(abs(coarse[key] / fine[key])) / math.log(coarse['edge'] / fine['edge'])


def limit(curve):
    """The error at edge 0, by the straight line through the finest four over the power of the edge that is expected."""
    fine = curve['points'][-4:]
    return np.polyfit(column(fine, 'edge') ** curve['expected_order'], column(fine, 'error'), 1)[1]


def constant(curve):
    """|error| at an edge of 1, by the finest mesh."""
    fine = curve['points'][-1]
    return abs(fine['error']) / fine['edge'] ** curve['expected_order']


def quantities(data):
    """The problem and the quantity of each set of curves."""
    return [(problem['name'], quantity) for problem in data['problems'] for quantity in problem['quantities']]


def curves(data, expected_order=None, **ways):
    """All curves of problems of an order whose `faces`, `longer`, `unstructured` are these."""
    return [curve for _, quantity in quantities(data) for curve in quantity['curves']
            if expected_order in (None, curve['expected_order']) and all(curve[key] == ways[key] for key in ways)]


def missing(data, faces):
    """By how many edges cracks act as if they were shorter, from coarse to fine: a list for each curve."""
    found = ([p['missing_edges'] for p in curve['points'] if 'missing_edges' in p]
             for curve in curves(data, faces=faces, longer=False))
    return [edges for edges in found if edges]


def finest_errors(data, **ways):
    """|error| on the finest mesh of each figure of cracks that end in the body."""
    return [abs(curve['points'][-1]['error']) for curve in curves(data, 1, **ways)]
