"""Locking in nearly incompressible tissue, and what it takes to be rid of it."""

import math

from matplotlib.ticker import FuncFormatter, LogLocator
from plots import curve, table

TITLE = 'Nearly incompressible tissue: locking, and averaged pressure'

ASKED = {'cantilever': 'deflection of a cantilever', 'held block': 'force on a held block',
         'pressed block': 'depth in a pressed block'}

# Of the panels of errors by ν and by time: key, name, which curve.
BY_RATIO = (('plain', 'elements, grid', 1), ('plain unstructured', 'elements, unstructured', 3),
            ('averaged', 'averaged, grid', 0), ('averaged unstructured', 'averaged, unstructured', 2))


def percent(value, digits=0):
    return f'{100 * value:.{digits}f} %' if abs(value) < 10 else f'×{1 + value:.0f}'


def name_of(ratio):
    return f'{ratio:g}'


def plain_numbers(axis):
    """Labels 20, 50, 100 on a logarithmic axis."""
    axis.set_major_locator(LogLocator(subs=(1, 2, 5)))
    axis.set_major_formatter(FuncFormatter(lambda value, _: f'{value:g}'))
    axis.set_minor_formatter(FuncFormatter(lambda *_: ''))


def number_of(by_ratio, ratio):
    return min(range(len(by_ratio)), key=lambda k: abs(by_ratio[k] - ratio))


def along_ratios(axes, ratios):
    axes.set_xticks(range(len(ratios)), [name_of(r) for r in ratios])
    axes.set_xlabel("Poisson's ratio")


def draw_errors(errors, draw):
    with draw.panels('errors', 3) as panels:
        for axes, of in zip(panels, errors):
            for key, name, k in BY_RATIO:
                axes.semilogy(range(len(of['ratios'])), [100 * abs(e) for e in of[key]], label=name, **curve(k))
            along_ratios(axes, of['ratios'])
            if max(map(abs, of['plain'])) < 10:
                plain_numbers(axes.yaxis)
            axes.set_ylabel('error [%]')
            axes.set_title(f"{ASKED[of['problem']]}, {of['elements']:,} elements", fontsize=9)
        panels[0].legend()
    return draw.picture('errors', 'Error against Poisson\'s ratio on three problems')


def draw_times(times, data, draw):
    """One row of panels for each problem."""
    names = {'plain': 'elements', 'capped': f"elements, ν = {data['capped']:g}", 'averaged': 'averaged',
             'moderate': f"averaged, ν = {data['moderate']:g}"}
    pictures = []
    for problem in dict.fromkeys(of['problem'] for of in times):
        shown = [of for of in times if of['problem'] == problem]
        name = f"times_{problem.replace(' ', '_')}"
        with draw.panels(name, len(shown)) as panels:
            for axes, of in zip(panels, shown):
                for (key, label), k in zip(names.items(), (1, 3, 0, 2)):
                    if key in of:
                        axes.loglog([p['ms'] for p in of[key]], [100 * abs(p['error']) for p in of[key]], label=label,
                                    **curve(k))
                plain_numbers(axes.yaxis)
                axes.set_xlabel('time of a step [ms]')
                axes.set_ylabel('error [%]')
                axes.set_title(f"{ASKED[problem]}, tissue of ν = {of['ratio']:g}", fontsize=9)
                axes.legend()
        pictures.append(draw.picture(name, f'Error of the {ASKED[problem]} against the time of a step'))
    return '\n\n'.join(pictures)


