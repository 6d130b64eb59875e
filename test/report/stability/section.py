"""The matrix of stiff and extreme cases."""

import math

from matplotlib.patches import Rectangle

from plots import curve, table

TITLE = 'Stability on stiff and extreme cases'

METHODS = ('direct', 'iterative')


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
    return f'{100 * row["growth"]:.0f}' if row['growth'] > 1e-6 else '0'


def draw_maps(data, draw):
    rows = {method: [row for row in data['map'] if row['method'] == method] for method in METHODS}
    with draw.panels('map', 2, width=5.2, height=4.6) as axes:
        draw_map(axes[0], rows['direct'], growth_text, lambda row: row['growth'],
                 'energy growth, % of the largest (direct)')
        most = max(row['iterations'] for row in rows['iterative'])
        draw_map(axes[1], rows['iterative'], lambda row: f'{row["iterations"]:.0f}',
                 lambda row: row['iterations'] / most, 'iterations a step (iterative)')
    return draw.picture('map', 'Energy growth and iterations over E and Δt')


def draw_limits(data, draw):
    with draw.panels('limits', 3, width=4.0) as axes:
        for k, ratio in enumerate(sorted({row['ratio'] for row in data['tension']})):
            rows = [row for row in data['tension'] if row['ratio'] == ratio]
            axes[0].loglog([row['number'] for row in rows], [row['growth'] for row in rows], label=f'σ/E = {ratio:g}',
                           **curve(k))
        axes[0].axvline(1 / 3, color='black', linewidth=0.8)
        axes[0].set(xlabel='Δt²σ/(ρL²)', ylabel='sway after 300 steps / first', title='free bar under dead tension')
        axes[0].legend()
        rows = [row for row in data['spin'] if row['E'] == 1e9]
        axes[1].semilogx([row['turn'] for row in rows], [row['left'] for row in rows], label='here', **curve(0))
        axes[1].semilogx([row['turn'] for row in rows], [row['euler'] for row in rows], label='fully implicit Euler',
                         **curve(1))
        axes[1].set(xlabel='turn a step [rad]', ylabel='angular momentum left', ylim=(0, 1.1),
                    title='ten turns of a stiff block')
        axes[1].legend()
        for k, method in enumerate(METHODS):
            rows = [row for row in data['stiff'] if row['method'] == method and row['finite']]
            axes[2].loglog([row['number'] for row in rows], [max(row['drift'], 1e-17) for row in rows], label=method,
                           **curve(k))
        axes[2].set(xlabel='Δt²E/(ρh²)', ylabel='drift of momentum / (mass × speed)', title='stiff free block')
        axes[2].legend()
    return draw.picture('limits', 'Where the steps end: dead tension, spinning, stiffness')


def cases_table(cases):
    rows, group = [], None
    for case in cases:
        if case['group'] != group:
            group = case['group']
            rows.append([f'**{group}**', '', '', '', ''])
        verdict = 'pass' if case['passes'] else 'limit' if case['limit'] else '**fails**'
        rows.append([case['name'], case['reason'], number(case['figure']), number(case['bound']), verdict])
    return table(['case', 'what is asked, and why so much', 'figure', 'at most', ''], rows)


def poisson_table(rows):
    nus = sorted({row['nu'] for row in rows})
    found = {(row['method'], row['nu']): row['iterations'] for row in rows}
    return table(['ν', *(f'{nu:g}' for nu in nus)],
                 [['iterations a step', *(f'{found["iterative", nu]:.0f}' for nu in nus)]])


def thin_table(rows):
    """The least thinness of every kind of element at which all steps could be taken and no energy came."""
    lines = []
    for name in dict.fromkeys(row['name'] for row in rows):
        line = [name]
        for method in METHODS:
            thin = None
            for row in sorted((r for r in rows if r['name'] == name and r['method'] == method),
                              key=lambda r: -r['thinness']):
                if not row['finite'] or row['growth'] > 1e-6:
                    break
                thin = row
            line += [exponent(thin['thinness']), number(thin['drift'])] if thin else ['none', '']
        lines.append(line)
    return table(['elements', 'direct: down to', 'drift there', 'iterative: down to', 'drift there'], lines)


def pieces_table(data):
    gaps = sorted({row['gap'] for row in data['hair']}, reverse=True)
    pieces = {row['gap']: row['pieces'] for row in data['hair']}
    shown = [gap for gap in gaps if gap > 5e-8]
    angles = data['angles']
    return (table(['gap [m]', *(exponent(gap) for gap in shown)], [['pieces', *(str(pieces[gap]) for gap in shown)]]) +
            '\n\n' +
            table(['angle [rad]', *(exponent(row['angle']) for row in angles)],
                  [['in four pieces', *(f'{100 * row["share"]:.0f} %' for row in angles)]]))


def render(data, draw):
    cases = data['cases']
    passed, limits = sum(case['passes'] for case in cases), [c for c in cases if c['limit'] and not c['passes']]
    calm = [row for row in data['map'] if row['growth'] <= 1e-6]
    return f'''{len(cases)} cases, {passed} pass, {len(limits)} are known limits and listed as such. A bound stands beside each
case, with its reason. Residuals are held against a plain program in long double
that assembles the step's equation part by part, with rotations of its own. The figure is the worst piece's residual as
a share of what is asked: the tolerance, or what rounding of the positions does to the forces. Energies count gravity and
contact; momentum is compared with that of the loads. Both methods run every case where the choice matters.
Ranges that no law gives are where this measurement put their edge: the factors 0.1 and 1000 below, crossing planes at
3e-3 rad, thinness of 1e-5, Δt²E/(ρh²) of 1e14.

### Stiffness and step

A bar of 10 × 3 × 3 cells, held at one end and slit, starts to fall. No step fails, from 1e2 to 1e12 Pa and from 1e-5 to
1 s, and {len(calm)} of {len(data["map"])} runs never have more energy than at the start. The others are soft and long-stepped: there the
weight is a dead tension σ that the step takes where it stood at its start. So choose Δt such that a wave √(σ/ρ) passes
less than one element a step, or a tenth of one where E < σ. Where E > 1000 σ any step will do.

{draw_maps(data, draw)}

Iterations are most where the stiffness and the mass count alike; a stiff bar with long steps is calm at once. Near
incompressibility costs iterations, but nothing else (E = 1e5 Pa, Δt = 0.01 s):

{poisson_table(data['poisson'])}

### Where steps end

{draw_limits(data, draw)}

- Dead tension on a free bar turns it to and fro with ω² = 12 σ/(ρL²). That is stable up to ωΔt = 2, so to
  Δt²σ/(ρL²) = 1/3 (line), whatever E is.
- A spinning block keeps its angular momentum far better than fully implicit Euler steps would, and never gains kinetic
  energy. But a step ends on the tangent of the circle: a piece that turns by θ a step is too long by √(1 + θ²) − 1, and its
  elastic energy is that of this stretch. It does not grow further.
- The mass of a free body is lost among the digits of its stiffness as Δt²E/(ρh²) grows. Free pieces that float cannot
  hold are factorised, so no energy comes up to 1e14. The momentum drifts by more and more digits. The
  iteration keeps it to a share of the tolerance that grows with the same number, as long as the body vibrates.

Elements may be thin, down to (free bodies of 1 m, E = 1e5 Pa, Δt = 0.01 s):

{thin_table(data['thin'])}

Planes a hair apart, and planes that cross at a small angle, are one crack where they are nearer than 1e-4 of an edge:

{pieces_table(data)}

### All cases

{cases_table(cases)}'''
