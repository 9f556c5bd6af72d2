"""Input that nobody means: it is refused, and neither ends the process nor hangs it."""

import copy
import pickle
import subprocess
import sys
from unittest.mock import MagicMock

import lyapunov as ly
import numpy as np
import pytest

PERIOD = 1e-3


def misaligned(count):
    return np.frombuffer(b"\0" + np.arange(float(count)).tobytes(), dtype="f8", offset=1)


@pytest.mark.parametrize(
    "call",
    [
        lambda it: ly.Readings(PERIOD, axes=3).read(it[:3], np.zeros(3)),
        lambda it: ly.Stabilizer("popc", limit=1.0, axes=3).stabilize(ly.Readings(PERIOD, axes=3).read([0.0] * 3, [0.0] * 3), it[:3]),
        lambda it: ly.replay(ly.Readings(PERIOD), ly.Stabilizer("popc", limit=1.0), it, it, it),
        lambda it: ly.Batch(ly.Stabilizer("popc", limit=1.0), 30, PERIOD).stabilize(it, it, it),
        lambda it: ly.closed_loop(5, PERIOD, mass=it + 1.0, wall_stiffness=it),
    ],
)
def test_arrays_out_of_line_are_refused(call):
    with pytest.raises(ValueError, match="not aligned.*numpy.array"):
        call(misaligned(30))


@pytest.mark.parametrize("loops", [10**13, 2**62])
def test_more_loops_than_memory_are_refused(loops):
    with pytest.raises(MemoryError, match=f"loops is {loops}"):
        ly.Batch(ly.Stabilizer("popc", limit=1.0), loops, PERIOD)


def endless():
    table, items = {}, []
    table["a"] = table
    items.append(items)

    class Boxes:
        def tolist(self):
            return [self, self]

    return [table, {"a": items}, {"a": MagicMock()}, {"a": Boxes()}]


@pytest.mark.parametrize("table", endless(), ids=["table", "list", "mock", "boxes"])
def test_a_dictionary_without_an_end_is_no_scene(table):
    with pytest.raises(ly.InputError, match="`a"):
        ly.Scene(table)


def test_a_dictionary_may_be_as_deep_as_any_scene():
    deep = 1.0
    for _ in range(60):
        deep = {"a": deep}
    with pytest.raises(ly.SceneError):
        ly.Scene(deep)


def test_a_block_in_use_is_not_pickled():
    class Curious:
        def __init__(self, look):
            self.look = look

        def decrease(self, sample):
            self.look(self.stabilizer)
            return 0.0

    for look in (pickle.dumps, copy.copy, copy.deepcopy):
        candidate = Curious(look)
        candidate.stabilizer = ly.Stabilizer("lolc", limit=1.0, candidate=candidate)
        with pytest.raises(RuntimeError, match="this Stabilizer is in use by another call"):
            candidate.stabilizer.stabilize(ly.Sample(PERIOD, 0.0, 0.0, 0.0, 0.0), 1.0)


def test_numpy_is_there_before_the_first_call():
    """NumPy that an interrupt met half loaded stays broken for the life of the process."""
    told = subprocess.run(
        [sys.executable, "-c", "import sys, lyapunov; print('numpy' in sys.modules)"], capture_output=True, text=True, check=True
    )
    assert told.stdout.strip() == "True"
