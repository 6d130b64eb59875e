"""The static section's problems and their answers, for quadratic elements; and Timoshenko's first frequency."""

import numpy as np

E, L, H, STRESS = 1e6, 1.0, 0.2, 1.0  # [Pa], [m], [m], end traction [Pa]
TENSION, HALF = 1e3, 4.0              # of the cracks [Pa]; half the width of the penny crack's block [m]


def deflection(length, share):
    """Timoshenko's end deflection [m] of a share of the section's height under that share of the load; ν = 0."""
    load, area, inertia = share * STRESS * H ** 2, share * H ** 2, share ** 3 * H ** 4 / 12
    return load * length ** 3 / (3 * E * inertia) + load * length / (10 / 12 * E / 2 * area)


def stress_intensity(a):
    """K_I [Pa√m] of a crack from the edge of a plate of width 1."""
    return (1.12 - 0.231 * a + 10.55 * a ** 2 - 21.72 * a ** 3 + 30.39 * a ** 4) * TENSION * np.sqrt(np.pi * a)


def mean_intensity(short, long):
    """Root of the mean K_I² over the crack's growth."""
    a = np.linspace(short, long, 2001)
    return np.sqrt(np.mean((stress_intensity(a[1:]) ** 2 + stress_intensity(a[:-1]) ** 2) / 2))


def penny_volume(poisson):
    """Opened volume [m³] of a disc of radius 1 m in infinite space."""
    return 16 * (1 - poisson ** 2) * TENSION / (3 * E)


def timoshenko_frequency(width, height, poisson, density):
    """First natural frequency [Hz] of a cantilever of length L that bends over its height; κ as in the report's
    deflections. The root of the determinant of the clamped-free conditions of w and φ."""
    area, inertia = width * height, width * height ** 3 / 12
    shear = 10 * (1 + poisson) / (12 + 11 * poisson) * E / (2 * (1 + poisson)) * area

    def smallest(omega):
        # κGA (w″ − φ′) + ρA ω² w = 0,  EI φ″ + κGA (w′ − φ) + ρI ω² φ = 0,  (w, φ) ~ (1, s) exp(r x)
        a, b, c = density * area * omega ** 2, density * inertia * omega ** 2, E * inertia
        r = np.sqrt(np.roots([c * shear, shear * b + c * a, a * b - a * shear]).astype(complex))
        r = np.concatenate([r, -r])
        s = (shear * r ** 2 + a) / (shear * r)
        end = np.exp(r * L)
        rows = np.array([np.ones(4), s, r * s * end, (r - s) * end])
        return np.linalg.svd(rows / abs(rows).max(axis=1, keepdims=True), compute_uv=False)[-1]

    slender = 1.8751 ** 2 * np.sqrt(E * inertia / (density * area * L ** 4))
    low, high = 0.8 * slender, 1.02 * slender
    for _ in range(12):
        omegas = np.linspace(low, high, 41)
        best = int(np.argmin([smallest(w) for w in omegas]))
        low, high = omegas[max(best - 1, 0)], omegas[min(best + 1, 40)]
    return (low + high) / (4 * np.pi)
