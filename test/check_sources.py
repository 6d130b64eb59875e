#!/usr/bin/python3
"""Checks that the sources keep to the shape of the code: who may include whom, and what lies at the top level."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent

# In the order in which data flows: a stage may include itself and earlier ones.
STAGES = ['base', 'mesh', 'cut', 'surface', 'rigid', 'fem', 'solver', 'contact', 'fracture', 'tool', 'scene', 'body',
          'run', 'pace', 'ros']

# Libraries whose headers lie in folders and that the core may use. No ROS among them.
CORE_FOLDERS = {'Eigen', 'assimp', 'cereal', 'console_bridge', 'nlohmann', 'sys', 'urdf_model', 'urdf_parser', 'yaml-cpp'}

TOP_LEVEL = {'include', 'src', 'msg', 'config', 'launch', 'test', 'README.md', 'LICENSE', 'CMakeLists.txt',
             'package.xml', 'build'}

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def stage_of(path):
    """The stage of a source file; the programs see what their library holds."""
    if path.name == 'incision_batch.cpp':
        return 'run'
    if path.name in ('incision_node.cpp', 'incision_bag.cpp', 'incision_scalpel.cpp', 'incision_handle.cpp'):
        return 'ros'
    for root in (ROOT / 'include' / 'incision', ROOT / 'src'):
        if root in path.parents:
            return path.relative_to(root).parts[0]
    return None


def include_fault(stage, header):
    """Why a file of this stage may not include this header, or None."""
    folder, _, rest = header.rpartition('/')
    if folder.startswith('incision/'):
        other = folder.split('/')[1]
        if other not in STAGES:
            return f'{other} is no stage'
        if STAGES.index(other) > STAGES.index(stage):
            return f'{other} comes after {stage}'
    elif stage != 'ros' and folder and header.split('/')[0] not in CORE_FOLDERS:
        return 'the core uses no such library'
    return None


def file_faults(path):
    name = path.relative_to(ROOT)
    stage = stage_of(path)
    if stage not in STAGES:
        yield f'{name}: lies in no stage'
        return
    text = path.read_text(encoding='utf-8')
    for header in INCLUDE.findall(text):
        fault = include_fault(stage, header)
        if fault:
            yield f'{name}: includes {header}, but {fault}'
    if stage != 'solver' and 'cholmod' in text.lower():
        yield f'{name}: names CHOLMOD, which only the solver may'


def main():
    faults = [f'{entry.name}: not a name for the top level' for entry in ROOT.iterdir()
              if entry.name not in TOP_LEVEL and not entry.name.startswith('.')]
    sources = sorted(path for folder in ('include', 'src') for path in (ROOT / folder).rglob('*')
                     if path.suffix in ('.h', '.cpp'))
    for path in sources:
        faults.extend(file_faults(path))
    print('\n'.join(faults) if faults else f'{len(sources)} files are in order')
    return 1 if faults or not sources else 0


if __name__ == '__main__':
    sys.exit(main())
