"""Published problems of other codes, with what they get."""

from benchmark.figures import errors, order, series, ways
from plots import curve as style
from plots import plain_numbers

# What code_aster's extended elements get, by its manual of validation.
OTHERS = {('penny', 'K_I'): '0.7 % by the jump; +16.7 and -1.2 % by G-theta', ('inclined penny', 'K_I'): '+4.5 %',
          ('inclined penny', 'K_II'): '-13.4 %', ('inclined penny', 'K_III'): '-9.4 %', ('lens', 'K_I'): '+0.3 %',
          ('lens', 'K_II'): '-3.6 %'}
UNITS = {'G': (1, 'J/m²'), **{mode: (1e-6, 'MPa√m') for mode in ('K_I', 'K_II', 'K_III')}}
SHOWN = (('penny', 'K_I'), ('inclined penny', 'K_II'), ('inclined penny', 'K_III'), ('lens', 'K_I'))
NAMES = ('incision', 'incision, front where it acts', 'incision, cut longer', 'GetFEM, jump alone',
         'GetFEM, singular functions')

NEAR = 0.05  # an error


def draw_errors(data, draw):
    with draw.panels('cracks', len(SHOWN), width=3.9, height=4) as panels:
        for axes, (name, quantity) in zip(panels, SHOWN):
            problem = next(p for p in data['problems'] if p['name'] == name)
            for way, of, key in ways(problem):
                axes.plot([p['ms'] for p in of['points']], [100 * abs(e) for e in errors(of, quantity, key)], label=way,
                          **style(NAMES.index(way)))
            axes.set(xscale='log', yscale='log', title=f'{name}, {quantity}', xlabel='wall time [ms]',
                     ylabel='error [%]')
            plain_numbers(axes.xaxis, (1,))
            plain_numbers(axes.yaxis, (1, 2, 5))
        panels[-1].legend(*panels[0].get_legend_handles_labels(), loc='lower left')


def published(data):
    """For each answer, the errors of incision on its finest mesh beside those of code_aster."""
    rows = []
    for problem, quantity, way, of, key in series(data):
        if way == 'incision':
            factor, unit = UNITS[quantity]
            rows.append({'problem': problem['name'], 'number': problem['published'], 'quantity': quantity,
                         'answer': f'{factor * problem["answers"][quantity]:.4g} {unit}', 'found': {},
                         'theirs': OTHERS.get((problem['name'], quantity))})
        if way.startswith('incision'):
            rows[-1]['found'][way] = f'{100 * errors(of, quantity, key)[-1]:+.1f} %'
    for row in rows:
        row['ours'] = [row['found'].get(way) for way in NAMES[:3]]
    return rows


def convergence(data):
    rows = []
    for problem, quantity, way, of, key in series(data):
        fine = of['points'][-1]
        found = errors(of, quantity, key)
        grows = quantity == 'G'
        rows.append({'problem': problem['name'], 'quantity': quantity, 'way': way,
                     'errors': ', '.join(f'{100 * e:+.1f}' for e in found),
                     'order': order(of, quantity, key), 'edge': fine['edge'], 'freedoms': fine['freedoms'],
                     'ms': fine[quantity]['ms'] if grows else fine['ms'],
                     'worst': f'{100 * fine[quantity]["worst"]:.0f}' if key == 'error' and not grows else None})
    return rows


def uneven(data):
    """Where a finer mesh is farther off than a coarser one by more than a percent of the answer."""
    found = []
    for problem, quantity, way, of, key in series(data):
        off = [abs(e) for e in errors(of, quantity, key)]
        if any(fine > coarse + 0.01 for coarse, fine in zip(off, off[1:])):
            found.append({'what': f'{problem["name"]}, {quantity}, {way}'})
    return found or [{'what': 'nothing'}]


def worst(data, name):
    """Least and largest |error| [%] of K on the finest mesh, by one way."""
    found = [100 * abs(errors(of, quantity, key)[-1]) for _, quantity, way, of, key in series(data)
             if way == name and quantity != 'G']
    return [min(found), max(found)]


def beside(problem):
    """All ways on the finest grid that they share, and its cells; and the least time of any grid that is NEAR."""
    shared = set.intersection(*({p['cells'] for p in of['points']} for _, of, _ in ways(problem)))
    cells = max(shared, default=None)
    rows = []
    for way, of, key in ways(problem):
        near = [p['ms'] for p in of['points'] if abs(p['K_I'][key]) < NEAR]
        rows += [{**p, 'way': way, 'error': 100 * p['K_I'][key], 'near': f'{min(near):.0f}' if near else None}
                 for p in of['points'] if p['cells'] == cells]
    return cells, rows


def fields(data, draw):
    draw_errors(data, draw)
    problems = {problem['name']: problem for problem in data['problems']}
    plain = {name: problem['curves'][0]['points'] for name, problem in problems.items()}
    failed = [f'{cells} cells ({problem["name"]})' for problem in data['problems'] for of in problem['curves']
              for cells in of.get('failed', ())]
    missing = [p['missing_edges'] for points in plain.values() for p in points[1:]]
    cells, rows = beside(problems['penny'])
    return {'published': published(data), 'convergence': convergence(data), 'uneven': uneven(data),
            'failed': ', '.join(failed) or 'none', 'missing': [min(missing), max(missing)],
            'plain': worst(data, NAMES[0]), 'acting': worst(data, NAMES[1])[1], 'longer': worst(data, NAMES[2])[1],
            'cells': cells, 'beside': rows, 'near': 100 * NEAR,
            'far': 100 * (plain['penny'][-1]['K_I']['acting'] - data['uniform']['K_I']['acting']),
            'edges': [plain['penny'][0]['edge'], plain['penny'][-1]['edge']], 'fit': [100 * e for e in data['fit']],
            'sliding': [100 * abs(p['K_II']['error']) for p in (plain['penny'][0], plain['penny'][-1])],
            'turning': 100 * plain['lens'][-1]['K_III']['worst'], 'start': data['start'], 'end': data['end'],
            'rays': data['rays']}
