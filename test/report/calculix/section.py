"""CalculiX as an independent check of the references and of the elements."""

import numpy as np

from plots import curve


def draw_references(axes, found):
    rows = np.arange(len(found))[::-1]
    for k, (key, name) in enumerate((('coarse', 'coarse mesh'), ('fine', 'fine mesh'), ('limit', 'extrapolated'))):
        apart = [100 * abs(f[key] / f['answer'] - 1) for f in found]
        axes.plot(apart, rows, label=name, **{**curve(k), 'linestyle': ''})
    axes.set(xscale='log', xlabel='difference from the answer [%]', title='quadratic elements')
    axes.set_yticks(rows, [f['name'].replace(', ', ',\n', 1) for f in found], fontsize=7)
    axes.xaxis.set_major_formatter('{x:g}')
    axes.legend()


def draw_locking(axes, found):
    places = np.arange(len(found['poisson']))
    reference = np.array(found['quadratic'])
    axes.plot(places, np.array(found['coarse']) / reference, label='quadratic bricks, half as many across', **curve(0))
    for k, tets in enumerate(reversed(found['tetrahedra'])):
        axes.plot(places, np.array(tets['deflection']) / reference,
                  label=f'linear tetrahedra, {tets["cells"]} cells across', **curve(k + 1))
    axes.set_xticks(places, [f'{nu:g}' for nu in found['poisson']])
    axes.set(xlabel='Poisson\'s ratio ν', ylabel='deflection / that of quadratic bricks', ylim=(0, 1.1),
             title='cantilever, nearly incompressible')
    axes.legend(loc='lower left')


def off(values, references):
    """Largest relative difference."""
    return abs(np.array(values) / np.array(references) - 1).max()


def fields(data, draw):
    found, locking, bar = data['references'], data['locking'], data['frequencies']
    with draw.panels('checks', 2, width=6) as (references, locked):
        draw_references(references, found)
        draw_locking(locked, locking)
    off_limit = [f['limit'] / f['answer'] - 1 for f in found]
    stiff = locking['tetrahedra'][-1]
    rows = [('CalculiX, quadratic bricks', locking['quadratic'])]
    rows += [(f'incision, {tets["cells"]} cells across', tets['deflection']) for tets in locking['tetrahedra']]
    return {'bar': bar, 'cells': ' × '.join(str(n) for n in bar['cells']),
            'apart': off(bar['at_one_point'], bar['calculix'][0]), 'mass': off(bar['lumped'], bar['consistent']),
            'beam': off(bar['quadratic'][:2], bar['beam']),
            'worst': max(abs(o) for o, f in zip(off_limit, found) if 'crack' not in f['name']),
            'penny': sorted(100 * o for o, f in zip(off_limit, found) if 'penny' in f['name']),
            'rows': [{**f, 'off': 100 * o} for o, f in zip(off_limit, found)], 'stiff': stiff,
            'lost': [1 - d / q for d, q in zip(stiff['deflection'], locking['quadratic'])],
            'refined': off(locking['coarse'], locking['quadratic']),
            'deflections': [{'name': name, 'micrometres': [1e6 * d for d in values]} for name, values in rows]}
