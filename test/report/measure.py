#!/usr/bin/python3
"""Measures a section of the report into FOLDER/data/SECTION.json.

usage: measure.py [--quick] FOLDER SECTION

A section is measured by SECTION/measure.py beside this file, whose measure(quick) returns the data, or by the program
report_SECTION. Quick is smaller meshes and fewer cases, for a run of a minute at most. Takes from the environment
INCISION_PROGRAMS, the folder of the report's programs, and INCISION_BATCH, the path of incision_batch.
"""

import argparse
import datetime
import importlib
import json
import os
import pathlib
import platform
import re
import subprocess

HERE = pathlib.Path(__file__).resolve().parent


def processor():
    found = re.search(r'model name\s*: (.*)', pathlib.Path('/proc/cpuinfo').read_text(encoding='utf-8'))
    return found.group(1) if found else platform.machine()


def version():
    done = subprocess.run(['git', '-C', HERE, 'describe', '--always', '--dirty'], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True, check=False)
    return done.stdout.strip() or 'unknown'


def measured(section, quick, path):
    if (HERE / section / 'measure.py').is_file():
        return importlib.import_module(f'{section}.measure').measure(quick)
    program = os.path.join(os.environ['INCISION_PROGRAMS'], f'report_{section}')
    subprocess.run([program, *(['--quick'] if quick else []), path], check=True)
    return json.loads(path.read_text(encoding='utf-8'))


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument('--quick', action='store_true')
    parser.add_argument('folder', type=pathlib.Path)
    parser.add_argument('section')
    options = parser.parse_args()
    path = options.folder.resolve() / 'data' / f'{options.section}.json'
    path.parent.mkdir(parents=True, exist_ok=True)
    data = measured(options.section, options.quick, path)
    data['measured'] = {'how': 'quickly, on smaller meshes and fewer cases, ' if options.quick else '',
                        'date': str(datetime.date.today()), 'cores': os.cpu_count(), 'processor': processor(),
                        'version': version()}
    path.write_text(json.dumps(data, indent=1), encoding='utf-8')


if __name__ == '__main__':
    main()
