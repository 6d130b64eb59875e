"""Which source file each function comes from, by what the compiler has put into the object files.

The compiler inlines no function of one object file into another, so nothing that a .cpp file holds can run unseen. What
a header defines inline can.
"""

import collections
import subprocess

# Functions that are looked at by themselves: what of a mangled name says so.
NAMED = {'factorisation': 'SparseCholesky9factorise', 'consistent mass': 'Assembly12multiplyMass'}


def files(folder):
    """The file of each function, such as 'fracture/growth', by its mangled name; not of names that two stages have.

    `folder` holds the object files as cmake names them: incision.dir/src/fracture/growth.cpp.o.
    """
    found = {}
    for path in sorted(folder.glob('*.dir/src/*/*.cpp.o')):
        listing = subprocess.run(['nm', '--defined-only', path], stdout=subprocess.PIPE, check=True, text=True).stdout
        stage = path.parent.name
        for _, kind, symbol in (line.split(maxsplit=2) for line in listing.splitlines()):
            if kind in 'Tt':
                first = found.setdefault(symbol, f'{stage}/{path.name.split(".")[0]}')
                if first and not first.startswith(f'{stage}/'):
                    found[symbol] = None
    if not found:
        raise FileNotFoundError(f'{folder}: holds no object files')
    return {symbol: name for symbol, name in found.items() if name}


def shares(costs, file_of, steps):
    """Instructions a step in the functions of each file, and in those of NAMED."""
    sums = collections.Counter()
    for symbol, count in costs.items():
        if symbol in file_of:
            sums[file_of[symbol]] += count / steps
        for name, part in NAMED.items():
            if part in symbol:
                sums[name] += count / steps
    return dict(sums)
