"""Static problems with known answers: error against wall time."""

import math

import numpy as np
from matplotlib.ticker import LogLocator, NullFormatter
from plots import curve, table

TITLE = 'Static problems: error against time'

WAYS = ('grid, crack on faces', 'grid, crack inside elements', 'grid, inside, made longer',
        'Gmsh, crack on faces', 'Gmsh, crack inside elements', 'Gmsh, inside, made longer')


def kind(found):
    return 'Gmsh' if found['unstructured'] else 'grid'


def label(found):
    return WAYS[3 * found['unstructured'] + (not found['faces']) + found['longer']]


def column(points, key):
    return np.array([abs(p[key]) for p in points])


def find(data, problem, quantity):
    """The quantity of that name, or the first one."""
    problem = next(p for p in data['problems'] if p['name'] == problem)
    return next(q for q in problem['quantities'] if quantity in ('', q['name']))


def ratio_at_equal_time(top, bottom):
    """Median of the ratio of two curves' errors over the times that both cover; None where they share none."""
    curves = [(np.log(column(c['points'], 'ms')), np.log(column(c['points'], 'error'))) for c in (top, bottom)]
    start, end = max(c[0][0] for c in curves), min(c[0][-1] for c in curves)
    if start >= end:
        return None
    times = np.linspace(start, end, 21)
    logs = [np.interp(times, *zip(*sorted(zip(*c)))) for c in curves]
    return math.exp(np.median(logs[0] - logs[1]))


def inside_over_faces(quantity):
    """{kind: ratio} of the error of a crack inside elements to that on faces at equal time."""
    ways = {(c['unstructured'], c['faces']): c for c in quantity['curves'] if not c['longer']}
    return {kind(ways[u, True]): ratio_at_equal_time(ways[u, False], ways[u, True]) for u in (False, True)}


def log_axes(axes, title, vertical='error [%]'):
    axes.set(xscale='log', yscale='log', title=title, xlabel='wall time [ms]', ylabel=vertical)
    for axis in (axes.xaxis, axes.yaxis):
        low, high = axis.get_view_interval()
        axis.set_major_locator(LogLocator(subs=(1, 2, 5) if high < 100 * low else (1,)))
        axis.set_major_formatter('{x:g}')
        axis.set_minor_formatter(NullFormatter())


def draw_errors(axes, title, quantity, name=label):
    for found in quantity['curves']:
        axes.plot(column(found['points'], 'ms'), 100 * column(found['points'], 'error'), label=name(found),
                  **curve(WAYS.index(label(found))))
    log_axes(axes, title)


def draw_whole(data, draw):
    with draw.panels('whole', 3) as (bending, cantilever, solvers):
        for k, found in enumerate(data['bending']):
            for norm, name in (('displacement', 'L² of displacement'), ('energy', 'energy norm')):
                bending.plot(column(found['points'], 'ms'), 100 * column(found['points'], norm),
                             label=f'{kind(found)}, {name}', **curve(2 * k + (norm == 'energy')))
        log_axes(bending, 'bar bent to a circle, exact field')
        bending.legend()
        draw_errors(cantilever, 'cantilever, deflection', find(data, 'cantilever', ''), kind)
        cantilever.legend()
        freedoms = column(data['solvers'], 'freedoms')
        for k, method in enumerate(('direct', 'iterative')):
            solvers.plot(freedoms, column(data['solvers'], method + '_ms'), label=method, **curve(k))
        log_axes(solvers, 'cantilever, one solve', 'wall time [ms]')
        solvers.set_xlabel('freedoms')
        solvers.legend()
    return draw.picture('whole', 'Error against time of bodies without a crack, and time of both solvers')


def draw_beams(data, draw):
    shown = (('split cantilever', 'deflection'), ('double cantilever beam', 'opening of an arm'),
             ('double cantilever beam', 'energy release rate'))
    with draw.panels('beams', 3) as panels:
        for axes, (problem, quantity) in zip(panels, shown):
            draw_errors(axes, f'{problem}, {quantity}', find(data, problem, quantity))
            axes.title.set_fontsize(9)
        panels[0].legend()
    return draw.picture('beams', 'Error against time of beams with a crack along their middle')


def draw_cracks(data, draw):
    with draw.panels('cracks', 4, width=3.9, height=4) as (edge, volume, intensity, missing):
        draw_errors(edge, 'edge crack, K_I', find(data, 'edge crack', 'K_I'))
        draw_errors(volume, 'penny crack, opened volume', find(data, 'penny crack', 'opened volume'))
        draw_errors(intensity, 'penny crack, K_I', find(data, 'penny crack', 'K_I'))
        for found in find(data, 'penny crack', 'opened volume')['curves']:
            missing.plot(column(found['points'], 'edge'), column(found['points'], 'missing_edges'), label=label(found),
                         **curve(WAYS.index(label(found))))
        missing.set(title='penny crack acts as if shorter by', xlabel='edge of the elements / radius', ylabel='edges',
                    ylim=(-0.3, 1.5))
        missing.legend()
    return draw.picture('cracks', 'Error against time of cracks that end in the body, and by how much they are short')


def solver_text(data):
    quicker = [s for s in data['solvers'] if s['iterative_ms'] < s['direct_ms']]
    largest = data['solvers'][-1]
    text = (f'At {largest["freedoms"]} freedoms the direct solver takes '
            f'{largest["direct_ms"] / largest["iterative_ms"]:.1f} times as long as the iterative one')
    if quicker:
        text += f', which was the faster one from {quicker[0]["freedoms"]} freedoms on'
    return text + ('. `auto` factorises up to 3000 freedoms without warping, as one factorisation then serves every '
                   'step; all other curves here are by `auto`. ' + gave_up_text(data))


