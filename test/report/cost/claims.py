"""What must hold of the cost, on any machine."""

# Instructions in a step that a feature may take which the scene has and which has nothing to do, as a share of all.
IDLE_SHARE = 0.3

TOUCHING = tuple((feature, state) for feature in ('contact', 'self-contact') for state in ('idle', 'working'))
DRAWN = ('markers', 'working')  # the first message asks the mesh for its surface

# Of each stage: the cases that run it, by feature and state. In all others it must not run.
USERS = {
    'cut': (('cracks', 'working'), ('fracture', 'working'), ('tool', 'working'), DRAWN),
    'surface': (*TOUCHING, DRAWN),
    'fracture': (('fracture', 'idle'), ('fracture', 'working')),
    'contact': TOUCHING,
    'tool': (('tool', 'idle'), ('tool', 'working')),
}

# Places and poses, which the tool shares with the obstacles.
SHARED = ('contact/pose',)


def inside(case, stage):
    """Instructions a step in the functions of a stage, of one of its files, or of a name."""
    return sum(count for name, count in case['functions'].items()
               if (name == stage or name.startswith(f'{stage}/')) and name not in SHARED)


def equals(claim, value, wanted):
    return {'claim': claim, 'measured': f'{value:g}', 'wanted': f'{wanted:g}', 'holds': value == wanted}


def above(claim, value, bound):
    return {'claim': claim, 'measured': f'{value:.3g}', 'wanted': f'> {bound:g}', 'holds': value > bound}


def below(claim, value, bound):
    return {'claim': claim, 'measured': f'{value:.3g}', 'wanted': f'< {bound:g}', 'holds': value < bound}


def nothing_runs(cases):
    """A stage that the scene does not ask for does not run; where it is asked for, that is seen."""
    for stage, users in USERS.items():
        using = [case for case in cases.values() if (case['feature'], case['state']) in users]
        others = [case for case in cases.values() if case not in using]
        yield equals(f'instructions a step in `src/{stage}/`, the most of {len(others)} scenes that do not use it',
                     max(inside(case, stage) for case in others), 0)
        yield above(f'the same, the least of {len(using)} scenes that do', min(inside(case, stage) for case in using),
                    0)


def linear(cases):
    for name, text in (('fem/rotation', 'extract rotations'), ('factorisation', 'factorise')):
        yield equals(f'without warping: instructions a step that {text}', inside(cases['linear'], name), 0)
        yield above('the same, with warping', inside(cases['warped'], name), 0)


def lumped(cases):
    yield equals('with a lumped mass: instructions a step that multiply by a mass matrix',
                 inside(cases['plain'], 'consistent mass'), 0)
    yield above('the same, with a consistent mass', inside(cases['consistent'], 'consistent mass'), 0)


def idle(cases):
    quiet = [case for case in cases.values() if case['state'] != 'working' and case['feature'] != 'markers']
    yield equals(f'allocations a step, the most of {len(quiet)} scenes in which no feature is at work',
                 max(case['allocations'] for case in quiet), 0)
    plain = cases['plain']['instructions']
    yield below('cuts that have not come yet: instructions a step above none',
                abs(cases['cut waits']['instructions'] - plain), 1000)
    yield equals('fracture, idle: instructions a step that extract rotations, above those without',
                 inside(cases['fracture waits'], 'fem/rotation') - inside(cases['plain'], 'fem/rotation'), 0)
    for key in ('fracture waits', 'ground below', 'one piece', 'tool still', 'tool away'):
        case = cases[key]
        yield below(f"{case['feature']}, {case['text']}: share by which instructions grow",
                    case['instructions'] / plain - 1, IDLE_SHARE)


def markers(cases):
    for key in ('no markers', 'nobody listens'):
        yield equals(f"markers, {cases[key]['text']}: instructions a step that build messages",
                     inside(cases[key], 'ros/markers'), 0)
    yield above('the same, with a subscriber', inside(cases['markers'], 'ros/markers'), 0)
    yield below('markers, no subscriber: instructions a step above those of marker_rate 0',
                cases['nobody listens']['instructions'] - cases['no markers']['instructions'], 10000)


def check(cases):
    return [*nothing_runs(cases), *linear(cases), *lumped(cases), *idle(cases),
            *(markers(cases) if 'markers' in cases else ())]
