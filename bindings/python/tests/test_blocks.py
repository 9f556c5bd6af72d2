"""Blocks in a loop of one's own, against the equations of docs/contract.md written by hand."""

import copy
import math
import pickle
import random

import lyapunov as ly
import numpy as np
import pytest

PERIOD = 1e-3
LIMIT = 100.0


class ByHand:
    """POPC as docs/contract.md writes it, in plain floats."""

    def __init__(self, damping=0.0):
        self.energy = 0.0
        self.damping = damping

    def step(self, velocity, displacement, applied, effort):
        square = float(np.dot(velocity, velocity)) * PERIOD
        self.energy += float(np.dot(applied, displacement)) + self.damping * square
        alpha, observed = 0.0, self.energy
        if self.energy < 0.0 and square > 2.3e-308:
            alpha = min(-self.energy / square, LIMIT)
        return effort + alpha * velocity, observed, alpha


def walk(axes, ticks=500, seed=1):
    """Positions, applied efforts and efforts of a random walk."""
    of = np.random.default_rng(seed)
    shape = (ticks, axes) if axes > 1 else (ticks,)
    return of.normal(0.0, 1e-4, shape).cumsum(0), of.normal(0.0, 2.0, shape), of.normal(0.0, 2.0, shape)


@pytest.mark.parametrize("axes", [1, 2, 3, 6, 7])
@pytest.mark.parametrize("name, numbers, damping", [("popc", {}, 0.0), ("lolc", {"damping": 0.3}, 0.3)])
def test_a_loop_does_what_the_equations_say(axes, name, numbers, damping):
    readings = ly.Readings(PERIOD, axes=axes)
    stabilizer = ly.Stabilizer(name, limit=LIMIT, axes=axes, **numbers)
    by_hand, acted = ByHand(damping), 0
    before = None
    for position, applied, effort in zip(*walk(axes)):
        told = stabilizer.stabilize(readings.read(position, applied), effort)
        moved = position - position if before is None else position - before
        before = position
        expected, observed, alpha = by_hand.step(moved / PERIOD, moved, applied, effort)
        assert told.accepted
        assert told.observed_energy == pytest.approx(observed, abs=1e-12)
        assert told.alpha == pytest.approx(alpha, rel=1e-6)
        assert np.asarray(told.effort) == pytest.approx(expected, rel=1e-6, abs=1e-9)
        acted += alpha > 0.0
    assert acted > 20


def test_the_limit_is_a_share_of_mass_over_period():
    assert ly.damping_limit(0.2, 1e-3) == 0.5 * 0.2 / 1e-3
    # A force that acts a tick late: tan(pi / 8) of it.
    assert ly.damping_limit(0.2, 1e-3, delay=1) == pytest.approx(100.0 * math.tan(math.pi / 8))
    with pytest.raises(ly.InputError, match="mass is -1.0; it must be above 0"):
        ly.damping_limit(-1.0, 1e-3)


def test_an_unstable_wall_is_bounded():
    """0.2 kg against 8 kN/m at 100 Hz: semi-implicit Euler in fine steps as the device."""

    def largest(stabilizer):
        readings = ly.Readings(0.01)
        x, v, applied, most = -0.004, 0.2, 0.0, 0.0
        for tick in range(600):
            sample = readings.read(x, applied)
            wall = max(0.0, 8000.0 * x)
            applied = stabilizer.stabilize(sample, wall).effort
            for _ in range(100):
                v += 1e-4 * (-applied - 50.0 * x) / 0.2
                x += 1e-4 * v
            if not math.isfinite(x) or abs(x) > 1e6:
                return math.inf
            most = max(most, abs(x)) if tick > 300 else most
        return most

    assert largest(ly.Stabilizer("none")) > 10.0
    assert largest(ly.Stabilizer("popc", limit=ly.damping_limit(0.2, 0.01))) < 0.02


class Drag:
    """The port's energy, credited with a damper of 0.3 N·s/m: what `damping=0.3` credits, in Python."""

    def decrease(self, sample):
        return float(np.sum(sample.work)) + 0.3 * float(np.sum(np.square(sample.velocity))) * sample.period