def orders_table(data):
    rows = []
    for problem in data['problems']:
        for quantity in problem['quantities']:
            for found in quantity['curves']:
                fine = found['points'][-1]
                name = label(found) if len(quantity['curves']) > 2 else kind(found)
                rows.append([f'{problem["name"]}, {quantity["name"]}', name,
                             '–' if found['longer'] else f'{found["order"]:.2f}',
                             f'{100 * fine["error"]:+.1f}', f'{fine["freedoms"]}', f'{fine["ms"]:.0f}',
                             f'{fine["meshing_ms"]:.0f}', f'{100 * found["limit"]:+.1f}'])
    return table(['problem', 'mesh', 'order', 'error on the finest [%]', 'freedoms', 'time [ms]', 'meshing [ms]',
                  'error at edge 0 [%]'], rows)


def ratios_table(data):
    rows = []
    for problem in data['problems']:
        for quantity in problem['quantities']:
            if len(quantity['curves']) > 2:
                ratios = inside_over_faces(quantity)
                rows.append([f'{problem["name"]}, {quantity["name"]}',
                             *(f'{r:.2f}' if r else '–' for r in (ratios['grid'], ratios['Gmsh']))])
    return table(['error inside elements / on faces, at equal time', 'grid', 'Gmsh'], rows)


def cracks(data):
    """The curves of all figures of cracks that end in the body."""
    return [(quantity['name'], found) for problem in data['problems'] for quantity in problem['quantities']
            for found in quantity['curves'] if found['expected_order'] == 1]


def span(values, form='.2f'):
    return f'{min(values):{form}} to {max(values):{form}}'


def missing_text(data):
    ends = {True: [], False: []}
    for _, found in cracks(data):
        if not found['longer']:
            ends[found['faces']] += [p['missing_edges'] for p in found['points'] if 'missing_edges' in p]
    plain, longer = ([100 * abs(f['points'][-1]['error']) for _, f in cracks(data)
                      if not f['faces'] and f['longer'] == wanted] for wanted in (False, True))
    conforming = [100 * abs(f['points'][-1]['error']) for _, f in cracks(data) if f['faces']]
    return (f'Where a crack ends in the body it acts as if it were shorter: by {span(ends[True])} of an element\'s '
            f'edge when it lies on faces, by {span(ends[False])} when it goes through elements. So does any crack in '
            'linear elements, which cannot follow the square root at its front; a cut element beside the front, '
            'whose copies the front holds together, adds the rest. Both shrink with the edge, at first order, and '
            'so do the errors of K_I and of the volume: that is why a conforming mesh wins here. The remedy is '
            'simple, as the lack is nearly the same share of an edge everywhere. *Made longer* is the crack inside '
            f'elements, cut 0.8 edges farther: on the finest meshes its errors are {span(longer, ".1f")} % instead '
            f'of {span(plain, ".1f")} %, where those of the conforming meshes are {span(conforming, ".1f")} %. The '
            '0.8 comes from these two cracks, a straight and a round front. Who wants fracture mechanics from a cut '
            'cuts it so much longer, or refines at its front.')


def gave_up_text(data):
    points = [p for problem in data['problems'] for quantity in problem['quantities'] for found in quantity['curves']
              for p in found['points']]
    return (f'At {sum(p["gave_up"] for p in points)} of the {len(points)} points of the curves the iteration, which '
            'works in single precision, gave up and the direct solver took over, which the time includes: without '
            'inertia a slender or loosely held body is stiffer in its cells than as a whole by a factor that single '
            'precision hardly holds.')


def render(data, draw):
    beams = [r for name in ('split cantilever', 'double cantilever beam')
             for r in inside_over_faces(find(data, name, '')).values() if r]
    return '\n\n'.join([
        'Each problem has an answer of its own: Timoshenko\'s beam, or linear elastic fracture mechanics. The load '
        'is small, warping is off, and one long step of an almost massless body is the static answer. The time is '
        'that of the whole job on a mesh in memory, with two threads: topology, the cut, assembly, and one solve to '
        'the default tolerance (two or three for an energy release rate). Making the mesh is not in it. ν = 0, so '
        'that a clamp takes nothing from beam theory and the plate is plane. The answers come from the strain '
        'energy, which under a dead load is half of load times way; its growth with the crack is the energy release '
        'rate. The rates and K_I are means over a growth of the crack, from two cracks in the same mesh, and so are '
        'the answers they are held against. A beam\'s error is that of its stiffness.',
        '### Without a crack', draw_whole(data, draw), solver_text(data),
        '### Cut through elements, or on faces',
        'A crack on faces is what a mesh that conforms to it gives: no element is split. On the grid an odd number of '
        'cells puts the crack inside, an even one on faces. Gmsh made meshes with the crack as an inner surface, and '
        'without.',
        draw_beams(data, draw), draw_cracks(data, draw), ratios_table(data),
        f'Where the crack runs through the body, as in the beams, the cut inside elements has between {min(beams):.2f} '
        f'and {max(beams):.2f} times the error of the conforming mesh at equal time: nothing is lost that a finer mesh '
        'of a few per cent would not bring back, and nothing needs to be meshed again. ' + missing_text(data),
        orders_table(data),
        '*Order*: slope over the finest four meshes; *edge*: cube root of six times the elements\' mean volume, '
        'near the crack. *Error at edge 0*: by the line through the finest four over the power of the edge that '
        'theory gives, 2 for beams and 1 where a crack ends; what is left there is the mesh\'s luck with the front, '
        'the end of the block (one or two per cent, see the next section) and the answer\'s own error (0.5 % for '
        'the edge crack\'s polynomial). On the grid the front of the penny crack is a staircase.'])
