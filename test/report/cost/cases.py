"""The scene whose cost is measured, and the settings that add one feature to it."""

import dataclasses
import pathlib

SCENE = pathlib.Path(__file__).resolve().parents[3] / 'config/scenes/bar.yaml'

TIME_STEP = 0.01  # of that scene [s]
FIRST, STEPS = 10, 10  # steps that are taken before those that are measured, and these
START, END = FIRST * TIME_STEP, (FIRST + STEPS) * TIME_STEP

# The lower half of one end is held, so that the upper of two layers comes to rest on the lower one.
BASE = ('boundary.0.box=[[-1, -1, -1], [1.0e-6, 1, 0.126]]', 'body.material.young_modulus=1.0e+7',
        'body.material.stiffness_damping=0.01', 'solver.method=iterative')
QUICK, FULL = ('body.grid.cells=[8, 3, 3]',), ()


def slits(first, apart):
    """One cut a measured step, each from above down to three fifths of the bar's height."""
    return 'cuts=[' + ', '.join(
        f'{{time: {first + k * apart}, point: [{0.1 + 0.08 * k}, 0.125, 0.25], normal: [1, 0.1, 0.05], '
        'tangent: [0, 0, 1], length: 0.3}' for k in range(STEPS)) + ']'


def wire(x, last):
    """A wire across the bar that goes down from above it to the height `last` at the end of the measured steps."""
    return ('tools={wire: {type: blade, edge: [[0, -0.5, 0], [0, 0.5, 0]], poses: '
            f'[[{START - 4 * TIME_STEP}, {x}, 0, 0.3, 0, 0, 0, 1], [{END}, {x}, 0, {last}, 0, 0, 0, 1]]}}}}')


LAYERS = 'cuts=[{point: [0.5, 0.125, 0.15], normal: [0.05, 0.03, 1]}]'


@dataclasses.dataclass(frozen=True)
class Case:
    key: str
    feature: str
    state: str  # 'absent', 'idle' or 'working'
    text: str
    settings: tuple
    against: str = 'plain'  # the case in which this feature alone is absent
    first: int = FIRST  # steps before the measured ones
    program: str = 'report_cost'
    parameters: tuple = ()  # of the ROS node that the program is


CASES = (
    Case('plain', 'none', 'absent', 'the bar alone', ()),
    Case('cut waits', 'cracks', 'idle', 'cuts that have not come yet', (slits(1e6, 1),)),
    Case('cut before', 'cracks', 'idle', 'ten slits, made long ago', (slits(0, 0),)),
    Case('cut now', 'cracks', 'working', 'a slit in every step', (slits(START, TIME_STEP),)),
    Case('fracture waits', 'fracture', 'idle', 'a strength that is never reached',
         ('fracture={tensile_strength: 1.0e+9}',)),
    Case('fracture grows', 'fracture', 'working', 'cracks that grow', ('fracture={tensile_strength: 1.0e+4}',)),
    Case('cohesion', 'fracture', 'working', 'cracks that grow and take energy',
         ('fracture={tensile_strength: 1.0e+4, fracture_energy: 10}',)),
    Case('ground below', 'contact', 'idle', 'ground far below', ('contact={ground: -100, self: false}',)),
    Case('on ground', 'contact', 'working', 'lying on the ground', ('contact={ground: 0, self: false}',)),
    Case('one piece', 'self-contact', 'idle', 'one piece', ('contact={self: true}',)),
    Case('layers', 'self-contact', 'absent', 'cut in two layers', (LAYERS,), 'layers'),
    Case('layers settle', 'self-contact', 'working', 'a layer that slides and settles on another',
         (LAYERS, 'contact={self: true}'), 'layers'),
    Case('layers rest', 'self-contact', 'working', 'a layer at rest on another',
         (LAYERS, 'contact={self: true}'), 'layers', 100),
    Case('tool still', 'tool', 'idle', 'a blade that stands still', (wire(0.55, 0.3),)),
    Case('tool away', 'tool', 'idle', 'a blade that moves beside it', (wire(50, 0.05),)),
    Case('tool cuts', 'tool', 'working', 'a blade that moves through it', (wire(0.55, 0.05),)),
    Case('consistent', 'consistent mass', 'working', 'instead of lumped', ('body.mass=consistent',)),
    Case('linear', 'warping', 'absent', 'linear, solved directly', ('body.warping=false', 'solver.method=direct'),
         'linear'),
    Case('warped', 'warping', 'working', 'warped, solved directly', ('solver.method=direct',), 'linear'),
)

MARKERS = 'report_cost_markers'
ROS_CASES = (
    Case('no markers', 'markers', 'absent', 'marker_rate 0', (), 'no markers', program=MARKERS,
         parameters=('_rate:=0.0',)),
    Case('nobody listens', 'markers', 'idle', 'no subscriber', (), 'no markers', program=MARKERS,
         parameters=('_rate:=15.0',)),
    Case('markers', 'markers', 'working', 'a subscriber', (), 'no markers', program=MARKERS,
         parameters=('_rate:=15.0', '_listens:=true')),
)
