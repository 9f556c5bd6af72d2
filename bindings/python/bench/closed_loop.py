"""A closed-loop ensemble in one call, beside the same in NumPy and in jitted JAX, and the memory's bandwidth for recorded batches.

    python bindings/python/bench/closed_loop.py [rounds]        # JAX takes part where it is installed

4096 loops of a mass on a hand against a wall that is sampled at every tick, POPC over held work, 2000 ticks at 1 kHz. All take turns in
one process and may use all cores; told are medians over the rounds, of wall time and, as other work on a machine does not change that,
of the processor time of all threads. They agree on every loop before anything is timed.
"""

import statistics
import sys
import time

import lyapunov as ly
import numpy as np

LOOPS, TICKS, PERIOD, LIMIT = 4096, 2000, 1e-3, 50.0
MASS, DAMPING, STIFFNESS = 0.3, 0.201, 50.0
START, WALL_DAMPING = -0.004, 2.0


def motion():
    """Position and velocity after a period, per unit of position, velocity and held force."""
    decay = DAMPING / (2 * MASS)
    natural = np.sqrt(STIFFNESS / MASS - decay**2)
    shrink, s, c = np.exp(-decay * PERIOD), np.sin(natural * PERIOD), np.cos(natural * PERIOD)
    xx, xv = shrink * (c + decay / natural * s), shrink * s / natural
    vx, vv = -STIFFNESS / MASS * xv, shrink * (c - decay / natural * s)
    return xx, xv, vx, vv, (xx - 1) / STIFFNESS, vx / STIFFNESS


NUMBERS = motion()


def tick(lib, state, wall_stiffness):
    """One tick; `lib` is numpy or jax.numpy."""
    x, v, before, energy, acted, largest = state
    xx, xv, vx, vv, xf, vf = NUMBERS
    moved = x - before
    speed = moved / PERIOD
    wall = lib.where(x > 0, lib.maximum(wall_stiffness * x + WALL_DAMPING * speed, 0), 0)
    energy = energy + acted * moved
    square = speed * speed * PERIOD
    acts = (energy < 0) & (square > 2.3e-308)
    alpha = lib.where(acts, lib.minimum(-energy / lib.where(acts, square, 1.0), LIMIT), 0.0)
    force = wall + alpha * speed
    new, rate = xx * x + xv * v + xf * force, vx * x + vv * v + vf * force
    return new, rate, x, energy, force, lib.maximum(largest, lib.abs(new))


def start(lib, wall_stiffness):
    zero = lib.zeros_like(wall_stiffness)
    return zero + START, zero, zero + START, zero, zero, zero


def in_numpy(wall_stiffness):
    state = start(np, wall_stiffness)
    for _ in range(TICKS):
        state = tick(np, state, wall_stiffness)
    return state[0]


def in_jax():
    import jax

    jax.config.update("jax_enable_x64", True)
    import jax.numpy as jnp

    def run(wall_stiffness):
        body = lambda _, state: tick(jnp, state, wall_stiffness)  # noqa: E731
        return jax.lax.fori_loop(0, TICKS, body, start(jnp, wall_stiffness), unroll=4)[0]

    def chunked(wall_stiffness):
        # What is in a cache stays there.
        return jax.lax.map(run, wall_stiffness.reshape(-1, 512)).reshape(-1)

    whole, chunks = jax.jit(run), jax.jit(chunked)
    return {
        "JAX, all loops at once": lambda wall: np.asarray(whole(wall)),
        "JAX, chunks of 512 loops": lambda wall: np.asarray(chunks(wall)),
    }


def ours(wall_stiffness):
    told = ly.closed_loop(
        TICKS,
        PERIOD,
        mass=MASS,
        damping=DAMPING,
        stiffness=STIFFNESS,
        position=START,
        wall_stiffness=wall_stiffness,
        wall_damping=WALL_DAMPING,
        stabilizer=ly.Stabilizer("popc", limit=LIMIT),
    )
    return told["position"]


def timed(call, *given):
    """Wall time and processor time of all threads, s."""
    began, busy = time.perf_counter(), time.process_time()
    call(*given)
    return time.perf_counter() - began, time.process_time() - busy


def recorded(rounds):
    """Bytes a second that a batch reads and writes, beside those of a copy in NumPy."""
    loops, ticks = LOOPS, 500
    of = np.random.default_rng(1)
    log = [of.normal(0.0, 1.0, (ticks, loops)) for _ in range(3)]
    target = np.empty_like(log[0])
    moved = 3 * log[0].nbytes + 4 * log[0].nbytes + log[0].size
    batch = ly.Batch(ly.Stabilizer("popc", limit=LIMIT), loops, PERIOD)
    pairs = [(timed(batch.stabilize, *log)[0], timed(np.copyto, target, log[0])[0]) for _ in range(rounds)]
    mine = statistics.median(moved / one for one, _ in pairs)
    copied = statistics.median(2 * log[0].nbytes / other for _, other in pairs)
    print(f"recorded batch: {mine / 1e9:.2f} GB/s, {100 * mine / copied:.0f} % of a copy of one thread ({copied / 1e9:.2f} GB/s)")


def main():
    rounds = int(sys.argv[1]) if len(sys.argv) > 1 else 7
    wall_stiffness = np.linspace(100.0, 3000.0, LOOPS)
    cases = {"this package": ours, "NumPy": in_numpy}
    try:
        cases |= in_jax()
    except ImportError:
        print("SKIPPED: JAX is not installed")
    expected = in_numpy(wall_stiffness)
    for name, run in cases.items():
        assert np.abs(run(wall_stiffness) - expected).max() < 1e-6, name
    times = {name: [] for name in cases}
    for _ in range(rounds):
        for name, run in cases.items():
            # Not timed: it wakes the cores that slept through the one before.
            run(wall_stiffness)
            times[name].append(timed(run, wall_stiffness))
    mine = times["this package"]
    for name, told in times.items():
        wall, processor = (1e3 * statistics.median(column) for column in zip(*told))
        ratios = [statistics.median(other[at] / one[at] for one, other in zip(mine, told)) for at in (0, 1)]
        print(f"{name:26} {wall:8.1f} ms, {ratios[0]:6.1f} times this package's; processor {processor:8.1f} ms, {ratios[1]:6.1f} times")
    recorded(rounds)


if __name__ == "__main__":
    main()
