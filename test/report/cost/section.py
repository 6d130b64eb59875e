"""What a scene saves by what it leaves out."""

from plots import COLOURS, table

TITLE = 'What a scene does not need'

LOOKS = {'idle': {'color': COLOURS[3], 'hatch': '//'}, 'working': {'color': COLOURS[0]}}


def ratio(case, cases):
    """Instructions over those of the scene that lacks the feature."""
    return case['instructions'] / cases[case['against']]['instructions']


def more(case, cases):
    """The same as words that follow `takes`."""
    value = ratio(case, cases)
    if value >= 2:
        return f'{value:.1f} times as much'
    return f"{100 * abs(value - 1):.1f} % {'more' if value >= 1 else 'less'}"


def row(key, case, cases):
    return [case['feature'], case['state'], case['text'], f"{case['instructions'] / 1e6:.2f}",
            '' if case['against'] == key else f'{ratio(case, cases):.2f}', f"{case['allocations']:,.0f}",
            f"{case['bytes'] / 1e3:,.0f}", f"{case['ms']:.2f}"]


def cost_table(cases):
    return table(['feature', 'state', 'the scene', 'M instructions a step', '× absent', 'allocations a step', 'kB',
                  'ms a step'], [row(key, case, cases) for key, case in cases.items()])


def draw_ratios(cases, draw):
    shown = [case for key, case in cases.items() if case['against'] != key]
    with draw.panels('ratios', width=7.5, height=0.8 + 0.24 * len(shown)) as (axes,):
        for state, look in LOOKS.items():
            at = [k for k, case in enumerate(shown) if case['state'] == state]
            axes.barh(at, [ratio(shown[k], cases) for k in at], edgecolor='white', label=state, **look)
        for k, case in enumerate(shown):
            axes.text(ratio(case, cases), k, f' {ratio(case, cases):.2f}', va='center', fontsize=8)
        axes.set_yticks(range(len(shown)), [f"{case['feature']}: {case['text']}" for case in shown])
        axes.invert_yaxis()
        axes.axvline(1, color='black', linewidth=0.8)
        axes.set_xlabel('instructions a step, over those of the scene without the feature')
        axes.grid(axis='y', visible=False)
        axes.legend()
    return draw.picture('ratios', 'Instructions a step with each feature, idle and working, over those without it')


def render(data, draw):
    cases = data['cases']
    plain, before = cases['plain'], cases['cut before']

    def of(key):
        return more(cases[key], cases)

    drawn = (f'''
- **Markers**: while somebody listens, a message takes {of("markers")}, most of it on a thread of its own. With no
  subscriber none is built.''' if 'markers' in cases else '')
    return f'''One scene, the bar of `config/scenes/bar.yaml` ({plain["elements"]:,} elements), ten times as stiff and damped,
with one feature added at a time. It is held at the lower half of one end, so that a layer cut off above can lie on what is
below. *Absent*: the scene does not name the feature. *Idle*: it does, and nothing happens. *Working*: it happens in
each of the measured steps.

{cost_table(cases)}

Instructions are counted by callgrind, on one thread, in ten steps of a moving bar, or of one at rest where the table
says so. *× absent* compares with the scene that only lacks this feature: the bar alone, or the last row above that
says *absent*. kB is what the body holds of the heap. ms is the median step of the stepping thread, with two threads.
Mass and warping act in every step, so they are never idle.

{draw_ratios(cases, draw)}

What follows for a scene, in instructions a step:

- **Absent costs nothing.** No function of a stage's sources runs in a step of a scene that does not ask for it.
  callgrind tells functions by name; what a header defines inline has none, but is in the sums.
- **Cuts** that have not come yet cost nothing. Cuts that were made stay: ten slits make {before["copies"]} copies of
  {plain["copies"]}, and from then on a step takes {of("cut before")}.
- **Fracture** looks at the stress of every element in every step, so a step takes {of("fracture waits")} even where
  nothing breaks. Leave `fracture` out where a body cannot break. Cracks that open against a fracture energy are springs
  to the solver: with them a step takes {of("cohesion")}.
- **Contact** takes {of("ground below")} with the ground far below, {of("on ground")} lying on it.
- **Self-contact** takes {of("one piece")} where nothing touches. The search is renewed only when something has moved,
  so this is more in a body that deforms fast. A layer at rest on another takes {of("layers rest")}. While it slides and
  settles a step takes {of("layers settle")}, as it solves anew each time that contacts close or part.
- **The tool** takes {of("tool still")} while it stands still and {of("tool away")} while it moves beside the body.
- **Consistent mass** takes {of("consistent")} than lumped, the default.
- **Warping** is what a scene saves most by: with it the direct solver takes {of("warped")}, as it finds rotations and
  factorises in every step. Without it the result is true for small turns alone.{drawn}
- **The heap** is asked for nothing in a step in which no feature is at work.'''
