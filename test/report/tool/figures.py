"""What the traces of a blade say."""

import numpy as np


def resolution(data, cells):
    """The edge resists at eight points an element, so the share of the thickness that it acts on is known to this."""
    return data['block'][1] / cells / 8 / data['block'][2]


def steady(data, trace):
    """How the force goes once the blade is in: mean [N], ripple and largest change in a step by the mean, and work by
    what is cut [J/m²]."""
    depth, force, area = (np.array(trace[key]) for key in ('depth', 'force', 'area'))
    within = depth > data['steady']
    mean = force[within].mean()
    return {'mean': mean, 'ripple': force[within].std() / mean, 'jump': largest_step(force[within]) / mean,
            'work': mean * np.ptp(depth[within]) / np.ptp(area[within])}


def largest_step(values):
    return abs(np.diff(values)).max()


def off_rest(of):
    """Largest relative difference of the opening from those of blocks that were cut to there."""
    at, rest = np.array(of['rest']).T
    return abs(np.interp(at, of['with']['depth'], of['with']['opening']) / rest - 1).max()