@pytest.mark.parametrize("axes", [1, 3])
def test_a_candidate_in_python_does_what_the_same_does_in_rust(axes):
    ours = ly.Stabilizer("lolc", limit=LIMIT, damping=0.3, axes=axes)
    own = ly.Stabilizer("lolc", limit=LIMIT, candidate=Drag(), axes=axes)
    observers = ly.Observer(damping=0.3), ly.Observer(candidate=Drag())
    readings = ly.Readings(PERIOD, axes=axes)
    for position, applied, effort in zip(*walk(axes)):
        sample = readings.read(position, applied)
        one, other = ours.stabilize(sample, effort), own.stabilize(sample, effort)
        assert other.observed_energy == pytest.approx(one.observed_energy, abs=1e-12)
        energies = [observer.observe(sample) for observer in observers]
        assert energies[0] == pytest.approx(energies[1], abs=1e-12)


def test_what_a_candidate_raises_is_raised():
    class Broken:
        def decrease(self, sample):
            raise KeyError("mine")

    readings = ly.Readings(PERIOD)
    stabilizer = ly.Stabilizer("lolc", limit=LIMIT, candidate=Broken())
    with pytest.raises(KeyError, match="mine"):
        stabilizer.stabilize(readings.read(0.0, 0.0), 1.0)


FAMILY = [
    ("none", {}),
    ("popc", {"limit": LIMIT}),
    ("lolc", {"limit": LIMIT, "damping": 0.1}),
    ("popc-bounded", {"limit": LIMIT, "credit": 1e-3}),
    ("popc-windowed", {"limit": LIMIT, "ticks": 16}),
    ("popc-threshold", {"limit": LIMIT, "velocity": 0.01}),
    ("popc-spread", {"limit": LIMIT, "ticks": 4}),
    ("popc-rate-limited", {"limit": LIMIT, "rate": 100.0}),
    ("popc-rising", {"limit": LIMIT, "ticks": 4}),
    ("force-bound", {"damping": 0.5}),
    ("tank", {"start": 1e-3, "ceiling": 2e-3}),
    ("energy-bounding", {"c1": 500.0, "c2": 400.0}),
    ("force-bounding", {"damping": 0.5}),
    ("least-norm", {"limit": LIMIT, "decay": 1.0}),
    ("slope-bound", {"slope": 500.0}),
]


@pytest.mark.parametrize("axes", [1, 3])
@pytest.mark.parametrize("name, numbers", FAMILY, ids=[name for name, _ in FAMILY])
def test_a_pickled_loop_goes_on_bit_for_bit(name, numbers, axes):
    stabilizer, readings = ly.Stabilizer(name, axes=axes, **numbers), ly.Readings(PERIOD, axes=axes, cutoff=50.0)
    ticks = list(zip(*walk(axes)))
    for position, applied, effort in ticks[:250]:
        stabilizer.stabilize(readings.read(position, applied), effort)
    others = [
        pickle.loads(pickle.dumps((stabilizer, readings))),
        (copy.copy(stabilizer), copy.copy(readings)),
        (copy.deepcopy(stabilizer), copy.deepcopy(readings)),
    ]
    for position, applied, effort in ticks[250:]:
        one = stabilizer.stabilize(readings.read(position, applied), effort)
        for again, reader in others:
            assert again.stabilize(reader.read(position, applied), effort) == one
    assert repr(others[0][0]) == repr(stabilizer)


def test_a_reset_stabilizer_is_a_fresh_one():
    used, fresh, readings = (ly.Stabilizer("popc", limit=LIMIT), ly.Stabilizer("popc", limit=LIMIT), ly.Readings(PERIOD))
    for position, applied, effort in zip(*walk(1)):
        used.stabilize(readings.read(position, applied), effort)
    used.reset()
    sample = readings.read(0.0, 1.0)
    assert used.stabilize(sample, 1.0) == fresh.stabilize(sample, 1.0)


def test_bad_readings_are_rejected_and_the_gap_is_spanned():
    readings = ly.Readings(PERIOD, no_faster_than=2.0)
    popc = ly.Stabilizer("popc", limit=LIMIT)
    readings.read(0.3, 0.0)
    for bad in (math.nan, 0.0, None):
        sample = readings.read(bad, 5.0)
        told = popc.stabilize(sample, 1.0)
        assert not sample.accepted and not told.accepted and told.effort == 0.0
    found = readings.read(0.301, 5.0)
    assert found.accepted and found.late
    assert found.period == pytest.approx(4e-3) and found.work == pytest.approx(5.0 * 0.001)


def test_clocks_and_measured_velocities():
    readings = ly.Readings(PERIOD, measured=True, clocked=True)
    readings.read(0.3, 0.0, velocity=0.1, now=7.0)
    late = readings.read(0.302, 5.0, velocity=0.2, now=7.004)
    assert late.late and late.period == pytest.approx(4e-3)
    with pytest.raises(ly.InputError, match="velocity is missing"):
        readings.read(0.3, 0.0, now=7.005)
    with pytest.raises(ly.InputError, match="time is missing"):
        readings.read(0.3, 0.0, velocity=0.0)


