"""How the report shows moving bars: error against run time."""

import math

from dynamic.figures import at_step, problem, usable
from plots import curve

WANTED = (0.1, 0.03, 0.01)  # errors of the table of choices
SPIN = math.hypot(10, 5)  # of the spinning bars [rad/s]


def number(value, digits=2):
    return f'{value:.{digits}g}' if abs(value) < 100 else f'{value:.0f}'


def percent(value):
    if abs(value) < 1e-8:
        return '0 %'  # rounding
    return f'{100 * value:.2g} %' if value < 1 else f'{100 * value:.0f} %'


def growth(value):
    if value is None:
        return '–'
    return percent(value) if value < 10 else f'×{1 + value:.0f}' if value < 1e4 else '> ×1e4'


def modulus(value):
    return f'{value:.0e}'.replace('+0', '')


def name_of(of):
    return f"{of['name']}, E = {modulus(of['young_modulus'])} Pa"


def crossing(points, wanted, key):
    """Where a curve first comes down to the wanted error, interpolated in logarithms; None where it does not."""
    points = usable(points)
    for before, after in zip(points, points[1:]):
        if after['error'] <= wanted < before['error']:
            share = math.log(before['error'] / wanted) / math.log(before['error'] / after['error'])
            return math.exp((1 - share) * math.log(before[key]) + share * math.log(after[key]))
    if points and points[0]['error'] <= wanted:
        return points[0][key]
    return None


def choice(points, wanted):
    step, ms = (crossing(points, wanted, key) for key in ('time_step', 'ms'))
    return None if step is None else f'{number(1e3 * step)} ms: {number(ms)} ms'


def draw_errors(draw, name, shown):
    """Panels side by side of (title, curves)."""
    with draw.panels(name, len(shown)) as panels:
        for axes, (title, curves) in zip(panels, shown):
            for k, one in enumerate(curves):
                points = usable(one['points'])
                axes.loglog([p['ms'] for p in points], [p['error'] for p in points], label=one['name'], **curve(k))
            for p in curves[0]['points']:
                if 'cells' in p:
                    axes.annotate(str(p['cells']), (p['ms'], p['error']), xytext=(4, 6), textcoords='offset points')
            axes.set(title=title, xlabel='wall time [ms per simulated s]', ylabel='error [relative]')
        panels[0].legend()


def draw_oscillation(draw, curves):
    with draw.panels('oscillation', 2) as (amplitude, period):
        for k, one in enumerate(curves):
            shares = [p['step_over_period'] for p in one['points']]
            for kind, label, look in (('measured', one['name'], {'linestyle': 'none'}), ('formula', None, {'marker': ''})):
                found = [p[kind] for p in one['points']]
                style = {**curve(k), **look, 'label': label}
                amplitude.loglog(shares, [max(1e-9, 1 - p['amplitude']) for p in found], **style)
                period.loglog(shares, [p['period'] - 1 for p in found], **style)
        amplitude.set(ylabel='amplitude lost in a period [share]', ylim=(1e-7, 1.5))
        period.set_ylabel('period too long by [share]')
        for axes in (amplitude, period):
            axes.set_xlabel('Δt / period')
            axes.legend()


def draw_all(data, draw):
    spinning = [p['name'] == 'spinning' for p in data['integrators']]
    for name in ('swinging', 'spinning'):
        draw_errors(draw, name, [(name_of(p), p['curves']) for p, spins in zip(data['integrators'], spinning)
                                 if spins == (name == 'spinning')])
    draw_oscillation(draw, data['oscillation'])
    draw_errors(draw, 'solvers', [(p['scheme'], p['curves']) for p in data['solvers']])
    mesh = data['meshes'][0]
    draw_errors(draw, 'meshes', [(f"swinging, against {mesh['finest']} cells across", mesh['curves'])])


def solver_fields(problems):
    curves = {one['name']: sum(p['ms'] for p in one['points']) for of in problems for one in of['curves']}
    loose = curves['iterative, 1e-04']
    return {'saved': percent(1 - loose / curves['iterative, 1e-06']), 'dearer': number(curves['direct'] / loose)}


def fields(data, draw):
    draw_all(data, draw)
    problems = data['integrators']
    at_10_ms = [at_step(one, 0.01) for one in problems[0]['curves'][:3]]
    steps = [p['time_step'] for p in problems[0]['curves'][0]['points']]
    unstretched = problem(data, 'spinning')['implicit Euler']['points'][-1]['error']
    return {'along': 4 * data['cells'], 'reference': 1e3 * data['reference_step'],
            'differ': percent(max(p['references_differ'] for p in problems)),
            'wanted': [percent(wanted) for wanted in WANTED],
            'choices': [{'problem': name_of(p), 'name': one['name'],
                         'chosen': [choice(one['points'], wanted) for wanted in WANTED]}
                        for p in problems for one in p['curves']],
            'errors': [percent(p['error']) for p in at_10_ms], 'iterations': [number(p['iterations']) for p in at_10_ms],
            'steps': [f'{number(1e3 * dt)} ms, {number(SPIN * dt)} rad' for dt in steps],
            'energies': [{'name': f"{modulus(p['young_modulus'])} Pa, {one['name']}",
                          'growth': [growth(at['energy_growth']) for at in one['points']]}
                         for p in problems if p['name'] == 'spinning' for one in p['curves']],
            'unstretched': percent(unstretched), 'spin': number(SPIN),
            'periods': [{'name': one['name'], 'steps': 1 / p['step_over_period'],
                         'lost': percent(1 - p['measured']['amplitude']), 'long': percent(p['measured']['period'] - 1)}
                        for one in data['oscillation'] for p in one['points'] if p['step_over_period'] in (0.05, 0.01)],
            'mesh_step': 1e3 * data['meshes'][0]['time_step'], **solver_fields(data['solvers'])}
