"""Force on a blade and opening of its cut, with elements that are cut bit by bit or whole."""

from plots import COLOURS, table

TITLE = 'The blade: force and opening as it goes through elements'

# Of the curves: key, name, colour, dash, width.
WAYS = (('without', 'elements cut whole', COLOURS[1], '-', 0.9), ('with', 'progressive', COLOURS[0], '-', 2.0))


def percent(value, digits=1):
    return f'{100 * value:.{digits}f} %'


def millimetres(values):
    return [1e3 * value for value in values]


def mesh_name(cells, data):
    return f"{1e3 * data['block'][1] / cells:.0f} mm cells"


def draw_force(data, draw):
    thickness = data['block'][2]
    with draw.panels('force', len(data['force']), width=5.6) as panels:
        for axes, of in zip(panels, data['force']):
            for key, name, colour, dash, width in WAYS:
                axes.plot(millimetres(of[key]['depth']), of[key]['force'], dash, color=colour, linewidth=width,
                          label=name)
            axes.axhline(data['cutting_force'] * thickness, color='0.5', linestyle='--', linewidth=1, zorder=0,
                         label='cutting force × thickness')
            axes.set_ylim(0, 1.45 * data['cutting_force'] * thickness)
            axes.set_title(mesh_name(of['cells'], data), fontsize=9)
            axes.set_xlabel('depth of the blade [mm]')
            axes.set_ylabel('force on the blade [N]')
        panels[0].legend(loc='lower right')
    return draw.picture('force', 'Force on the blade against its depth')


def draw_opening(data, draw):
    reference = data['reference']
    with draw.panels('opening', len(data['opening']), width=5.6) as panels:
        for axes, of in zip(panels, data['opening']):
            for key, name, colour, dash, width in WAYS:
                axes.plot(millimetres(of[key]['depth']), millimetres(of[key]['opening']), dash, color=colour,
                          linewidth=width, label=name)
            axes.plot(*zip(*[millimetres(point) for point in of['rest']]), 'o', color='black', markerfacecolor='white',
                      label='same mesh, cut to there at rest', zorder=5)
            axes.plot(*zip(*[millimetres(point) for point in reference['points']]), '--', color='0.5', linewidth=1.2,
                      label=f"at rest, {mesh_name(reference['cells'], data)}", zorder=0)
            axes.set_title(mesh_name(of['cells'], data), fontsize=9)
            axes.set_xlabel('depth of the blade [mm]')
            axes.set_ylabel('opening of the cut [mm]')
        panels[0].legend(loc='upper left')
    return draw.picture('opening', 'Opening of the cut against the depth of the blade')


def force_table(data):
    wanted = data['cutting_force'] * data['block'][2]
    rows = []
    for of in data['force']:
        for key, name in (('without', 'whole'), ('with', 'progressive')):
            one = of[key]
            rows.append([mesh_name(of['cells'], data), name,
                         f"{one['mean']:.3f} N, {percent(one['mean'] / wanted)} of F_c × thickness",
                         percent(one['ripple']), percent(one['jump']), f"{one['work']:.1f} J/m²"])
    return table(['mesh', 'elements are cut', 'mean force', 'ripple', 'largest change in a step', 'work by area'], rows)


def opening_table(data):
    rows = []
    for of in data['opening']:
        end = of['with']['opening'][-1]
        rows.append([mesh_name(of['cells'], data), f'{1e3 * end:.2f} mm', percent(of['without']['jump'] / end),
                     percent(of['with']['jump'] / end), percent(of['off'], 2)])
    return table(['mesh', 'opening at the end', 'largest change in a step, of that: whole', 'progressive',
                  'progressive against cuts at rest'], rows)


def render(data, draw):
    length, height, thickness = (1e3 * side for side in data['block'])
    elastic = 1e3 * data['cutting_force'] / data['young_modulus']
    smooth = max(of['with']['ripple'] for of in data['force'])
    rough = min(of['without']['ripple'] for of in data['force'])
    resolutions = ', '.join(f"{percent(of['resolution'])} with {mesh_name(of['cells'], data)}" for of in data['force'])
    return f'''A block of {length:.0f} × {height:.0f} × {thickness:.0f} mm (E = {data['young_modulus'] / 1e3:g} kPa, ν = 0.3)
is held at one end. A blade whose edge goes through the whole thickness is pushed slowly into the other end, half-way
up, by {1e3 * data['stride']:g} mm a step. The grids have an odd count of cells over the height, so that the cut runs
in the middle of cells: the blade goes through elements.

**Force.** The cutting force is F_c = {data['cutting_force']:g} N/m, the elastic length F_c / E = {elastic:g} mm: the
tissue first gives way by some of these, then it is cut. From then on the force must be F_c × thickness =
{data['cutting_force'] * data['block'][2]:g} N, and the work F_c times what is cut. The figures are of depths beyond
{1e3 * data['steady']:.0f} mm. Ripple is the standard deviation, by the mean; so is the largest change in a step.

{draw_force(data, draw)}

{force_table(data)}

**Opening.** The same without a cutting force, while {data['pull']:g} Pa pull the upper and the lower side apart. The
opening is how much farther apart the upper and the lower edge of the face are than at rest. Beside it: blocks that a
rectangle has cut to whole cells, at rest, on the same mesh and on a finer one.

{draw_opening(data, draw)}

{opening_table(data)}

What follows:

- **Leave `tool.progressive` on where the force is felt.** With it the ripple is {percent(smooth)} at most, with
  elements cut whole {percent(rough, 0)} or more: such an element leaves nothing before the blade that resists, and the
  force falls until the blade has come to the next one.
- **The mean force is F_c × thickness**, but for the ends of the edge: it resists at eight points an element, so where
  it comes out of the tissue the force is off by up to an eighth of an element by the thickness
  ({resolutions}).
- **The opening goes through the same values at the ends of the cells**, which are those of the mesh: a coarser one is
  stiffer. In between, progressive opening makes of each stair a slope. It is steep where the blade enters an element,
  as what holds its sides together soon softens, so the largest change in a step is smaller, but not small.'''