def draw_solvers(steps, draw):
    ratios = [at['ratio'] for at in steps]
    with draw.panels('solvers', 2) as (iterations, times):
        for key, name, k in (('plain', 'elements', 1), ('averaged', 'averaged', 0)):
            iterations.semilogy(range(len(ratios)), [at[key]['iterations'] for at in steps], label=name, **curve(k))
            times.semilogy(range(len(ratios)), [at[key]['iterative'] for at in steps], label=f'{name}, iterative',
                           **curve(k))
            times.semilogy(range(len(ratios)), [at[key]['direct'] for at in steps], label=f'{name}, direct',
                           **curve(k + 2))
        for axes in (iterations, times):
            along_ratios(axes, ratios)
            plain_numbers(axes.yaxis)
            axes.legend()
        iterations.set_ylabel('iterations a step')
        times.set_ylabel('time of a step [ms]')
    return draw.picture('solvers', 'Iterations and time of a step against Poisson\'s ratio')


def time_at(points, error):
    """Time of a step for this error, between the meshes measured; of the coarsest where that does already."""
    if abs(points[0]['error']) <= error:
        return points[0]['ms']
    for coarse, fine in zip(points, points[1:]):
        high, low = abs(coarse['error']), abs(fine['error'])
        if high >= error >= low:
            share = math.log(high / error) / math.log(high / low)
            return coarse['ms'] ** (1 - share) * fine['ms'] ** share
    return points[-1]['ms']


def milliseconds(value):
    return f'{value:.0f} ms' if value >= 10 else f'{value:.2g} ms'


def gain_table(times):
    """What the least error of plain elements costs, with them and averaged."""
    rows = []
    for of in times:
        best = min(of['plain'], key=lambda point: abs(point['error']))
        rows.append([ASKED[of['problem']], name_of(of['ratio']), percent(abs(best['error'])), milliseconds(best['ms']),
                     milliseconds(time_at(of['averaged'], abs(best['error'])))])
    return table(['asked', 'ν', 'least error of elements', 'a step of theirs', 'averaged, for the same error'], rows)


def model_table(errors, data):
    return table(['asked'] + [f'model of ν = {data[key]:g}' for key in ('capped', 'moderate')] +
                 [f'{name}, ν = {r:g}' for name in ('elements', 'averaged') for r in (0.3, 0.49, 0.4999)],
                 [[ASKED[of['problem']]] + [percent(of['model'][key], 1) for key in ('capped', 'moderate')] +
                  [percent(of[key][number_of(of['ratios'], r)]) for key in ('plain', 'averaged')
                   for r in (0.3, 0.49, 0.4999)] for of in errors])


def nodal_table(times):
    rows = []
    for of in times:
        for nodal, ours in zip(of['nodal'], of['averaged']):
            rows.append([of['problem'], name_of(of['ratio']), f"{nodal['elements']:,}", percent(nodal['error'], 1),
                         percent(ours['error'], 1), f"×{nodal['blocks']:.2f}"])
    return table(['problem', 'ν', 'elements', 'averaged round nodes', 'averaged round edges',
                  'matrix of the first by that of the second'], rows)


def energy_text(share):
    if abs(share) < 1e-9:  # rounding
        return '0'
    return f'{100 * share:.2f} %' if share < 0.01 else f'{100 * share:.0f} %'


def cut_table(cut, jump):
    ratios = [at['ratio'] for at in jump]
    rows = []
    for layers in sorted({at['layers'] for at in cut}):
        for key, name in (('plain', 'elements'), ('averaged', 'averaged')):
            rows.append([f'error of the split beam, {layers:g} cells deep, {name}'] +
                        [percent(at[key]) for at in cut if at['layers'] == layers])
    for figure, name in (('added', 'elastic energy that a cut adds'), ('kinetic', 'kinetic energy a step later')):
        for key, kind in (('plain', 'elements'), ('averaged', 'averaged')):
            rows.append([f'{name}, {kind}'] + [energy_text(at[key][figure]) for at in jump])
    return table([''] + [f'ν = {r:g}' for r in ratios], rows)


