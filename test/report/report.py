#!/usr/bin/python3
"""Writes FOLDER/README.md and FOLDER/plots/ from what was measured, FOLDER/data/SECTION.json.

usage: report.py FOLDER SECTION...

A section that was never measured is taken from README.md beside this file, as published. The text of the others is
SECTION/section.md beside this file, a template that text.py fills; their figures are SECTION/section.py: fields(data,
draw) returns what the template names and the data has not, and draws the plots by a Plots (plots.py).
"""

import importlib
import json
import pathlib
import sys

import text
from plots import Plots

HERE = pathlib.Path(__file__).resolve().parent


def published(name):
    """A section as it was published; nothing if it never was."""
    title = (HERE / name / 'section.md').read_text(encoding='utf-8').split('\n', 1)[0]
    readme = (HERE / 'README.md').read_text(encoding='utf-8')
    if title + '\n' not in readme:
        return None
    return title + '\n' + readme.split(title + '\n', 1)[1].split('\n## ', 1)[0]


def rendered(folder, name):
    if not (folder / 'data' / f'{name}.json').is_file():
        return published(name)
    data = json.loads((folder / 'data' / f'{name}.json').read_text(encoding='utf-8'))
    fields = importlib.import_module(f'{name}.section').fields(data, Plots(folder / 'plots', name))
    title, body = (HERE / name / 'section.md').read_text(encoding='utf-8').split('\n', 1)
    measured = text.filled((HERE / 'measured.md').read_text(encoding='utf-8').strip(), data['measured'])
    return '\n'.join([title, '', measured, text.filled(body, {**data, **fields})])


def main(folder, names):
    sections = [section for section in (rendered(folder, name) for name in names) if section]
    head = (HERE / 'head.md').read_text(encoding='utf-8')
    (folder / 'README.md').write_text('\n'.join([head, *sections]), encoding='utf-8')
    print(f'Wrote {folder / "README.md"}')


if __name__ == '__main__':
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(pathlib.Path(sys.argv[1]), sys.argv[2:])
