"""Which source file of the core each function comes from, by what the compiler has put into its object file.

The compiler inlines no function of one object file into another, so nothing of a file can run unseen but what its
header defines.
"""

import collections
import subprocess


def functions(folder):
    """The file of each function, such as 'fracture/growth', by its mangled name; not of names that two files have."""
    found = {}
    for path in sorted(folder.glob('*/*.cpp.o')):
        listing = subprocess.run(['nm', '--defined-only', path], stdout=subprocess.PIPE, check=True, text=True).stdout
        name = f'{path.parent.name}/{path.name.split(".")[0]}'
        for _, kind, symbol in (line.split(maxsplit=2) for line in listing.splitlines()):
            if kind in 'Tt':
                found[symbol] = name if found.get(symbol, name) == name else None
    if not found:
        raise FileNotFoundError(f'{folder}: holds no object files of the core')
    return {symbol: name for symbol, name in found.items() if name}


def shares(costs, file_of):
    """Instructions in the functions of each file."""
    sums = collections.Counter()
    for symbol, count in costs.items():
        if symbol in file_of:
            sums[file_of[symbol]] += count
    return dict(sums)
