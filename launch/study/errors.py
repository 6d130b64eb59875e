"""What is wrong with what a user gave, in one line; and guesses at what was meant."""

import difflib


class InputError(Exception):
    """One line that names the file, the key, the value and what is allowed."""


def guess(word, known):
    """` (did you mean ...?)`, or nothing where no known word is near."""
    near = difflib.get_close_matches(str(word), known, n=1)
    return f' (did you mean {near[0]}?)' if near else ''


def check_keys(section, where, allowed):
    """Throws InputError where a section of a study has a key that is not allowed."""
    for key in section:
        if key not in allowed:
            raise InputError(f'{where}{key}: unknown key{guess(key, allowed)} (allowed: {", ".join(allowed)})')
