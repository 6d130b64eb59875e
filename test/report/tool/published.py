"""Cuts that others have published, and the same ones here."""

import numpy as np

from plots import COLOURS, DASHES
from tool.figures import (CUCUMBER_FIRST, CUCUMBER_FROM, CUCUMBER_PLATEAU, CUCUMBER_TO, POTATO_LAST, POTATO_PLATEAU,
                          TOLERANCE, by_time, cucumber_plateau, entering, force_at, potato_plateau, spread)

# Of the runs into soft blocks: key, and what is other than in the fitted one.
SOFT_RUNS = (('fitted', 'as fitted'), ('faster', 'ten times the speed'), ('finer', 'finer mesh'),
             ('finest', 'finest mesh'))


def draw_knives(data, draw):
    with draw.panels('knife', 2, width=5.6) as panels:
        for axes, name in zip(panels, ('potato', 'cucumber')):
            for k, run in enumerate(sorted(data[name]['runs'], key=lambda run: run['speed'])):
                axes.plot(*by_time(run), color=COLOURS[k], linestyle=DASHES[k], label=f"{1e3 * run['speed']:g} mm/s")
            axes.set_title(name, fontsize=9)
            axes.set_xlabel('time since the knife set out [s]')
            axes.set_ylabel('force on the knife [N]')
            axes.set_ylim(0, 75)
        potato, cucumber = panels
        potato.axhspan(POTATO_PLATEAU - TOLERANCE, POTATO_PLATEAU + TOLERANCE, color='0.85', zorder=0,
                       label='published, 50 mm/s')
        potato.plot(1.1, POTATO_LAST, 'o', color='black', markerfacecolor='white', label='the last printed')
        cucumber.fill_between((CUCUMBER_FROM, CUCUMBER_TO), CUCUMBER_PLATEAU - TOLERANCE,
                              CUCUMBER_PLATEAU + TOLERANCE, color='0.85', zorder=0, label='published, 50 mm/s')
        cucumber.plot(*CUCUMBER_FIRST, 'o', color='black', markerfacecolor='white')
        large = data['cucumber']['large_run']
        cucumber.plot(*by_time(large), color='0.5', linewidth=0.9,
                      label=f"50 mm/s, {1e3 * data['cucumber']['large']:.0f} mm across")
        for axes in panels:
            axes.legend(loc='lower right')


def draw_soft(data, draw):
    with draw.panels('soft', len(data['soft']), width=5.6) as panels:
        for axes, of in zip(panels, data['soft']):
            for k, (run, name) in enumerate(SOFT_RUNS):
                axes.plot(1e3 * np.array(of[run]['depth']), of[run]['force'], color=COLOURS[k], linestyle=DASHES[k],
                          label=name)
            axes.axvspan(1e3 * of['before'], 1e3 * of['after'], color='0.85', zorder=0, label='was seen to enter')
            axes.set_title(of['name'], fontsize=9)
            axes.set_xlabel('depth of the blade [mm]')
            axes.set_ylabel('force on the blade [N]')
            axes.legend(loc='lower right')


def knife_rows(data):
    potato, cucumber = data['potato']['runs'][0], data['cucumber']['runs'][0]
    time, force = CUCUMBER_FIRST
    rows = [('potato, plateau (its mean fitted)', f'{POTATO_PLATEAU} ± {TOLERANCE} N', potato_plateau(potato)),
            ('potato, 1.1 s', f'{POTATO_LAST} N', force_at(potato, 1.1)),
            (f'cucumber, {time} s (fitted)', f'{force} N', force_at(cucumber, time)),
            (f'cucumber, {CUCUMBER_FROM} to {CUCUMBER_TO} s (its mean fitted)', f'{CUCUMBER_PLATEAU} ± {TOLERANCE} N',
             cucumber_plateau(cucumber))]
    shown = [(what, published, f'{here:.1f} N' if np.isscalar(here) else f'{here[0]:.1f} to {here[2]:.1f} N')
             for what, published, here in rows]
    shown += [(f'{name}, 35 to 65 mm/s: largest difference at equal depth', '–',
               f"{100 * spread(data[name]['runs']):.1f} %") for name in ('potato', 'cucumber')]
    return [dict(zip(('what', 'published', 'here'), row)) for row in shown]


def soft_row(of, run, thickness):
    found = entering(of[run])
    wanted = of['steady'] * of['reached'] * of['young_modulus'] * thickness
    return {'name': of['name'], 'cell': 1e3 * of[run]['cell'], 'speed': 1e3 * of[run]['speed'],
            'depth': 1e3 * found['depth'], 'before': 1e3 * of['before'], 'after': 1e3 * of['after'],
            'first': found['first'], 'share': found['steady'] / wanted, 'ripple': found['ripple']}


def published_fields(data):
    potato, cucumber, softs = data['potato'], data['cucumber'], data['soft']
    entered = [{run: entering(of[run])['depth'] for run, _ in SOFT_RUNS} for of in softs]
    outside = [of['name'] for of, at in zip(softs, entered) if not of['before'] < at['finest'] < of['after']]
    return {'start': 60, 'side': 1e3 * potato['side'], 'potato_force': potato['force'],
            'cucumber_force': cucumber['force'], 'diameter': 1e3 * cucumber['diameter'],
            'met': cucumber['runs'][0]['met'], 'large': 1e3 * cucumber['large'],
            'large_first': force_at(cucumber['large_run'], CUCUMBER_FIRST[0]),
            'large_last': force_at(cucumber['large_run'], CUCUMBER_TO),
            'last_off': POTATO_LAST / force_at(potato['runs'][0], 1.1) - 1, 'knives': knife_rows(data),
            'block': [1e3 * side for side in data['block']], 'cell': 1e3 * data['cell'],
            'shares': [of['steady'] for of in softs], 'reached': [1e3 * of['reached'] for of in softs],
            'softs': [soft_row(of, run, data['block'][1]) for of in softs for run, _ in SOFT_RUNS],
            'half': [entering(of['fitted'])['half'] for of in softs],
            'deeper': [at['finest'] / at['fitted'] - 1 for at in entered],
            'out': f"beyond what was seen in {' and '.join(outside)}" if outside else 'still within what was seen'}