@pytest.mark.parametrize("kind", [{}, {"cutoff": 50.0}, {"clocked": True}])
def test_a_velocity_that_nothing_uses_is_refused(kind):
    told = {"now": 1.0} if kind.get("clocked") else {}
    with pytest.raises(ly.InputError, match="a velocity is given.*\\n.*measured=True"):
        ly.Readings(PERIOD, **kind).read(0.0, 0.0, velocity=5.0, **told)


@pytest.mark.parametrize("kind", [{}, {"cutoff": 50.0}, {"measured": True}])
def test_a_time_that_nothing_uses_is_refused(kind):
    told = {"velocity": 1.0} if kind.get("measured") else {}
    with pytest.raises(ly.InputError, match="a time is given.*\\n.*clocked=True"):
        ly.Readings(PERIOD, **kind).read(0.0, 0.0, now=5.0, **told)


@pytest.mark.parametrize(
    "make, message",
    [
        (lambda: ly.Readings(0.0), "period is 0.0; it must be above 0"),
        (lambda: ly.Readings(PERIOD, axes=4), r"axes is 4; blocks are compiled for \[1, 2, 3, 6, 7\]"),
        (lambda: ly.Readings(PERIOD, cutoff=1.0, measured=True), "exclude each other"),
        (lambda: ly.Stabilizer("popcorn"), "no block is called `popcorn`"),
        (lambda: ly.Stabilizer("popc"), "`popc` needs limit\n  = give by name: limit=… in N·s/m"),
        (lambda: ly.Stabilizer("energy-bounding"), "needs c1, c2\n  = give by name: c1=… in N/m, c2=… in N/m"),
        (lambda: ly.Stabilizer("popc", limit=-1.0), "^limit is -1.0"),
        (lambda: ly.Stabilizer("popc", limit=math.nan), "^limit is NaN"),
        (lambda: ly.Stabilizer("popc", limit=1.0, dampin=1.0), "`popc` has no dampin"),
        (lambda: ly.Stabilizer("lolc"), "`lolc` needs limit, damping\n  = give by name: limit=… in N·s/m, damping=… in N·s/m, or candidate"),
        (lambda: ly.Stabilizer("popc-spread", limit=1.0, ticks=1.5), "must be a whole number"),
        (lambda: ly.Stabilizer("tank", start=-1.0), "^start is -1.0"),
        (lambda: ly.Observer(damping=-0.1), "damping is -0.1"),
        (lambda: ly.damping_limit(1.0, PERIOD, cap=-1.0), "^cap is -1.0"),
        (lambda: ly.Readings(PERIOD, no_faster_than=-1.0), "^no_faster_than is -1.0"),
        (lambda: ly.Readings(PERIOD, cutoff=0.0), "^cutoff is 0.0"),
        (lambda: ly.Stabilizer("popc-bounded", limit=1.0, credit=-1.0), "^credit is -1.0"),
        (lambda: ly.Stabilizer("popc-rate-limited", limit=1.0, rate=-1.0), "^rate is -1.0"),
        (lambda: ly.Stabilizer("popc-threshold", limit=1.0, velocity=-1.0), "^velocity is -1.0"),
        (lambda: ly.Stabilizer("least-norm", limit=1.0, decay=2.0), "^decay is 2.0"),
        (lambda: ly.Stabilizer("energy-bounding", c1=-1.0, c2=1.0), "^c1 is -1.0"),
        (lambda: ly.Stabilizer("force-bound", damping=-1.0), "^damping is -1.0"),
        (lambda: ly.Stabilizer("tank", start=1.0, power=-1.0), "^power is -1.0"),
    ],
)
def test_wrong_parameters_name_themselves(make, message):
    with pytest.raises(ValueError, match=message):
        make()


@pytest.mark.parametrize(
    "position, message",
    [
        (np.zeros(2), r"position is an array of float64 of shape \[2\]; give an array of real numbers of shape \(3,\)"),
        (np.zeros((3, 1)), r"shape \[3, 1\]"),
        (np.zeros(3, dtype=complex), "array of complex128"),
        (np.zeros(3, dtype=bool), "array of bool"),
        (0.5, "position is float"),
        ("abc", "position is str"),
        ([0.0, 0.0], "position is list"),
    ],
)
def test_wrong_shapes_and_types_say_what_is_right(position, message):
    readings = ly.Readings(PERIOD, axes=3)
    with pytest.raises(TypeError, match=message):
        readings.read(position, np.zeros(3))


