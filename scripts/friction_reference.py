"""The reference numbers of tests/properties/friction.rs: mpmath's Taylor integrator to 30 digits.

    pip install mpmath==1.3.0
    python3 scripts/friction_reference.py
"""

from mpmath import mp, mpf, odefun, findroot, exp, sign, matrix

mp.dps = 30


def run(rate, mass, force, state, law, until):
    """From `state` at time 0 to `until`: the events, the last state and what friction burnt."""
    static, coulomb, speed = law
    size = len(state)
    time, burnt, events = mpf(0), mpf(0), []

    def others(z):
        return mass * sum(rate[size - 1, j] * z[j] for j in range(size)) + force

    def motion(sense):
        def derivative(_, z):
            rows = [sum(rate[i, j] * z[j] for j in range(size)) for i in range(size)]
            if sense == 0:
                return rows[:-2] + [mpf(0), mpf(0), mpf(0)]
            friction = coulomb + (static - coulomb) * exp(-((z[size - 1] / speed) ** 2))
            return rows[:-1] + [(others(z) - sense * friction) / mass, friction * sense * z[size - 1]]

        return derivative

    v = state[-1]
    sense = sign(v) if v != 0 else sign(others(state)) * (abs(others(state)) > static)
    while time < until:
        solution = odefun(motion(sense), 0, list(state) + [mpf(0)], tol=mpf(10) ** -26)
        if sense == 0:
            margin = lambda t: static - abs(others(solution(t)[:size]))
        else:
            margin = lambda t: sense * solution(t)[size - 1]
        # Scan for the first fall of the margin; the scenes are slow against this step.
        step, at, end = mpf("1e-3"), mpf(0), until - time
        while at < end and not (at > 0 and margin(at) < 0):
            at += step
        root = None
        if margin(min(at, end)) < 0:
            low, high = max(at - step, mpf("1e-9")), min(at, end)
            root = findroot(margin, (low, high), solver="anderson", tol=mpf(10) ** -50)
        z = solution(end if root is None else root)
        state, burnt = [z[i] for i in range(size)], burnt + z[size]
        if root is None:
            break
        time += root
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
