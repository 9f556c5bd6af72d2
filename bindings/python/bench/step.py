"""What a tick through Python costs, beside the interpreter's own call, an empty call into Rust, and POPC in NumPy and in plain Python.

    python bindings/python/bench/step.py

All take turns in one process; told is the median over the rounds, in nanoseconds of the processor, which other work on the machine does not
change.
"""

import statistics
import time

import lyapunov as ly
import numpy as np

CALLS, ROUNDS = 20_000, 31
PERIOD, LIMIT = 1e-3, 100.0


def nothing(position, applied):
    return applied


class InPython:
    """POPC over held work in plain floats."""

    def __init__(self):
        self.energy, self.before = 0.0, 0.0

    def step(self, position, applied, effort):
        moved = position - self.before
        self.before = position
        velocity = moved / PERIOD
        self.energy += applied * moved
        square = velocity * velocity * PERIOD
        alpha = 0.0
        if self.energy < 0.0 and square > 2.3e-308:
            alpha = min(-self.energy / square, LIMIT)
        return effort + alpha * velocity


class InNumpy:
    """The same on several axes, as one writes it with arrays."""

    def __init__(self, axes):
        self.energy, self.before = 0.0, np.zeros(axes)

    def step(self, position, applied, effort):
        moved = position - self.before
        self.before = position
        velocity = moved / PERIOD
        self.energy += applied @ moved
        square = velocity @ velocity * PERIOD
        alpha = 0.0
        if self.energy < 0.0 and square > 2.3e-308:
            alpha = min(-self.energy / square, LIMIT)
        return effort + alpha * velocity


def ours(axes):
    readings, popc = ly.Readings(PERIOD, axes=axes), ly.Stabilizer("popc", limit=LIMIT, axes=axes)
    read, stabilize = readings.read, popc.stabilize
    return lambda position, applied, effort: stabilize(read(position, applied), effort).effort


class InRust:
    """The same POPC with its candidate in Python."""

    def decrease(self, sample):
        return sample.work


def own():
    readings, popc = ly.Readings(PERIOD), ly.Stabilizer("lolc", limit=LIMIT, candidate=InRust())
    return lambda position, applied, effort: popc.stabilize(readings.read(position, applied), effort).effort


def timed(call, given):
    began = time.thread_time_ns()
    for one in given:
        call(*one)
    return (time.thread_time_ns() - began) / len(given)


def main():
    of = np.random.default_rng(1)
    floats = [tuple(map(float, it)) for it in of.normal(0.0, 1.0, (CALLS, 3))]
    arrays = [tuple(it) for it in of.normal(0.0, 1.0, (CALLS, 3, 3))]
    readings = ly.Readings(PERIOD)
    cases = {
        "a call of a Python function": (lambda position, applied, effort: applied, floats),
        "an empty call into Rust": (lambda position, applied, effort: readings.restart(), floats),
        "one axis, this package": (ours(1), floats),
        "one axis, plain Python": (InPython().step, floats),
        "one axis, NumPy": (InNumpy(1).step, [tuple(np.array([it]) for it in one) for one in floats]),
        "one axis, candidate in Python": (own(), floats),
        "three axes, this package": (ours(3), arrays),
        "three axes, NumPy": (InNumpy(3).step, arrays),
    }
    times = {name: [] for name in cases}
    for _ in range(ROUNDS):
        for name, (call, given) in cases.items():
            times[name].append(timed(call, given))
    for name, told in times.items():
        print(f"{name:32} {statistics.median(told):8.0f} ns")


if __name__ == "__main__":
    main()
