"""Curves of a crack's errors: by which code and how, over the elements' edge."""

import math

QUANTITIES = ('K_I', 'K_II', 'K_III', 'G')

def ways(problem):
    """(what it is called, its curve, the key of its errors) of each way, first as it is cut and nothing else."""
    found = []
    for curve in problem['curves']:
        if not curve['points']:
            continue
        if curve['code'] == 'GetFEM':
            found.append(('GetFEM, singular functions' if curve['singular'] else 'GetFEM, jump alone', curve, 'error'))
        elif curve['longer']:
            found.append(('incision, cut longer', curve, 'error'))
        else:
            found += [('incision', curve, 'error'), ('incision, front where it acts', curve, 'acting')]
    return found


def asked(problem):
    """The quantities that have an answer other than zero."""
    answers = problem['answers']
    return [name for name in QUANTITIES if abs(answers.get(name, 0)) > 1e-9 * answers['K_I']]


def errors(curve, quantity, key='error'):
    """From coarse to fine; none where this way does not tell."""
    return [p[quantity][key] for p in curve['points'] if key in p.get(quantity, ())]


def order(curve, quantity, key='error'):
    """The slope of log |error| over log edge, from the coarsest to the finest mesh; None with one mesh alone."""
    found = errors(curve, quantity, key)
    coarse, fine = curve['points'][0], curve['points'][-1]
    if coarse is fine:
        return None
    return math.log(abs(found[0] / found[-1])) / math.log(coarse['edge'] / fine['edge'])


def series(data):
    """Each problem, quantity and way with its errors."""
    return [(problem, quantity, *way) for problem in data['problems'] for quantity in asked(problem)
            for way in ways(problem) if errors(way[1], quantity, way[2])]
