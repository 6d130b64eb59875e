"""One style for the report's plots, readable in grey."""

import contextlib

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.ticker import LogLocator, NullFormatter  # noqa: E402

# Dark to light, each with a marker and a dash of its own, so that curves can be told apart without colour.
COLOURS = ('#1b2a49', '#c1443c', '#2e8b7a', '#e0a030', '#7a5aa6', '#8a8a8a')
MARKERS = ('o', 's', '^', 'D', 'v', 'x')
DASHES = ('-', '--', '-.', ':', (0, (5, 1, 1, 1, 1, 1)), (0, (1, 1)))

PANEL = (4.6, 3.6)  # of one panel [inch]
DPI = 100

plt.rcParams.update({'font.size': 9, 'axes.grid': True, 'grid.alpha': 0.3, 'legend.fontsize': 8,
                     'legend.framealpha': 0.8, 'axes.spines.top': False, 'axes.spines.right': False})


def curve(number):
    """What tells the number-th curve of a panel apart: arguments for plot()."""
    k = number % len(COLOURS)
    return {'color': COLOURS[k], 'marker': MARKERS[k], 'linestyle': DASHES[k], 'markersize': 5}


def plain_numbers(axis, digits=(1, 2, 5)):
    """Labels such as 20, 50, 100 on a logarithmic axis."""
    axis.set_major_locator(LogLocator(subs=digits))
    axis.set_major_formatter('{x:g}')
    axis.set_minor_formatter(NullFormatter())


class Plots:
    """Draws the plots of a section into a folder."""

    def __init__(self, folder, section):
        self.folder, self.section = folder, section
        folder.mkdir(parents=True, exist_ok=True)

    @contextlib.contextmanager
    def panels(self, name, count=1, width=PANEL[0], height=PANEL[1]):
        """Axes of panels side by side; saved as SECTION_NAME.png when the block ends."""
        figure, axes = plt.subplots(1, count, squeeze=False, figsize=(count * width, height))
        yield list(axes[0])
        figure.tight_layout()
        figure.savefig(self.folder / f'{self.section}_{name}.png', dpi=DPI)
        plt.close(figure)
