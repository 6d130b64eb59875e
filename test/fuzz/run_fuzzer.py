#!/usr/bin/python3
"""Runs a fuzzer and fails where it finds a fault, or does not see the core that it is there for.

usage: run_fuzzer.py PROGRAM SECONDS LEAST FOUND SEEDS
LEAST: edges of the code that the seeds alone reach at least. A fuzzer that is blind to the core reaches some fifty, its
own; seeds that no longer go through all sections of a format reach fewer than they did.
"""

import re
import subprocess
import sys

REACHED = re.compile(r'^#\d+\s+INITED cov: (\d+)', re.MULTILINE)
AT_THE_END = re.compile(r'cov: (\d+)')


def main():
    program, seconds, least, found, seeds = sys.argv[1:]
    # The seeds alone come first: what earlier runs have found would hide what they lack.
    said = run(program, '-runs=0', seeds)
    reached = REACHED.search(said)
    if not reached or int(reached[1]) < int(least):
        sys.exit(f'the seeds reach {reached[1] if reached else "no"} edges of the code, which should be {least} at least')
    said = run(program, f'-max_total_time={seconds}', '-timeout=30', '-rss_limit_mb=2048', '-print_final_stats=1', found,
               seeds)
    print(f'The seeds reach {reached[1]} edges of the code, with what was found {AT_THE_END.findall(said)[-1]}')


def run(program, *arguments):
    """What the fuzzer says, which is printed too."""
    result = subprocess.run([program, *arguments], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    said = result.stdout.decode(errors='replace')
    print(said)
    if result.returncode:
        sys.exit(f'the fuzzer ended with status {result.returncode}')
    return said


if __name__ == '__main__':
    main()
