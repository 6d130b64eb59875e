"""The matrix of stiff and extreme cases."""

import math

from matplotlib.patches import Rectangle

from plots import curve

METHODS = ('direct', 'iterative')
CALM = 1e-6  # growth of the energy below which none is seen


def exponent(value):
    power = math.floor(math.log10(value) + 1e-9)
    digits = value / 10 ** power
    return f'1e{power}' if digits < 1.05 else f'{digits:.1f}e{power}'


def number(value):
    if value is None:
        return 'not finite'
    return '0' if value == 0 else f'{value:.3g}'


def draw_map(axes, rows, text, shade, title):
    """One field for each E and Δt: grey by `shade` from 0 to 1, and a text in it."""
    Es, dts = sorted({row['E'] for row in rows}), sorted({row['dt'] for row in rows})
    for row in rows:
        i, j, grey = Es.index(row['E']), dts.index(row['dt']), 1 - 0.75 * shade(row)
        axes.add_patch(Rectangle((j - 0.5, i - 0.5), 1, 1, facecolor=str(grey), edgecolor='white'))
        axes.text(j, i, text(row), ha='center', va='center', fontsize=6.5, color='black' if grey > 0.5 else 'white')
    axes.set(xlim=(-0.5, len(dts) - 0.5), ylim=(-0.5, len(Es) - 0.5), xlabel='Δt [s]', ylabel='E [Pa]', title=title)
    axes.set_xticks(range(len(dts)), [exponent(dt) for dt in dts], rotation=60)
    axes.set_yticks(range(len(Es)), [exponent(E) for E in Es])
    axes.grid(False)


def growth_text(row):
    if not row['finite']:
        return 'fails'
    return f'{100 * row["growth"]:.0f}' if row['growth'] > CALM else '0'


def draw_maps(data, draw):
    direct, iterative = ([row for row in data['map'] if row['method'] == method] for method in METHODS)
    most = max(row['iterations'] for row in iterative)
    with draw.panels('map', 2, width=5.2, height=4.6) as axes:
        draw_map(axes[0], direct, growth_text, lambda row: row['growth'],
                 'energy growth, % of the largest (direct)')
        draw_map(axes[1], iterative, lambda row: f'{row["iterations"]:.0f}', lambda row: row['iterations'] / most,
                 'iterations a step (iterative)')


def contact_map(data):
    return [row for row in data['kinds'] if row['name'] == 'falling']


def rise(row):
    """The largest of the energy, of the whole; what is no number counts as all of it."""
    return 1 if row['rise'] is None else row['rise']


def risen(row):
    """How many powers of ten the largest rise is above what counts as none, of six."""
    return min(1, math.log10(max(rise(row), CALM) / CALM) / 6)


def draw_contact(data, draw):
    rows = contact_map(data)
    most = max(row['solves'][1] for row in rows)
    with draw.panels('contact', 3, width=4.2, height=3.8) as axes:
        draw_map(axes[0], rows, lambda row: f'{rise(row):.0e}' if rise(row) > CALM else '0', risen,
                 'largest rise of the energy, of the whole')
        draw_map(axes[1], rows, lambda row: f'{row["solves"][1]}', lambda row: row['solves'][1] / most,
                 'solves a step, 99 %')
        draw_map(axes[2], rows, lambda row: f'{100 * row["overlap"]:.1f}', lambda row: min(1, row['overlap']),
                 'deepest overlap, % of an element')


