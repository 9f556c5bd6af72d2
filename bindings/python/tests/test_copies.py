"""Copies and pickles of blocks: they go on as the original would, and share nothing with it."""

import copy
import pickle

import lyapunov as ly
import numpy as np
import pytest

PERIOD = 1e-3


def through_pickle(block):
    return pickle.loads(pickle.dumps(block))


COPIES = [copy.copy, copy.deepcopy, through_pickle]


class Counter:
    """A candidate with a memory: the work so far, as the port's energy."""

    def __init__(self):
        self.calls = 0

    def decrease(self, sample):
        self.calls += 1
        return float(np.sum(sample.work))


@pytest.mark.parametrize("again", COPIES)
@pytest.mark.parametrize("axes", [1, 2, 3, 6, 7])
def test_samples_and_corrections_travel(again, axes):
    of = np.random.default_rng(axes)
    signals = of.normal(size=(4, axes))
    if axes == 1:
        signals = signals[:, 0]
    sample = ly.Sample(PERIOD, *signals, axes=axes)
    correction = ly.Correction(signals[0], observed_energy=-0.1, alpha=3.0, shortfall=0.2, accepted=False, axes=axes)
    assert again(sample) == sample and again(correction) == correction
    assert np.array_equal(again(sample).work, sample.work) and again(correction).axes == axes


def test_a_rejected_sample_travels():
    readings = ly.Readings(PERIOD)
    readings.read(0.0, 0.0)
    rejected = through_pickle(readings.read(None, 5.0))
    assert not rejected.accepted and np.isnan(rejected.work) and rejected.applied == 5.0


@pytest.mark.parametrize("again", COPIES)
@pytest.mark.parametrize("make", [lambda: ly.Observer(), lambda: ly.Observer(damping=0.3), lambda: ly.Observer(candidate=Counter())])
def test_an_observer_goes_on_as_it_was(again, make):
    observer, of = make(), np.random.default_rng(1)
    samples = [ly.Sample(PERIOD, *of.normal(size=4)) for _ in range(20)]
    for sample in samples[:10]:
        observer.observe(sample)
    other = again(observer)
    assert other.observed_energy == observer.observed_energy != 0.0
    assert [other.observe(sample) for sample in samples[10:]] == [observer.observe(sample) for sample in samples[10:]]


@pytest.mark.parametrize("make", [lambda it: ly.Stabilizer("lolc", limit=10.0, candidate=it), lambda it: ly.Observer(candidate=it)])
def test_a_deep_copy_has_a_candidate_of_its_own(make):
    def tick(block):
        sample = ly.Sample(PERIOD, 0.1, 0.2, 0.01, 3.0)
        return block.observe(sample) if isinstance(block, ly.Observer) else block.stabilize(sample, 1.0)

    candidate = Counter()
    block = make(candidate)
    tick(block)
    for again, shared in ((copy.copy, True), (copy.deepcopy, False)):
        before = candidate.calls
        tick(again(block))
        assert candidate.calls == before + shared
    # The candidate may hold the block, and what else is copied may hold the candidate.
    candidate.block = block
    kept, other = copy.deepcopy([candidate, block])
    assert kept.block is other
    before = kept.calls
    tick(other)
    assert kept.calls == before + 1


WALL = ly.Scene.shipped("paper-8k-popc")

STUDIES = [
    lambda: ly.run(WALL),
    lambda: ly.compare(WALL, stabilizers="none,popc"),
    lambda: ly.map(WALL, "environment.wall.stiffness=500..9000:3", stabilizers="popc"),
    lambda: ly.bound(WALL),
    lambda: ly.explain(WALL),
    lambda: ly.tune(WALL, stabilizers="popc", trials=2, runs=2),
    lambda: ly.ensemble(WALL, 3),
]


@pytest.mark.parametrize("again", [copy.deepcopy, through_pickle])
@pytest.mark.parametrize("study", STUDIES)
def test_results_travel(again, study):
    told = study()
    other = again(told)
    assert type(other) is type(told) and str(other) == str(told) and list(other.table) == list(told.table)
    for name, column in told.table.items():
        assert np.array_equal(column, other.table[name], equal_nan=isinstance(column, np.ndarray) and column.dtype.kind == "f")
    if not isinstance(told, ly.lab.Ensemble):
        assert (other.json, other.svg) == (told.json, told.svg)
    if isinstance(told, ly.lab.Tuning):
        assert other.scenes == told.scenes


def test_a_copied_batch_goes_on_as_it_was():
    of = np.random.default_rng(1)
    batch = ly.Batch(ly.Stabilizer("popc", limit=100.0, axes=3), 21, PERIOD)
    log = [of.normal(size=(50, 21, 3)) for _ in range(3)]
    batch.stabilize(*(it[:30] for it in log))
    others = [copy.copy(batch), copy.deepcopy(batch)]
    expected = batch.stabilize(*(it[30:] for it in log))
    for other in others:
        told = other.stabilize(*(it[30:] for it in log))
        assert np.array_equal(told.effort, expected.effort) and np.array_equal(told.observed_energy, expected.observed_energy)
    with pytest.raises(TypeError, match="pickle"):
        pickle.dumps(batch)


def test_corrections_are_pickled_and_shown():
    told = ly.Batch(ly.Stabilizer("popc", limit=1.0, axes=2), 4, 1e-3).stabilize(*np.random.default_rng(1).normal(size=(3, 5, 4, 2)))
    again = pickle.loads(pickle.dumps(told))
    for name in ("effort", "observed_energy", "alpha", "shortfall", "accepted"):
        one, other = getattr(told, name), getattr(again, name)
        assert one.dtype == other.dtype and one.shape == other.shape and one.tobytes() == other.tobytes()
    assert repr(told) == repr(copy.deepcopy(told)) == f"<Corrections: efforts of shape (5, 4, 2), {told.accepted.sum()} of 20 accepted>"
