"""Stress intensities from the jumps of displacement behind a crack's front.

Near the front [u] = 8 (1 − ν²)/(E √(2π)) K √r for K_I (across the crack) and K_II (ahead), and 8 (1 + ν)/(E √(2π)) K √r
for K_III (along the front): G. C. Sih, H. Liebowitz, Mathematical Theories of Brittle Fracture, 1968. A jump at a
distance has a next term, so that the fit is [u] = c √r (K + m r), by least squares over places from START to END.
"""

import numpy as np

START, END = 0.2, 0.6  # in radii
MODES = ('K_I', 'K_II', 'K_III')
AXES = {'K_I': 1, 'K_II': 0, 'K_III': 2}  # of a jump: ahead, across, along the front


def fit(distances, profiles, shift=0):
    """K of profiles [u] / c in columns, the front being `shift` [m] behind; and the sum of squares that is left."""
    root = np.sqrt(distances - shift)
    terms = np.stack([root, root * (distances - shift)], axis=1)
    found = np.linalg.lstsq(terms, profiles, rcond=None)[0]
    return found[0], ((terms @ found - profiles) ** 2).sum()


def acting_shift(distances, profile, radius):
    """How far behind the front as it was cut one lies with which the fit is best [m]."""
    tried = radius * np.linspace(-0.15, 0.99 * START, 401)
    return tried[np.argmin([fit(distances, profile, shift)[1] for shift in tried])]


class Front:
    """The front of a problem as the program report_benchmark describes it, and where its rays have places."""

    def __init__(self, problem, rays, length, places):
        self.problem = problem
        self.angles = 2 * np.pi * np.arange(rays) / rays
        distances = length * problem['radius'] * (np.arange(places) + 0.5) / places
        self.used = (distances > START * problem['radius']) & (distances < END * problem['radius'])
        self.distances = distances[self.used]

    def along(self, mode):
        """The answer along the front, as a share of its largest."""
        if mode == 'K_I' or not self.problem['sheared']:
            return np.ones_like(self.angles)
        return np.cos(self.angles) if mode == 'K_II' else np.sin(self.angles)

    def scale(self, mode):
        """What errors are shares of: the answer, or that of K_I where it is zero."""
        answers = self.problem['answers']
        return answers[mode] if abs(answers[mode]) > 1e-9 * answers['K_I'] else answers['K_I']

    def errors(self, jumps):
        """Of jumps [m] by ray, place and axis: for each mode the error of K along the whole front, from the front as it
        was cut and from where it acts, and by how much a single ray is off at worst; and the front's shift [m]."""
        jumps = np.array(jumps)[:, self.used]
        nu = self.problem['poisson_ratio']
        normal = 8 * (1 - nu ** 2) / self.problem['young_modulus'] / np.sqrt(2 * np.pi)
        c = {'K_I': normal, 'K_II': normal, 'K_III': normal / (1 - nu)}
        rays = {mode: jumps[:, :, AXES[mode]].T / c[mode] for mode in MODES}
        means = {mode: rays[mode] @ self.along(mode) / (self.along(mode) ** 2).sum() for mode in MODES}
        shift = acting_shift(self.distances, means['K_I'], self.problem['radius'])
        found = {'shift': shift}
        for mode in MODES:
            answer, scale = self.problem['answers'][mode], self.scale(mode)
            of_rays = fit(self.distances, rays[mode])[0]
            found[mode] = {'error': (fit(self.distances, means[mode])[0] - answer) / scale,
                           'acting': (fit(self.distances, means[mode], shift)[0] - answer) / scale,
                           'worst': abs(of_rays - answer * self.along(mode)).max() / abs(scale)}
        return found


def errors_of_fit():
    """What the fit makes of the exact opening of a disc: errors of K from the front as cut, and from where it acts."""
    distances = np.linspace(START, END, 101)[1:-1]
    opening = np.sqrt(distances * (2 - distances)) / np.sqrt(2)  # over that of K = 1
    return [fit(distances, opening)[0] - 1,
            fit(distances, opening, acting_shift(distances, opening, 1))[0] - 1]
