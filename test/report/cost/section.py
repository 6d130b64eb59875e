"""What a scene saves by what it leaves out."""

from plots import COLOURS

LOOKS = {'idle': {'color': COLOURS[3], 'hatch': '//'}, 'working': {'color': COLOURS[0]}}


def ratio(case, cases):
    """Instructions over those of the scene that lacks the feature."""
    return case['instructions'] / cases[case['against']]['instructions']


def more(value):
    """A ratio as words that follow `takes`."""
    if value >= 2:
        return f'{value:.1f} times as much'
    return f"{100 * abs(value - 1):.1f} % {'more' if value >= 1 else 'less'}"


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


def fields(data, draw):
    cases = data['cases']
    draw_ratios(cases, draw)
    takes = {key: more(ratio(case, cases)) for key, case in cases.items()}
    return {'rows': [{**case, 'millions': case['instructions'] / 1e6, 'kB': case['bytes'] / 1e3,
                      'ratio': '' if case['against'] == key else f'{ratio(case, cases):.2f}'}
                     for key, case in cases.items()],
            'takes': takes, 'markers': [{}] if 'markers' in cases else []}