@pytest.mark.parametrize("kind", [np.float32, np.float16, np.int64, np.uint8])
def test_real_numbers_of_other_types_are_converted(kind):
    """On several axes as on one."""
    given = np.array([3, 0, 7], dtype=kind)
    assert ly.Readings(PERIOD, axes=3).read(given, given[::-1]).position.tolist() == [3.0, 0.0, 7.0]
    assert ly.Readings(PERIOD).read(given[0], given[2]).applied == 7.0


def test_masked_numbers_are_refused():
    masked = np.ma.masked_equal([0.0, 1.0, 2.0], 1.0)
    for axes, position in ((3, masked), (1, masked[1])):
        with pytest.raises(ly.InputError, match=r"^position is a masked array\n  = give position.filled\(numpy.nan\)"):
            ly.Readings(PERIOD, axes=axes).read(position, np.zeros(3) if axes == 3 else 0.0)
    with pytest.raises(ly.InputError, match="^applied is a masked array"):
        ly.Batch(ly.Stabilizer("none"), 3, PERIOD).stabilize(np.zeros(3), masked, np.zeros(3))


def test_what_is_shown_of_a_block_makes_one_like_it():
    blocks = [
        ly.Readings(PERIOD, axes=3, no_faster_than=2.0, cutoff=50.0, clocked=True),
        ly.Readings(PERIOD, measured=True),
        ly.Stabilizer("tank", start=1.0, power=3.0),
        ly.Stabilizer("popc", limit=LIMIT, axes=2),
    ]
    for block in blocks:
        assert repr(eval(repr(block), {"Readings": ly.Readings, "Stabilizer": ly.Stabilizer, "inf": np.inf})) == repr(block)
    assert repr(blocks[0]) == "Readings(period=0.001, axes=3, no_faster_than=2.0, cutoff=50.0, clocked=True)"


def test_an_array_is_no_number():
    with pytest.raises(TypeError, match="give a number"):
        ly.Readings(PERIOD).read(np.zeros(1), 0.0)
    # A scalar of NumPy is one.
    assert ly.Readings(PERIOD).read(np.float64(0.25), np.float32(0.0)).position == 0.25


def test_arrays_that_are_not_contiguous_are_read_as_they_are():
    wide = np.arange(6.0)
    sample = ly.Readings(PERIOD, axes=3).read(wide[::2], wide[::-2])
    assert sample.position.tolist() == [0.0, 2.0, 4.0] and sample.applied.tolist() == [5.0, 3.0, 1.0]


def test_blocks_of_other_axes_do_not_mix():
    sample = ly.Readings(PERIOD, axes=3).read([0.0, 0.0, 0.0], [0.0, 0.0, 0.0])
    with pytest.raises(ValueError, match="the sample has 3 axes and the block 1"):
        ly.Stabilizer("popc", limit=LIMIT).stabilize(sample, 0.0)


def test_a_block_that_is_called_within_its_own_call_says_so():
    class Nested:
        def decrease(self, sample):
            stabilizer.stabilize(sample, 0.0)
            return 0.0

    stabilizer = ly.Stabilizer("lolc", limit=LIMIT, candidate=Nested())
    with pytest.raises(RuntimeError, match="^this Stabilizer is in use by another call; make a Stabilizer for each loop$"):
        stabilizer.stabilize(ly.Readings(PERIOD).read(0.0, 0.0), 0.0)


def test_samples_and_corrections_by_hand():
    sample = ly.Sample(PERIOD, 0.1, 0.2, 1e-4, 3.0)
    assert sample.work == pytest.approx(3e-4) and sample.accepted and sample == ly.Sample(PERIOD, 0.1, 0.2, 1e-4, 3.0)
    correction = ly.Correction([1.0, 2.0], alpha=3.0, axes=2)
    assert correction.effort.tolist() == [1.0, 2.0] and correction.alpha == 3.0
    # What is shown makes the same again.
    for shown in (correction, ly.Correction(1.0)):
        assert eval(repr(shown), {"Correction": ly.Correction}) == shown
    assert "effort=1.0" in repr(ly.Correction(1.0)) and "position=0.1" in repr(sample)
    assert "alpha=3.0" in repr(correction) and "period=0.001" in repr(sample)
    assert random.Random(1).random() != sample
