#!/usr/bin/env python3
"""The map of `lab/benches/map` in NumPy and, where it is installed, in JAX: rollout-steps per second of one core.

A 1 kHz servo over a 100 Hz wall for 2 s, LOLC over held work with a cap of 0.5, 256 by 256 cells of stiffness and
damping. Each tick: exact motion of the mass, held wall, observer, controller, largest deflection. Times are processor
times, summed over all threads, so that a library that uses all cores gets no advantage.

    python3 scripts/map_numpy.py            # needs numpy; jax is used if it is there
"""

import time

import numpy as np

SIDE, SAMPLES, HOLD = 256, 200, 10
STEPS = SIDE * SIDE * SAMPLES * HOLD
MASS, DAMPING, SPRING, PERIOD, CAP = 0.3, 0.201, 50.0, 1e-3, 0.5
CHUNK = 2048


def motion():
    """Position and velocity after a period, per unit of position, velocity and held force."""
    decay = DAMPING / (2 * MASS)
    omega = np.sqrt(SPRING / MASS - decay**2)
    shrink, s, c = np.exp(-decay * PERIOD), np.sin(omega * PERIOD), np.cos(omega * PERIOD)
    xx, xv = shrink * (c + decay / omega * s), shrink * s / omega
    vx, vv = -SPRING / MASS * xv, shrink * (c - decay / omega * s)
    return xx, xv, vx, vv, (xx - 1) / SPRING, vx / SPRING


def cells(kind):
    stiffness = np.repeat(100 + 49900 * np.arange(SIDE) / (SIDE - 1), SIDE)
    damping = np.tile(100 * np.arange(SIDE) / (SIDE - 1), SIDE)
    return stiffness.astype(kind), damping.astype(kind)


def tick(lib, state, wall, credit, numbers):
    """One tick at the servo's rate; `lib` is numpy or jax.numpy."""
    x, v, before, total, acted, most = state
    xx, xv, vx, vv, xf, vf, limit = numbers
    moved = x - before
    square = moved * moved
    total = total + (acted * moved + credit * square)
    active = (total < 0) & (square > 1e-24)
    pull = -total / lib.where(active, moved, 1)
    cap = limit * moved
    pull = lib.where(lib.abs(pull) > lib.abs(cap), cap, pull)
    force = wall + lib.where(active, pull, 0)
    new, speed = xx * x + xv * v + xf * force, vx * x + vv * v + vf * force
    return new, speed, x, total, force, lib.maximum(most, lib.abs(new))


def sample(lib, state, stiffness, damping, rate):
    """Force of the wall, once for every `HOLD` ticks, and the credit of its damper meanwhile."""
    inside = state[0] > 0
    wall = lib.where(inside, lib.maximum(stiffness * state[0] + damping * (state[0] - state[2]) * rate, 0), 0)
    return wall, lib.where(inside, damping * rate, 0)


def numbers(kind):
    return [kind(value) for value in (*motion(), CAP * MASS / PERIOD / PERIOD)]


def in_numpy(kind):
    stiffness, damping = cells(kind)
    fixed = numbers(kind)

    def run():
        worst = []
        for at in range(0, SIDE * SIDE, CHUNK):
            k, b = stiffness[at : at + CHUNK], damping[at : at + CHUNK]
            zero = np.zeros_like(k)
            state = (zero - kind(0.004), zero, zero - kind(0.004), zero, zero, zero)
            for _ in range(SAMPLES):
                wall, credit = sample(np, state, k, b, kind(1 / PERIOD))
                for _ in range(HOLD):
                    state = tick(np, state, wall, credit, fixed)
            worst.append(state[5])
        return np.concatenate(worst)

    return run


def in_jax(kind):
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)
    stiffness, damping = (jnp.asarray(it).reshape(-1, CHUNK) for it in cells(kind))
    fixed = numbers(kind)

    def chunk(both):
        k, b = both
        zero = jnp.zeros_like(k)
        start = (zero - kind(0.004), zero, zero - kind(0.004), zero, zero, zero)

        def outer(state, _):
            wall, credit = sample(jnp, state, k, b, kind(1 / PERIOD))
            inner = lambda state, _: (tick(jnp, state, wall, credit, fixed), None)
            return jax.lax.scan(inner, state, None, length=HOLD, unroll=HOLD)[0], None

        return jax.lax.scan(outer, start, None, length=SAMPLES)[0][5]

    run = jax.jit(lambda k, b: jax.lax.map(chunk, (k, b)))
    return lambda: np.asarray(run(stiffness, damping)).reshape(-1)


def timed(name, run, rounds):
    worst = run()
    best = min(cost(run) for _ in range(rounds))
    bounded = int((worst < 0.04).sum())
    print(f"{name:12} {STEPS / best / 1e6:8.1f} M rollout-steps per core-second, {bounded} cells within 40 mm")


def cost(run):
    began = time.process_time()
    run()
    return time.process_time() - began


if __name__ == "__main__":
    np.seterr(all="ignore")
    for kind in (np.float32, np.float64):
        timed(f"numpy {kind.__name__[-2:]}", in_numpy(kind), 2)
    try:
        import jax  # noqa: F401
    except ImportError:
        print("jax is not installed")
    else:
        for kind in (np.float32, np.float64):
            timed(f"jax {kind.__name__[-2:]}", in_jax(kind), 5)
