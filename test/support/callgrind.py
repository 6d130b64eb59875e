"""Counts instructions by valgrind's callgrind, of which a run on one thread takes the same number each time."""

import collections
import os
import pathlib
import re
import subprocess
import sys
import tempfile

# Whatever the processor, the loader and the libraries take the code that runs on every x86-64.
PLAIN = {'GLIBC_TUNABLES': 'glibc.cpu.hwcaps=-AVX2', 'OPENBLAS_CORETYPE': 'Prescott'}

# A name comes in full once, then as its number alone.
FUNCTION = re.compile(r'fn=\((\d+)\)(?: (.*))?')


def self_costs(lines):
    """Instructions in each function, without those of its callees, from the lines of a callgrind file."""
    names, costs = {}, collections.Counter()
    function, called = None, False
    for line in lines:
        if match := FUNCTION.match(line):
            names.setdefault(match[1], match[2])
            function = names[match[1]]
        elif line.startswith('cfn='):
            match = FUNCTION.match(line[1:])
            names.setdefault(match[1], match[2])
        elif line.startswith('calls='):
            called = True  # the next line holds the callee's cost
        elif line[:1] in '0123456789+-*':
            if not called:
                costs[function] += int(line.split()[1])
            called = False
    return costs


def run(command, environment):
    """What a command prints, with these variables besides. Ends the program where the command fails."""
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          env={**os.environ, **environment})
    if done.returncode:
        sys.exit(done.stderr)
    return done.stdout


def count(command, valgrind='valgrind', options=(), environment={}):
    """Instructions in each function, by its mangled name, while a command runs, and what the command prints."""
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / 'callgrind.out'
        printed = run([valgrind, '--tool=callgrind', f'--callgrind-out-file={out}', '--demangle=no', *options,
                       *command], {**PLAIN, **environment})
        with open(out, encoding='utf-8') as lines:
            return self_costs(line for line in lines if line.strip()), printed
