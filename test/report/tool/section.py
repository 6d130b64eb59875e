"""Force on a blade and opening of its cut, with elements that are cut bit by bit or whole."""

import numpy as np

from plots import COLOURS
from tool.figures import largest_step, off_rest, resolution, steady
from tool.published import draw_knives, draw_soft, published_fields

# Of the curves: key, name, colour, dash, width.
WAYS = (('without', 'elements cut whole', COLOURS[1], '-', 0.9), ('with', 'progressive', COLOURS[0], '-', 2.0))


def mesh_name(cells, data):
    return f"{1e3 * data['block'][1] / cells:.0f} mm cells"


def draw_traces(axes, of, data, values, scale, label):
    for key, name, colour, dash, width in WAYS:
        axes.plot(1e3 * np.array(of[key]['depth']), scale * np.array(of[key][values]), dash, color=colour,
                  linewidth=width, label=name)
    axes.set_title(mesh_name(of['cells'], data), fontsize=9)
    axes.set_xlabel('depth of the blade [mm]')
    axes.set_ylabel(label)


def draw_force(data, draw):
    wanted = data['cutting_force'] * data['block'][2]
    with draw.panels('force', len(data['force']), width=5.6) as panels:
        for axes, of in zip(panels, data['force']):
            draw_traces(axes, of, data, 'force', 1, 'force on the blade [N]')
            axes.axhline(wanted, color='0.5', linestyle='--', linewidth=1, zorder=0, label='cutting force × thickness')
            axes.set_ylim(0, 1.45 * wanted)
        panels[0].legend(loc='lower right')


def draw_opening(data, draw):
    reference = data['reference']
    with draw.panels('opening', len(data['opening']), width=5.6) as panels:
        for axes, of in zip(panels, data['opening']):
            draw_traces(axes, of, data, 'opening', 1e3, 'opening of the cut [mm]')
            axes.plot(*1e3 * np.array(of['rest']).T, 'o', color='black', markerfacecolor='white', zorder=5,
                      label='same mesh, cut to there at rest')
            axes.plot(*1e3 * np.array(reference['points']).T, '--', color='0.5', linewidth=1.2, zorder=0,
                      label=f"at rest, {mesh_name(reference['cells'], data)}")
        panels[0].legend(loc='upper left')


def fields(data, draw):
    draw_force(data, draw)
    draw_opening(data, draw)
    draw_knives(data['published'], draw)
    draw_soft(data['published'], draw)
    wanted = data['cutting_force'] * data['block'][2]
    forces = [{'mesh': mesh_name(of['cells'], data), 'cut': cut, **steady(data, of[key])}
              for of in data['force'] for key, cut in (('without', 'whole'), ('with', 'progressive'))]
    openings = [{'mesh': mesh_name(of['cells'], data), 'end': 1e3 * of['with']['opening'][-1],
                 'off': off_rest(of), **{way: largest_step(of[key]['opening']) / of['with']['opening'][-1]
                                         for key, way in (('without', 'whole'), ('with', 'progressive'))}}
                for of in data['opening']]
    return {**published_fields(data['published']), 'sides': [1e3 * side for side in data['block']],
            'modulus': data['young_modulus'] / 1e3,
            'step': 1e3 * data['stride'], 'elastic': 1e3 * data['cutting_force'] / data['young_modulus'],
            'wanted': wanted, 'from': 1e3 * data['steady'], 'openings': openings,
            'forces': [{**force, 'share': force['mean'] / wanted} for force in forces],
            'smooth': max(force['ripple'] for force in forces if force['cut'] == 'progressive'),
            'rough': min(force['ripple'] for force in forces if force['cut'] == 'whole'),
            'resolutions': ', '.join(f"{100 * resolution(data, of['cells']):.1f} % with {mesh_name(of['cells'], data)}"
                                     for of in data['force'])}
