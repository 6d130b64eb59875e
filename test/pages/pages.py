"""The pages of documentation, taken apart: their headings, links, code blocks and the command lines in them."""

import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent

FENCE = re.compile(r'^( *)```(\w*)\n(.*?)^\1```$', re.MULTILINE | re.DOTALL)

# What starts a program when it stands in a sentence or a table.
PROGRAM = re.compile(r'`((?:\./|roslaunch |rosrun |rosservice |rostopic |rostest |incision_|ctest |cmake |catkin_make|gmsh '
                     r'|meshio |admesh |sudo |PYTHONPATH=|source )[^`]*)`')

# What a command line in a sentence names, but does not say: a program with its arguments in capitals, an option of one.
FORM = re.compile(r'\b[A-Z_]{4,}\b(?!=)|…')

# A file or folder of the package, by its path from the top.
FILE = re.compile(r'`((?:config|launch|msg|src|test|include/incision)/[\w./*-]+)`')


class Block:
    """A fenced block of code: `language`, its `text` without the indentation of a list, and the `page` that has it."""

    def __init__(self, page, indentation, language, text):
        self.page, self.language = page, language
        self.text = re.sub(f'^{indentation}', '', text, flags=re.MULTILINE)

    def __repr__(self):
        return f'{self.page}: {self.text.splitlines()[0]}'


def pages():
    """Path from the top of the package -> text. What the report writes is not written by hand, and not read here."""
    paths = [path for path in sorted(ROOT.rglob('*.md')) if not {'.git', 'build', 'report'} & set(path.relative_to(ROOT).parts)]
    return {str(path.relative_to(ROOT)): path.read_text(encoding='utf-8') for path in paths}


def blocks(page, text):
    return [Block(page, *match.groups()) for match in FENCE.finditer(text)]


def prose(text):
    """Without the blocks of code."""
    return FENCE.sub('', text)


def anchors(text):
    """Those that the headings give, by the rule of the pages that show them: lower case, no punctuation, - for spaces."""
    headings = re.findall(r'^#+ (.*)$', prose(text), re.MULTILINE)
    return {re.sub(r'[^\w\- ]', '', heading.lower()).replace(' ', '-') for heading in headings}


def links(text):
    """Where a page points: links and pictures, without addresses on the web."""
    return [link for link in re.findall(r'\]\(([^)\s]+)\)', prose(text)) if '://' not in link]


def command_lines(page, text):
    """Blocks of shell commands, and the command lines in sentences and tables, each as a block."""
    inline = [Block(page, '', 'sh', line) for line in PROGRAM.findall(prose(text)) if ' ' in line and not FORM.search(line)]
    return [block for block in blocks(page, text) if block.language == 'sh'] + inline


def table(text, heading):
    """Rows of the table with this heading line, each a list of its cells."""
    lines = text[text.index(heading):].split('\n\n')[0].splitlines()[2:]
    return [[cell.strip() for cell in re.split(r'(?<!\\)\|', line)[1:-1]] for line in lines]
