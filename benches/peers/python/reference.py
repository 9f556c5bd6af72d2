"""Reference ../reference.txt: the positions of the scene at its 201 instants, in metres.

    benches/peers/python/install.sh
    target/peers-python/bin/python benches/peers/python/reference.py > benches/peers/reference.txt

The parameters are the decimal numbers of scenes/paper-8k-none.toml, the velocity is the plant's own. Each period is
the Taylor series of the matrix exponential under the held force. Everything is computed with 60 and again with 120
digits; the printed digits agree to 40. Nothing of lyapunov is used.
"""

import sys

import mpmath
from mpmath import mpf

INSTANTS = 201


def positions(digits):
    mpmath.mp.dps = digits
    mass, damping, stiffness = mpf("0.1") + mpf("0.2"), mpf("0.2") + mpf("0.001"), mpf(50)
    wall_stiffness, wall_damping = mpf(8000), mpf(2)
    period = 1 / mpf(100)
    # Position, velocity and the held force.
    rate = mpmath.matrix([[0, 1, 0], [-stiffness / mass, -damping / mass, -1 / mass], [0, 0, 0]])
    over_a_period = mpmath.expm(rate * period, method="taylor")
    state = mpmath.matrix([mpf("-0.004"), 0, 0])
    instants = []
    for _ in range(INSTANTS):
        position, velocity = state[0], state[1]
        instants.append(position)
        force = max(mpf(0), wall_stiffness * position + wall_damping * velocity) if position > 0 else mpf(0)
        state[2] = force
        state = over_a_period * state
    return instants


def main():
    few, many = positions(60), positions(120)
    apart = max(abs(one - other) for one, other in zip(few, many))
    if apart > mpf("1e-40"):
        sys.exit(f"60 digits are not enough: {mpmath.nstr(apart, 3)} m apart")
    for position in many:
        print(mpmath.nstr(position, 40, min_fixed=0, max_fixed=0))


main()