def draw_limits(data, draw):
    with draw.panels('limits', 3, width=4.0) as (tension, spin, stiff):
        for k, ratio in enumerate(sorted({row['ratio'] for row in data['tension']})):
            rows = [row for row in data['tension'] if row['ratio'] == ratio]
            tension.loglog([row['number'] for row in rows], [row['growth'] for row in rows], label=f'σ/E = {ratio:g}',
                           **curve(k))
        tension.axvline(1 / 9, color='black', linewidth=0.8)
        tension.set(xlabel='Δt²σ/(ρL²)', ylabel='sway after 300 steps / first', title='free bar under dead tension')
        rows = [row for row in data['spin'] if row['E'] == 1e9]
        for k, (key, label) in enumerate((('left', 'here'), ('euler', 'fully implicit Euler'))):
            spin.semilogx([row['turn'] for row in rows], [row[key] for row in rows], label=label, **curve(k))
        spin.set(xlabel='turn a step [rad]', ylabel='angular momentum left', ylim=(0, 1.1),
                 title='ten turns of a stiff block')
        for k, method in enumerate(METHODS):
            rows = [row for row in data['stiff'] if row['method'] == method and row['finite']]
            stiff.loglog([row['number'] for row in rows], [max(row['drift'], 1e-17) for row in rows], label=method,
                         **curve(k))
        stiff.set(xlabel='Δt²E/(ρh²)', ylabel='drift of momentum / (mass × speed)', title='stiff free block')
        for axes in (tension, spin, stiff):
            axes.legend()


def case_rows(cases):
    rows, group = [], None
    for case in cases:
        if case['group'] != group:
            group = case['group']
            rows.append({'cells': [f'**{group}**', '', '', '', '']})
        verdict = 'pass' if case['passes'] else 'limit' if case['limit'] else '**fails**'
        rows.append({'cells': [case['name'], case['reason'], number(case['figure']), number(case['bound']), verdict]})
    return rows


def thinnest(rows, name, method):
    """Down to where all steps could be taken and no energy came, and the drift there."""
    thin = ['none', '']
    for row in sorted((r for r in rows if (r['name'], r['method']) == (name, method)), key=lambda r: -r['thinness']):
        if not row['finite'] or row['growth'] > CALM:
            break
        thin = [exponent(row['thinness']), number(row['drift'])]
    return thin


def ensemble_rows(ensembles):
    return [{'ensemble': row['name'], 'taken': row['steps'], 'risen': row['rises'], 'rise': number(row['rise']),
             'share': row['unsettled'] / row['steps'], 'solved': row['solves'],
             'deep': row['overlap'], 'drift': number(row['momentum'])}
            for row in ensembles]


def deepest(rows, which):
    """The field with the deepest overlap of those with the shortest, or the longest, steps."""
    dt = which(row['dt'] for row in rows)
    return max((row for row in rows if row['dt'] == dt), key=lambda row: row['overlap'])


def fields_of_contact(data):
    ensembles = {row['name']: row for row in data['ensembles']}
    return {'ensemble_rows': ensemble_rows(data['ensembles']), 'contact': ensembles,
            'contact_steps': sum(row['steps'] for row in data['ensembles']),
            'short': deepest(contact_map(data), min), 'long': deepest(contact_map(data), max),
            'calm_fields': sum(rise(row) <= CALM for row in contact_map(data)),
            'contact_fields': len(contact_map(data))}


def fields(data, draw):
    draw_maps(data, draw)
    draw_limits(data, draw)
    draw_contact(data, draw)
    cases, poisson = data['cases'], [row for row in data['poisson'] if row['method'] == 'iterative']
    pieces = {row['gap']: row['pieces'] for row in data['hair'] if row['gap'] > 5e-8}
    return {'count': len(cases), 'passed': sum(case['passes'] for case in cases),
            'limits': sum(case['limit'] and not case['passes'] for case in cases), 'runs': len(data['map']),
            'calm': sum(row['growth'] <= CALM for row in data['map']),
            'nus': [row['nu'] for row in poisson], 'iterations': [row['iterations'] for row in poisson],
            'thin_rows': [{'name': name, 'cells': [cell for method in METHODS
                                                   for cell in thinnest(data['thin'], name, method)]}
                          for name in dict.fromkeys(row['name'] for row in data['thin'])],
            'gaps': [exponent(gap) for gap in sorted(pieces, reverse=True)],
            'pieces': [pieces[gap] for gap in sorted(pieces, reverse=True)],
            'crossing': [exponent(row['angle']) for row in data['angles']],
            'shares': [row['share'] for row in data['angles']], 'case_rows': case_rows(cases),
            **fields_of_contact(data)}
