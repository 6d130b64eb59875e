#!/usr/bin/python3
"""A program of a user builds and runs against the installed package, whose headers include installed headers alone.

install_test.py BUILD_FOLDER
"""

import os
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent

# For nodes, or for the inside of the core.
NOT_INSTALLED = ('ros', 'pace', 'solver/direct_solver.h')


def run(*command, **options):
    subprocess.run([str(part) for part in command], check=True, **options)


def write_headers(installed, path):
    """Includes all headers of our own; messages have headers too, which come from elsewhere."""
    source = HERE.parent.parent / 'include'
    headers = sorted(str(header.relative_to(installed)) for header in installed.rglob('*.h')
                     if (source / header.relative_to(installed)).exists())
    path.write_text(''.join(f'#include "{header}"\n' for header in headers), encoding='utf-8')
    return headers


def main():
    build = pathlib.Path(sys.argv[1])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        prefix = folder / 'installed'
        run('cmake', '--install', build, '--prefix', prefix, stdout=subprocess.DEVNULL)
        assert (prefix / 'include/incision/body/deformable_body.h').exists()
        for entry in NOT_INSTALLED:
            assert not (prefix / 'include/incision' / entry).exists(), f'{entry} is installed'
        headers = write_headers(prefix / 'include', folder / 'installed_headers.h')
        environment = {**os.environ, 'CXXFLAGS': f'-I{folder}', 'CMAKE_PREFIX_PATH': str(prefix)}
        environment.pop('LD_LIBRARY_PATH', None)  # or it would run with the libraries of the build
        run('cmake', '-S', HERE, '-B', folder / 'user', f'-DPYTHON_EXECUTABLE={sys.executable}',
            stdout=subprocess.DEVNULL, env=environment)
        run('cmake', '--build', folder / 'user', stdout=subprocess.DEVNULL, env=environment)
        run(folder / 'user/devel/lib/user_package/user_program', env=environment)
        for program in ('incision_study', 'incision_fit'):
            run(prefix / 'lib/incision' / program, '--help', stdout=subprocess.DEVNULL, cwd=folder)
        study = prefix / 'share/incision/launch/study/bar_study.yaml'
        listed = subprocess.run([prefix / 'lib/incision/incision_study', study, '--list'], check=True, cwd=folder,
                                stdout=subprocess.PIPE, text=True).stdout
        assert listed.startswith(str(prefix / 'lib/incision/incision_batch')), listed
        print(f'{len(headers)} headers are installed, and a program builds with all of them')


if __name__ == '__main__':
    main()