def render(data, draw):
    errors, steps = data['errors'], data['solvers']['steps']
    first, last = steps[0], steps[-1]
    moderate = steps[number_of([at['ratio'] for at in steps], data['moderate'])]
    change = max(abs(known['change']) for known in data['references'].values())
    return f'''A linear tetrahedron has one volume for itself, and a mesh has five or six times as many elements as
nodes: where volume must stay, hardly any motion is left. With `body.pressure: averaged` the pressure comes from the
mean volume change of a patch of elements round an edge, some six each; on a grid these are its cells. What hangs
together of a patch averages by itself: a crack through it makes two of it.

Three boxes under small loads: a cantilever 1 × 0.25 × 0.25 m bent by a shear on its end; a block 1 × 1 × 0.5 m pressed
between two plates that it sticks to; the same block on a plate, pressed on a quarter of its top. What is asked is the
deflection, the force of the plate and the mean depth. References: CalculiX on quadratic bricks with reduced
integration, refined towards edges ({percent(change, 1)} at most from those of two thirds as many bricks a side).

{draw_errors(errors, draw)}

The same in figures, and before them what a lower ν in the model makes of tissue of 0.4999, on the reference's mesh:

{model_table(errors, data)}

- **Plain elements lock**, and well before 0.5: at ν = {data['capped']:g}, the default, they are worse than at 0.3, and
  at 0.4999 their answer says nothing about the tissue.
- **Averaged, the error hardly depends on ν** on grids, and grows mildly on unstructured meshes, whose patches are less
  even. It is below that of plain elements on the same mesh at every ν.
- **A lower ν instead** makes a fair model where tissue bends and nothing confines it, and too soft a one where it is
  confined; of {data['moderate']:g} it is a fair one everywhere. Plain elements lock on top of that. As the one is too soft
  and the other too stiff, they can hide each other on one mesh, and part again on a finer one.

{draw_times(data['times'], data, draw)}

Time of a step of the same body in motion, warped (Δt = 0.01 s, iterative, default tolerance, 2 threads), and error of
the same mesh at rest, over finer and finer grids. What the finest grid of plain elements reaches, averaged pressure has
from a coarser one:

{gain_table(data['times'])}

In tissue of ν = 0.4999, averaged elements of ν = {data['moderate']:g} are about as true as those of 0.4999, several times
faster.

Cost of a step, on a bar of {data['solvers']['elements']:,} elements:

{draw_solvers(steps, draw)}

Averaging couples more nodes: the matrix has {data['solvers']['blocks']:.2f} times the entries, which a factorisation
feels most. The iteration needs fewer of its steps, {first['averaged']['iterations']:.0f} instead of
{first['plain']['iterations']:.0f} at ν = {first['ratio']:g}, {moderate['averaged']['iterations']:.0f} instead of
{moderate['plain']['iterations']:.0f} at {moderate['ratio']:g} and {last['averaged']['iterations']:.0f} instead of
{last['plain']['iterations']:.0f} at {last['ratio']:g}; with either it needs more the nearer ν comes to 0.5.

The better known remedy averages round every node. Measured on the same meshes, it leaves larger errors and makes the
matrix about twice as large again, so it is not in the package:

{nodal_table(data['times'])}

**Cuts.** The cantilever split along its middle, within the elements, against one of half the depth; and a cut through
the bent cantilever, what it adds to the elastic energy before anything has moved, and what moves a step later:

{cut_table(data['cut'], data['jump'])}

Averaging works in cut elements as in whole ones. But a cut also parts the patches that it goes through, and pressure
jumps there by what their two sides differ in. Up to ν = {data['moderate']:g} that is little, and at 0.4999 much. Implicit
Euler takes it away: a step later no more moves than with plain elements, after which the same cut frees the same load.

What follows:

- `pressure: averaged` wherever ν is 0.4 or more, cut or not: the same error in a fraction of the time.
- ν = {data['moderate']:g} for tissue that keeps its volume. Nearer to 0.5 the model gains little, each step costs more, and
  the stress beside a new cut is not to be trusted for a step. Where the volume itself is asked for, `method: direct` is
  the faster solver of small bodies.
- `pressure: element`, the default, for ν below 0.4, and to compare with other programs, most of which do just that.'''
