"""Candidates of one's own: what they may be, and may return."""

import copy
import gc
import weakref

import lyapunov as ly
import numpy as np
import pytest

PERIOD = 1e-3

MAKERS = [lambda it, axes: ly.Stabilizer("lolc", limit=1.0, candidate=it, axes=axes), lambda it, axes: ly.Observer(candidate=it)]


class Mine:
    """A candidate that returns whatever it was made with."""

    def __init__(self, told):
        self.told = told

    def decrease(self, sample):
        return self.told


@pytest.mark.parametrize("make", MAKERS)
@pytest.mark.parametrize(
    "told, kind",
    [(None, "NoneType"), ("1", "str"), (np.zeros(3), r"an array of float64 of shape \[3\]")],
)
def test_what_is_no_number_is_told_as_such(make, told, kind):
    block = make(Mine(told), 3)
    sample = ly.Sample(PERIOD, *np.zeros((4, 3)), axes=3)
    with pytest.raises(TypeError, match=rf"^decrease\(sample\) of Mine returned {kind}; return a number, in J, such as numpy.sum"):
        block.observe(sample) if isinstance(block, ly.Observer) else block.stabilize(sample, np.zeros(3))


@pytest.mark.parametrize("make", MAKERS)
def test_what_is_no_candidate_is_refused_at_once(make):
    with pytest.raises(TypeError, match=r"^candidate is int; give an object with a method decrease\(sample\)"):
        make(3, 1)
    with pytest.raises(TypeError, match="^candidate is the class Mine; give an object of it"):
        make(Mine, 1)


def test_an_error_of_the_candidate_is_its_own():
    class Broken:
        def decrease(self, sample):
            raise TypeError("mine")

    with pytest.raises(TypeError, match="^mine$"):
        ly.Observer(candidate=Broken()).observe(ly.Sample(PERIOD, 0.0, 0.0, 0.0, 0.0))


def test_a_candidate_is_told_whether_the_reading_was_accepted():
    """A store of its own sums what was, and not what was lost."""
    seen = []

    class Watching:
        def decrease(self, sample):
            seen.append((sample.accepted, bool(np.isfinite(sample.work))))
            return sample.work

    stabilizer = ly.Stabilizer("lolc", limit=10.0, candidate=Watching())
    observer, readings, given = ly.Observer(candidate=Watching()), ly.Readings(PERIOD, no_faster_than=2.0), []
    for position in (0.0, 1e-4, None, 5.0, float("nan"), 2e-4):
        sample = readings.read(position, 1.0)
        for ask in (lambda it: stabilizer.stabilize(it, 1.0), observer.observe):
            before = len(seen)
            ask(sample)
            assert all(told == (sample.accepted,) * 2 for told in seen[before:])
        given.append(sample.accepted)
    assert given == [True, True, False, False, False, True]
    assert (False, False) in seen and (True, True) in seen


@pytest.mark.parametrize("make", MAKERS)
@pytest.mark.parametrize("axes", [1, 3])
def test_a_candidate_that_holds_its_block_is_freed(make, axes):
    class Holding(Mine):
        pass

    candidate = Holding(0.0)
    candidate.block = make(candidate, axes)
    candidate.copy = copy.copy(candidate.block)
    # A call leaves nothing behind that holds it.
    sample = ly.Sample(PERIOD, *(np.zeros((4, axes)) if axes > 1 else np.zeros(4)), axes=axes)
    candidate.block.observe(sample) if isinstance(candidate.block, ly.Observer) else candidate.block.stabilize(sample, sample.applied)
    seen = weakref.ref(candidate)
    del candidate
    gc.collect()
    assert seen() is None


def test_a_block_that_is_held_keeps_its_candidate():
    block = ly.Stabilizer("lolc", limit=1.0, candidate=Mine(0.5))
    gc.collect()
    assert "candidate=" in repr(block)
    assert block.stabilize(ly.Sample(PERIOD, 0.0, 0.0, 0.0, 0.0), 0.0).observed_energy == 0.5
