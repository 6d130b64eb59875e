"""What a section measured, for the tests of its claims."""

import json
import os
import pathlib


def measured(section):
    """Data of a section in INCISION_REPORT, the folder that measure.py was given."""
    return json.loads((pathlib.Path(os.environ['INCISION_REPORT']) / 'data' / f'{section}.json').read_text('utf-8'))
