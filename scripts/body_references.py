"""Prints the references of tests/properties/linked and of tests/properties/perturbed.rs.

    python3 -m venv venv && venv/bin/pip install mpmath==1.3.0
    venv/bin/python scripts/body_references.py

Every motion is computed from its equation in positions and velocities, with 150 digits, tick by tick, by the Taylor
series of the matrix exponential. Parameters are the numbers that an f64 holds, and so are the matrices of the first
part. Nothing of lyapunov is used.
"""

import mpmath
from mpmath import mpf

mpmath.mp.dps = 150


def grown(matrix):
    return mpmath.expm(matrix, method="taylor")


def show(name, values):
    print(name, "[" + ", ".join(mpmath.nstr(mpf(value), 17, min_fixed=0, max_fixed=0) for value in values) + "],")


# mass, damping, stiffness of the operator; mass, damping of the device; stiffness, damping of the link; rate.
LINKED = {
    "soft": (0.1, 0.2, 50.0, 0.2, 0.001, 5000.0, 1.0, 1000.0),
    "stiff, undamped": (0.1, 0.0, 50.0, 0.2, 0.0, 1e6, 0.0, 100.0),
    "stiff, damped": (0.1, 0.2, 50.0, 0.2, 0.001, 1e6, 30.0, 100.0),
    "overdamped": (0.1, 0.2, 50.0, 0.2, 0.001, 1e6, 1e4, 100.0),
    "heavy operator": (1e3, 20.0, 5e4, 1e-3, 1e-3, 1e6, 0.0, 100.0),
    "heavy device": (1e-3, 0.0, 50.0, 1e3, 0.0, 1e6, 0.0, 100.0),
    "heavy operator, damped": (1.0, 0.2, 50.0, 1e-6, 1e-3, 1e6, 1.0, 100.0),
    "heavy device, damped": (1e-6, 0.2, 50.0, 1.0, 1e-3, 1e6, 10.0, 100.0),
}


def held_input(parts):
    """exp(A) - 1 of the matrix of f64 that centre, stretch, their velocities and a held effort obey."""
    mo, bo, kh, md, bd, kl, bl, rate = parts
    both, t = mo + md, 1.0 / rate
    share_o, share_d = md / both, mo / both
    rows = [
        [0.0, 0.0, 1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0, 1.0, 0.0],
        [-kh / both, -kh * share_o / both, -(bo + bd) / both, (bd * share_d - bo * share_o) / both, -1.0 / both],
        [
            -kh / mo,
            -(kh * share_o / mo + kl / mo + kl / md),
            bd / md - bo / mo,
            -(bo * share_o / mo + bd * share_d / md + bl / mo + bl / md),
            1.0 / md,
        ],
        [0.0] * 5,
    ]
    matrix = mpmath.matrix([[mpf(entry * t) for entry in row] for row in rows])
    return grown(matrix) - mpmath.eye(5)


class Linked:
    """State: positions and velocities of operator and device."""

    def __init__(self, parts, start, velocity):
        self.state = [mpf(start), mpf(start), mpf(velocity), mpf(velocity)]
        self.made_of(parts)

    def made_of(self, parts):
        mo, bo, kh, md, bd, kl, bl, rate = map(mpf, parts)
        # Columns: the four states, and the forces on operator and device.
        matrix = mpmath.matrix(
            [
                [0, 0, 1, 0, 0, 0],
                [0, 0, 0, 1, 0, 0],
                [-(kh + kl) / mo, kl / mo, -(bo + bl) / mo, bl / mo, 1 / mo, 0],
                [kl / md, -kl / md, bl / md, -(bd + bl) / md, 0, 1 / md],
                [0] * 6,
                [0] * 6,
            ]
        )
        self.stiffness = kh
        self.map = grown(matrix * mpf(1.0 / parts[-1]))

    def advance(self, rest, force):
        column = mpmath.matrix(self.state + [self.stiffness * mpf(rest), mpf(force)])
        self.state = list((self.map * column)[:4])


class Body:
    """State: position and velocity."""

    def __init__(self, parts, start, velocity):
        self.state = [mpf(start), mpf(velocity)]
        self.made_of(parts)

    def made_of(self, parts):
        mass, damping, stiffness, rate = map(mpf, parts)
        matrix = mpmath.matrix([[0, 1, 0], [-stiffness / mass, -damping / mass, 1 / mass], [0, 0, 0]])
        self.stiffness = stiffness
        self.map = grown(matrix * mpf(1.0 / parts[-1]))

    def advance(self, rest, force):
        column = mpmath.matrix(self.state + [self.stiffness * mpf(rest) + mpf(force)])
        self.state = list((self.map * column)[:2])


def effort(tick):
    return 0.5 * (tick * 7 % 5 - 1.5)


def run(plant, ticks, rest=lambda n: 0.0, push=lambda n: 0.0, changes={}):
    """The states at a third of the ticks and at the end, and the largest magnitude of each."""
    most, seen = [abs(part) for part in plant.state], []
    for tick in range(ticks):
        if tick in changes:
            plant.made_of(changes[tick])
        plant.advance(rest(tick), push(tick) - mpf(effort(tick)))
        most = [max(old, abs(new)) for old, new in zip(most, plant.state)]
        if tick + 1 in (ticks // 3, ticks):
            seen.append(plant.state)
    return seen, most


def scene(name, *arguments, **named):
    seen, most = run(*arguments, **named)
    print(f"// {name}")
    for label, values in (("third", seen[0]), ("end", seen[1]), ("most", most)):
        show(f"{label}:", values)


print("## held_input")
for name, parts in LINKED.items():
    print(f"// {name}")
    increment = held_input(parts)
    for row in range(4):
        show("", [increment[row, column] for column in range(5)])

print("## Linked")
for name, parts in LINKED.items():
    scene(name, Linked(parts, -0.004, 0.1), 300, rest=lambda n: 0.001)

# A load of 1.5 N, a pulse of 4 N from 0.1 s for 0.05 s, a hand that moves to and fro by 1 cm at 3 Hz about 2 mm, and a
# grip that is firm from 0.12 s and loose from 0.2 s on.
RATE = 1000.0
PUSH = lambda n: 1.5 + (4.0 if 100 <= n < 150 else 0.0)
REST = lambda n: mpf(0.002) + mpf(0.01) * mpmath.sin(2 * mpmath.pi * 3 * n / mpf(RATE))
BODY = (0.3, 0.201, 50.0, RATE)
LINK = LINKED["soft"]

print("## scenes")
scene(
    "one mass", Body(BODY, -0.004, 0.0), 300, rest=REST, push=PUSH,
    changes={120: (0.3, 2.001, 400.0, RATE), 200: (0.3, 0.101, 20.0, RATE)},
)
scene(
    "two masses", Linked(LINK, -0.004, 0.0), 300, rest=REST, push=PUSH,
    changes={120: (0.1, 2.0, 400.0) + LINK[3:], 200: (0.1, 0.1, 20.0) + LINK[3:]},
)
