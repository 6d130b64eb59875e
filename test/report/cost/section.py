"""What a scene saves by what it leaves out."""

from plots import COLOURS, table

TITLE = 'What a scene does not need'

STATES = {'absent': COLOURS[5], 'idle': COLOURS[3], 'working': COLOURS[0]}
HATCHES = {'absent': '', 'idle': '//', 'working': ''}


def ratio(case, cases):
    return case['instructions'] / cases[case['against']]['instructions']


def kilobytes(case):
    return f"{case['bytes'] / 1e3:,.0f}"


def rows(cases):
    for key, case in cases.items():
        more = '' if case['against'] == key else f'{ratio(case, cases):.2f}'
        yield [case['feature'], case['state'], case['text'], f"{case['instructions'] / 1e6:.2f}", more,
               f"{case['allocations']:,.0f}", kilobytes(case), f"{case['ms']:.2f}"]


def draw_ratios(cases, draw):
    """Grey lines of the table as bars: how many times the instructions of the scene without the feature."""
    shown = [(key, case) for key, case in cases.items() if case['against'] != key]
    with draw.panels('ratios', width=7.5, height=0.6 + 0.24 * len(shown)) as (axes,):
        for row, (_, case) in enumerate(shown):
            value = ratio(case, cases)
            axes.barh(row, value, color=STATES[case['state']], hatch=HATCHES[case['state']], edgecolor='white')
            axes.text(value, row, f' {value:.2f}', va='center', fontsize=8)
        axes.set_yticks(range(len(shown)), [f"{case['feature']}: {case['text']}" for _, case in shown])
        axes.invert_yaxis()
        axes.axvline(1, color='black', linewidth=0.8)
        axes.set_xlabel('instructions a step, over those of the scene without the feature')
        axes.grid(axis='y', visible=False)
    return draw.picture('ratios', 'Instructions a step with each feature, idle and working, over those without it')


def render(data, draw):
    return draw_ratios(data['cases'], draw)
