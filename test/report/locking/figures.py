"""Figures over Poisson's ratio."""


def number_of(ratios, ratio):
    return min(range(len(ratios)), key=lambda k: abs(ratios[k] - ratio))


def at_ratio(entries, ratio):
    """Of entries that have a `ratio`."""
    return entries[number_of([at['ratio'] for at in entries], ratio)]
