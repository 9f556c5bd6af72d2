"""Prints the references of lab/tests/bounds/exact.rs.

    python3 -m venv venv && venv/bin/pip install mpmath==1.3.0
    venv/bin/python scripts/bounds_references.py

Each loop is composed tick by tick with 60 digits: the masses by the matrix exponential, the previous position as a
state of its own, the delay as a row of registers, the hold as a register that every r-th tick overwrites. The stiffness
at which the spectral radius of the map over r ticks passes 1 is found by halving an interval. Parameters are the
numbers that an f64 holds. Nothing of lyapunov is used.
"""

import mpmath
from mpmath import mpf, matrix

mpmath.mp.dps = 60

# name: rate, ratio, delay, cutoff (0: difference, -1: exact), device (m, b), operator (m, b, k), link (k, b) or None,
# damping and mass of the environment, a stiffness below the limit and one above it
CASES = {
    "small": (1000.0, 1, 0, 0.0, (1.0, 1e-5), (0.0, 0.0, 0.0), None, 0.0, 0.0, 1e-2, 3e-2),
    "smaller": (1000.0, 1, 0, 0.0, (1.0, 1e-8), (0.0, 0.0, 0.0), None, 0.0, 0.0, 1e-5, 3e-5),
    "held": (100.0, 1, 0, 0.0, (0.25, 2.5e-7), (0.05, 0.0, 50.0), None, 0.0, 0.0, 3e-5, 9e-5),
    "late": (1000.0, 1, 2, 0.0, (1.0, 1e-5), (0.0, 0.0, 0.0), None, 0.0, 0.0, 3e-3, 5e-3),
    "slow": (1000.0, 10, 13, 0.0, (0.2, 2e-6), (0.0, 0.0, 20.0), None, 0.0, 0.0, 1e-4, 5e-4),
    "damped": (1000.0, 1, 0, 0.0, (0.2, 0.1), (0.1, 0.2, 50.0), None, 2.0, 0.0, 2000.0, 9000.0),
    "exact": (1000.0, 1, 1, -1.0, (0.2, 0.1), (0.1, 0.2, 50.0), None, 2.0, 0.0, 500.0, 4000.0),
    "filtered": (1000.0, 5, 3, 80.0, (0.2, 0.1), (0.0, 0.5, 0.0), None, 1.0, 0.0, 50.0, 600.0),
    "linked": (1000.0, 2, 1, 0.0, (0.2, 1e-6), (0.1, 1e-6, 50.0), (900.0, 1e-6), 0.0, 0.0, 1e-4, 2e-3),
    "heavy": (1000.0, 2, 0, 0.0, (0.2, 0.3), (0.1, 0.2, 50.0), None, 1.0, 0.02, 300.0, 4000.0),
    "overdamped": (1000.0, 50, 8, 0.0, (0.0288, 0.0021), (0.1052, 2375.5, 0.0968), (3.55e-7, 52.0), 0.0019, 4.84e-5, 1000.0, 3200.0),
    "light": (1000.0, 50, 6, 0.0, (0.0077, 1.006), (0.00096, 1.54e-5, 54.6), (5645.0, 1.124), 0.0, 8.54e-6, 50.0, 213.85),
}


def rates(device, operator, link):
    (m, b), (mo, bo, ko) = device, operator
    if link is None:
        m, b = m + mo, b + bo
        return matrix([[0, 1, 0], [-ko / m, -b / m, -1 / m], [0, 0, 0]])
    kl, bl = link
    return matrix([
        [0, 1, 0, 0, 0],
        [-kl / m, -(b + bl) / m, kl / m, bl / m, -1 / m],
        [0, 0, 0, 1, 0],
        [kl / mo, bl / mo, -(ko + kl) / mo, -(bo + bl) / mo, 0],
        [0, 0, 0, 0, 0],
    ])


def period_map(case, stiffness):
    rate, ratio, delay, cutoff, device, operator, link, damping, mass = case[:9]
    device, operator = [tuple(map(mpf, it)) for it in (device, operator)]
    link = link and tuple(map(mpf, link))
    period = 1 / mpf(rate)
    step = mpmath.expm(rates(device, operator, link) * period, method="taylor")
    moving = step.rows - 1
    # masses, previous position, filtered velocity, the environment's previous velocity, held force, delay line
    before, filtered, last, held, line = range(moving, moving + 5)
    size = line + delay

    def unit(index):
        return matrix([[1 if at == index else 0 for at in range(size)]])

    rows = [unit(at) for at in range(size)]
    share = None
    if cutoff > 0:
        turn = 2 * mpf(float.fromhex("0x1.921fb54442d18p+1")) * mpf(cutoff) * period
        share = turn / (1 + turn)
    for tick in range(ratio):
        # Contents of the registers at this tick, as rows over the state at the first tick of the period.
        position = rows[0]
        if cutoff < 0:
            velocity = rows[1]
        else:
            velocity = (position - rows[before]) / period
            if share is not None:
                velocity = rows[filtered] + (velocity - rows[filtered]) * share
        rows[filtered] = velocity
        if tick == 0:
            force = position * mpf(stiffness) + velocity * mpf(damping)
            if mass:
                force += (velocity - rows[last]) * mpf(mass) / (period * ratio)
            rows[last], rows[held] = velocity, force
        acting = rows[held]
        if delay:
            acting = rows[line]
            for at in range(line, size - 1):
                rows[at] = rows[at + 1]
            rows[size - 1] = rows[held]
        rows[before] = position
        state = rows[:moving] + [acting]
        rows[:moving] = [
            sum((state[at] * step[row, at] for at in range(1, moving + 1)), state[0] * step[row, 0])
            for row in range(moving)
        ]
    return matrix([[row[at] for at in range(size)] for row in rows])


def radius(case, stiffness):
    values = mpmath.eig(period_map(case, stiffness), left=False, right=False)
    return max(abs(value) for value in values)


for name, case in CASES.items():
    low, high = map(mpf, case[9:])
    assert radius(case, low) < 1 < radius(case, high), (name, radius(case, low), radius(case, high))
    for step in range(1, 12):
        # The spectral radius stays below 1 up to the lower stiffness.
        assert radius(case, low * step / 12) < 1, (name, step)
    for _ in range(70):
        middle = (low + high) / 2
        if radius(case, middle) < 1:
            low = middle
        else:
            high = middle
    print(name, mpmath.nstr(low, 17), mpmath.nstr(radius(case, mpf(case[9])), 20))
