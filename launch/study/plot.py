"""A first picture of a study: one column of its table against another."""

import math

from study.errors import InputError, guess

# Numbers above 0 that spread over more than this are drawn on a logarithmic axis.
LOG_SPREAD = 50


def column(rows, name):
    """The cells, as numbers where all are."""
    known = list(dict.fromkeys(key for row in rows for key in row))
    if name not in known:
        raise InputError(f'--plot: {name}: no column of the table{guess(name, known)} (allowed: {", ".join(known)})')
    cells = [row.get(name, '') for row in rows]
    try:
        return [float(cell) if cell != '' else math.nan for cell in cells]
    except ValueError:
        return [str(cell) for cell in cells]


def is_wide(values):
    numbers = [v for v in values if isinstance(v, float) and math.isfinite(v)]
    return bool(numbers) and min(numbers) > 0 and max(numbers) > LOG_SPREAD * min(numbers)


def draw(rows, varied, x, y, path):
    """Points of the runs, coloured by the first key of `varied` that is not on the x axis."""
    try:
        import matplotlib  # takes half a second, and only pictures need it
    except ImportError:
        raise InputError('--plot: matplotlib is not there (allowed: Debian\'s package '
                         'python3-matplotlib installed)') from None
    matplotlib.use('Agg')
    from matplotlib import pyplot

    xs, ys = column(rows, x), column(rows, y)
    figure, axes = pyplot.subplots(figsize=(6.4, 4.8), layout='constrained')
    others = [key for key in varied if key not in (x, y)]
    by = column(rows, others[0]) if others else None
    if by and len(set(by)) <= 10:
        for value in sorted(set(by), key=str if isinstance(by[0], str) else None):
            chosen = [i for i, v in enumerate(by) if v == value]
            axes.plot([xs[i] for i in chosen], [ys[i] for i in chosen], 'o', markersize=4,
                      label=value if isinstance(value, str) else f'{value:g}')
        axes.legend(title=others[0])
    elif by and isinstance(by[0], float):
        figure.colorbar(axes.scatter(xs, ys, c=by, s=16), label=others[0])
    else:
        axes.plot(xs, ys, 'o', markersize=4)
    axes.set(xlabel=x, ylabel=y, xscale='log' if is_wide(xs) else axes.get_xscale(),
             yscale='log' if is_wide(ys) else axes.get_yscale())
    axes.grid(True, alpha=0.3)
    figure.savefig(path, dpi=120)
    pyplot.close(figure)
