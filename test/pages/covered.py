"""Which test runs which command lines of the pages, so that none is left out."""

import pages

_covered = []  # (page, how the block or line begins)


class Shown:
    """The command lines of a page that begins so; taken once by a test, which runs them."""

    def __init__(self, page, beginning):
        _covered.append((page, beginning))
        self.page, self.beginning = page, beginning

    @property
    def text(self):
        page = self.page
        found = [block.text for block in pages.command_lines(page, pages.pages()[page]) if block.text.startswith(self.beginning)]
        assert found, f'{page} has no command line that begins with {self.beginning!r}'
        return found[0]

    def lines(self):
        return [line for line in self.text.replace('\\\n', ' ').splitlines() if line.strip()]


def left_out():
    """Command lines that no test has said to run, and those that tests name but no page has."""
    blocks = [block for page, text in pages.pages().items() for block in pages.command_lines(page, text)]
    missing = [block for block in blocks
               if not any(block.page == page and block.text.startswith(beginning) for page, beginning in _covered)]
    idle = [(page, beginning) for page, beginning in _covered
            if not any(block.page == page and block.text.startswith(beginning) for block in blocks)]
    return missing, idle
