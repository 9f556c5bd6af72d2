"""Prints the references of the tests of dry friction: midpoint steps extrapolated in 30 digits, without Taylor series.

    pip install mpmath==1.3.0
    python3 scripts/friction_reference.py [step]

With half the step, 2e-4, all digits that the tests use stay the same.
"""

import sys

from mpmath import exp, findroot, matrix, mp, mpf, sign

mp.dps = 30
STEP = mpf(sys.argv[1] if len(sys.argv) > 1 else "4e-4")  # s
COLUMNS = 8  # of the extrapolation: order 16


def extrapolated(derivative, z, span):
    """`z` after `span` by Gragg's midpoint rule, extrapolated (Hairer, Norsett, Wanner 1993, section II.9)."""
    table = []
    for column in range(1, COLUMNS + 1):
        count = 2 * column
        h = span / count
        before, now = z, [a + h * d for a, d in zip(z, derivative(z))]
        for _ in range(count - 1):
            before, now = now, [a + 2 * h * d for a, d in zip(before, derivative(now))]
        last = [(a + b + h * d) / 2 for a, b, d in zip(before, now, derivative(now))]
        row = [last]
        for back in range(1, column):
            ratio = (mpf(column) / (column - back)) ** 2 - 1
            row.append([a + (a - b) / ratio for a, b in zip(row[-1], table[-1][back - 1])])
        table.append(row)
    return table[-1][-1]


def run(rate, mass, force, state, law, until):
    """From `state` at time 0 to `until`: the events, the last state and the energy that friction dissipated."""
    static, coulomb, speed = law
    size = len(state)
    time, burnt, events = mpf(0), mpf(0), []

    def others(z):
        return mass * sum(rate[size - 1, j] * z[j] for j in range(size)) + force

    def motion(sense):
        def derivative(z):
            rows = [sum(rate[i, j] * z[j] for j in range(size)) for i in range(size)]
            if sense == 0:
                return rows[:-2] + [mpf(0), mpf(0), mpf(0)]
            friction = coulomb + (static - coulomb) * exp(-((z[size - 1] / speed) ** 2))
            return rows[:-1] + [(others(z) - sense * friction) / mass, friction * sense * z[size - 1]]

        return derivative

    v = state[-1]
    sense = sign(v) if v != 0 else sign(others(state)) * (abs(others(state)) > static)
    while time < until:
        derivative = motion(sense)
        if sense == 0:
            margin = lambda z: static - abs(others(z[:size]))
        else:
            margin = lambda z: sense * z[size - 1]
        begin = list(state) + [burnt]
        step = min(STEP, until - time)
        end = extrapolated(derivative, begin, step)
        # No phase is shorter than a step in these scenes: half the step finds the same events.
        if margin(end) >= 0:
            state, burnt, time = end[:size], end[size], time + step
            continue
        after = lambda t: margin(extrapolated(derivative, begin, t))
        least = step / 10**6
        root = findroot(after, (least, step), solver="anderson", tol=mpf(10) ** -48)
        end = extrapolated(derivative, begin, root)
        state, burnt, time = end[:size], end[size], time + root
        if sense == 0:
            sense = sign(others(state))
            events.append((time, "Slip"))
        else:
            state[-1] = mpf(0)
            onward = abs(others(state)) > static
            events.append((time, "Reverse" if onward else "Stick"))
            sense = sign(others(state)) if onward else 0
    return events, state, burnt


def show(name, result):
    events, state, burnt = result
    print(name)
    for time, kind in events:
        print("   ", mp.nstr(time, 20), kind)
    print("    state", [mp.nstr(x, 20) for x in state], "heat", mp.nstr(burnt, 20))


def block():
    mass, damping, stiffness = mpf("0.5"), mpf("0.3"), mpf(100)
    rate = matrix([[0, 1], [-stiffness / mass, -damping / mass]])
    law = mpf(2), mpf(1), mpf("0.05")
    start = [mpf("-0.06"), mpf(0)]
    return run(rate, mass, mpf(0), start, law, mpf(1))


def linked(law, until):
    m1, b1, k1 = mpf("0.1"), mpf("0.2"), mpf(50)
    m2, b2 = mpf("0.2"), mpf("0.01")
    k, b = mpf(300), mpf("0.1")
    rate = matrix(
        [
            [0, 1, 0, 0],
            [-(k1 + k) / m1, -(b1 + b) / m1, k / m1, b / m1],
            [0, 0, 0, 1],
            [k / m2, b / m2, -k / m2, -(b2 + b) / m2],
        ]
    )
    start = [mpf("-0.004"), mpf("0.5"), mpf("-0.004"), mpf(0)]
    return run(rate, m2, mpf("-0.1"), start, law, until)


if __name__ == "__main__":
    show("block", block())
    show("linked, Coulomb", linked((mpf("0.5"), mpf("0.5"), mpf("0.01")), mpf("0.3")))
    show("linked, Stribeck", linked((mpf("0.6"), mpf("0.3"), mpf("0.01")), mpf("0.3")))
