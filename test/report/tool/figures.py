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


# What others have published. Of DiSECt's runs in LS-DYNA at 50 mm/s: the potato's plateau, the cucumber's force at a time
# and then up to another, each give or take TOLERANCE [N]; and the mean of the last five forces of the potato that the
# data set's notebook prints, of 1.0956 s to 1.1 s.
POTATO_PLATEAU, POTATO_LAST, CUCUMBER_FIRST, CUCUMBER_PLATEAU, TOLERANCE = 50, 56.7, (0.6, 42), 55, 5
CUCUMBER_FROM, CUCUMBER_TO = 0.7, 1.0  # of its plateau [s]


def by_time(run):
    """Times [s] since the knife set out, and the force then [N]."""
    return run['met'] + np.array(run['depth']) / run['speed'], np.array(run['force'])


def force_at(run, time):
    return float(np.interp(time, *by_time(run)))


def plateau(run, first, last):
    """The least, the mean and the most of the force [N] between two depths [m]."""
    depth, force = np.array(run['depth']), np.array(run['force'])
    within = force[(depth >= first) & (depth <= last)]
    return within.min(), within.mean(), within.max()


def potato_plateau(run):
    """From where the knife is an eighth of the way in."""
    return plateau(run, max(run['depth']) / 8, np.inf)


def cucumber_plateau(run):
    """In the depths that the knife passes at 50 mm/s between the times of the plateau, whatever its speed here."""
    first, last = ((time - run['met']) * run['speed'] for time in (CUCUMBER_FROM, CUCUMBER_TO))
    return plateau(run, first, last)


def spread(runs):
    """The largest difference of the force of runs at equal depth, by the largest force."""
    forces = np.array([run['force'] for run in runs])
    return float(np.ptp(forces, axis=0).max() / forces.max())


def entering(run):
    """Of a blade that indents before it cuts: the depth at which it does [m], the force there and in the end [N], how
    much the force varies between there and the end by its mean, and what of the force there is reached half-way."""
    depth, force, area = (np.array(run[key]) for key in ('depth', 'force', 'area'))
    entered = int(np.argmax(area > 0))
    after = force[depth > depth[entered] + run['cell'] / 2]
    return {'depth': float(depth[entered]), 'first': float(force[entered]), 'steady': float(after.mean()),
            'ripple': float(after.std() / after.mean()),
            'half': float(np.interp(depth[entered] / 2, depth, force) / force[entered]),
            'area_before': float(area[depth < depth[entered] - 1e-9].max())}
