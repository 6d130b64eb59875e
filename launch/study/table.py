"""One table of a study: a row for each run that has come to an end."""

import csv
import os
import pathlib

from study.runs import WAITING, outcome_of, record_of
from study.values import as_yaml

# Of lists of any length the table has the first entries.
MAX_ENTRIES = 8

# What a row says itself, or what is the same in all.
LEFT_OUT = ('scene', 'set', 'interrupted', 'failure', 'cuts')


def flat(value, name=''):
    """(column, cell) of everything in what a run has said: tools.scalpel.force.2 for a list in a map in a map."""
    if isinstance(value, dict):
        for key, entry in value.items():
            yield from flat(entry, f'{name}.{key}' if name else key)
    elif isinstance(value, list):
        for i, entry in enumerate(value[:MAX_ENTRIES]):
            yield from flat(entry, f'{name}.{i}')
    elif value is not None:
        yield name, value


def cells_of(line):
    cells = dict(flat({key: value for key, value in line.items() if key not in LEFT_OUT}))
    for status in ('applied', 'missed', 'rejected', 'pending'):
        cells[f'cuts.{status}'] = sum(cut.get('status') == status for cut in line.get('cuts', []))
    return cells


def row_of(study, folder, run):
    """The cells of a run by their columns, or None while it is still to be run."""
    state, line, reason = outcome_of(folder, run)
    if state == WAITING:
        return None
    row = {'run': run.name, 'repetition': run.repetition, 'status': state, 'reason': reason}
    if study.record:
        row['record'] = os.path.relpath(record_of(folder, run.name), folder)
    for key, value in run.values.items():
        row[key] = value if isinstance(value, (int, float, str)) and not isinstance(value, bool) else as_yaml(value)
    for column, cell in cells_of(line or {}).items():
        row[f'end.{column}' if column in row else column] = cell
    return row


def table_of(folder):
    return pathlib.Path(folder) / 'study.csv'


def collect(study, folder, runs):
    """Writes the table, whole or not at all. Returns its rows."""
    rows = [row for row in (row_of(study, folder, run) for run in runs) if row is not None]
    columns = list(dict.fromkeys(column for row in rows for column in row))
    path = table_of(folder)
    part = path.with_suffix('.part')
    with open(part, 'w', newline='', encoding='utf-8') as file:
        writer = csv.DictWriter(file, columns)
        writer.writeheader()
        writer.writerows(rows)
    part.replace(path)
    return rows
