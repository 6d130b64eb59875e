"""CalculiX as an independent check of the references and of the elements."""

import numpy as np
from plots import curve, table

TITLE = 'CalculiX: are the references right?'


def draw_references(axes, data):
    found = data['references']
    rows = np.arange(len(found))[::-1]
    for k, (key, name) in enumerate((('coarse', 'coarse mesh'), ('fine', 'fine mesh'), ('limit', 'extrapolated'))):
        apart = [100 * abs(f[key] / f['answer'] - 1) for f in found]
        axes.plot(apart, rows, label=name, **{**curve(k), 'linestyle': ''})
    axes.set(xscale='log', xlabel='difference from the answer [%]', title='quadratic elements')
    axes.set_yticks(rows, [f['name'].replace(', ', ',\n', 1) for f in found], fontsize=7)
    axes.xaxis.set_major_formatter('{x:g}')
    axes.legend()


def draw_locking(axes, data):
    found = data['locking']
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


def same_table(data):
    return table(['mesh', 'elements', 'largest difference / largest displacement'],
                 [[f['mesh'], str(f['elements']), f'{f["difference"]:.1e}'] for f in data['same']])


def references_table(data):
    return table(['problem', 'answer', 'CalculiX, fine mesh', 'extrapolated', 'difference [%]'],
                 [[f'{f["name"]} [{f["unit"]}]', *(f'{f[key]:.5g}' for key in ('answer', 'fine', 'limit')),
                   f'{100 * (f["limit"] / f["answer"] - 1):+.2f}'] for f in data['references']])


def locking_table(data):
    found = data['locking']
    rows = [['CalculiX, quadratic bricks', *(f'{1e6 * d:.2f}' for d in found['quadratic'])]]
    rows += [[f'incision, {tets["cells"]} cells across', *(f'{1e6 * d:.2f}' for d in tets['deflection'])]
             for tets in found['tetrahedra']]
    return table(['deflection [µm] at ν =', *(f'{nu:g}' for nu in found['poisson'])], rows)


def frequencies_text(data):
    bar = data['frequencies']
    apart = abs(bar['at_one_point'] / bar['calculix'][0] - 1)
    beam = [abs(q / b - 1) for q, b in zip(bar['quadratic'], bar['beam'])]
    return (f'A clamped bar of {" × ".join(str(n) for n in bar["cells"])} cells, struck by a sudden load, oscillates '
            f'in incision at {bar["consistent"]:.5f} Hz with consistent mass and at {bar["lumped"]:.5f} Hz with '
            'lumped mass, freed from the known period error of backward Euler. CalculiX finds '
            f'{bar["calculix"][0]:.5f} Hz for the same elements. It integrates their mass at one point; incision\'s '
            f'two masses say what that gives, {bar["at_one_point"]:.6f} Hz, off by a share of {apart:.0e}. The choice '
            f'of mass moves the frequency by {100 * abs(bar["lumped"] / bar["consistent"] - 1):.2f} % here, far less '
            'than the elements\' stiffness does. Quadratic bricks with ν = 0 meet Timoshenko\'s frequencies, '
            f'{bar["beam"][0]:.4f} and {bar["beam"][1]:.4f} Hz over height and width, within {100 * max(beam):.2f} %.')


def render(data, draw):
    with draw.panels('checks', 2, width=6) as (references, locking):
        draw_references(references, data)
        draw_locking(locking, data)
    beams = [f for f in data['references'] if 'crack' not in f['name']]
    worst = max(abs(f['limit'] / f['answer'] - 1) for f in beams)
    penny = [f['limit'] / f['answer'] - 1 for f in data['references'] if 'penny' in f['name']]
    stiff = data['locking']['tetrahedra'][-1]
    lost = [1 - d / q for d, q in zip(stiff['deflection'], data['locking']['quadratic'])]
    return '\n\n'.join([
        'CalculiX is a finite element program of other authors. It answers three questions.',
        '### The same linear tetrahedra',
        'The same mesh, load and clamp, in both programs, warping off. The cut along faces has its nodes doubled in '
        'CalculiX. The cut through elements has every cut element twice, with doubled nodes and the share of each part '
        'as its stiffness, which is what incision\'s cut elements are meant to be. CalculiX prints seven digits.',
        same_table(data), frequencies_text(data),
        '### Quadratic elements, against the answers of the static section',
        f'The beams\' answers hold within {100 * worst:.2f} %. The penny crack, here by an eighth of the same block, '
        f'opens {100 * min(penny):.1f} to {100 * max(penny):.1f} % more than in infinite space, as the block ends at '
        'four radii: what errors extrapolated to edge 0 may show. The edge crack is a plane half plate.',
        references_table(data), draw.picture('checks', 'CalculiX against the answers, and incision against CalculiX'),
        '### Nearly incompressible',
        'The cantilever\'s deflection by quadratic bricks with reduced integration, which lock little, is the '
        f'reference for linear tetrahedra, which lock: with {stiff["cells"]} cells across they lack '
        f'{100 * lost[1]:.0f} % of it at ν = 0.3, {100 * lost[2]:.0f} % at 0.45 and {100 * lost[3]:.0f} % at 0.49. '
        'Half as many bricks change the reference by '
        f'{100 * max(abs(c / f - 1) for c, f in zip(data["locking"]["coarse"], data["locking"]["quadratic"])):.1f} % '
        'at most.',
        locking_table(data)])
