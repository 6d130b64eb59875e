#!/usr/bin/python3
"""Writes report.md and its plots from what the sections measured.

usage: report.py FOLDER SECTION...

FOLDER/data/SECTION.json is what a section measured; one that was never measured is left out. The plots go to
FOLDER/plots/. How a section shows its data is said in SECTION/section.py beside this file: TITLE, and render(data, draw)
that returns the section's Markdown; draw is a Plots (plots.py).
"""

import datetime
import importlib.util
import json
import os
import pathlib
import platform
import re
import sys

from plots import Plots, table

HERE = pathlib.Path(__file__).resolve().parent


def load_section(name):
    spec = importlib.util.spec_from_file_location(f'section_{name}', HERE / name / 'section.py')
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def processor():
    text = pathlib.Path('/proc/cpuinfo').read_text(encoding='utf-8')
    found = re.search(r'model name\s*: (.*)', text)
    return found.group(1) if found else platform.machine()


def claims_table(claims):
    return table(['claim', 'measured', 'wanted', ''],
                 [[c['claim'], c['measured'], c['wanted'], 'holds' if c['holds'] else '**fails**'] for c in claims])


def main(folder, names):
    folder = pathlib.Path(folder)
    lines = ['# Evidence: error against time, stability, and what a scene does not need', '',
             'Written by `test/report/run.sh`; do not edit. Each section states what it measured, against what, and '
             'what follows for the choice of settings.', '',
             f'Drawn on {datetime.date.today()} on {os.cpu_count()} cores of an {processor()}. Times are wall times '
             'there; claims never depend on them.', '']
    for name in names:
        path = folder / 'data' / f'{name}.json'
        if not path.is_file():
            continue
        data = json.loads(path.read_text(encoding='utf-8'))
        section = load_section(name)
        lines += [f'## {section.TITLE}', '']
        if data['quick']:
            lines += ['A quick run: smaller meshes and fewer cases.', '']
        lines += [section.render(data, Plots(folder / 'plots', name)), '']
        if data['claims']:
            lines += ['What is checked:', '', claims_table(data['claims']), '']
    (folder / 'report.md').write_text('\n'.join(lines), encoding='utf-8')
    print(f'Wrote {folder / "report.md"}')


if __name__ == '__main__':
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(sys.argv[1], sys.argv[2:])
