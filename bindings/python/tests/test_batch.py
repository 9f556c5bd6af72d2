"""Batches, against the blocks tick by tick and against NumPy."""

import lyapunov as ly
import numpy as np
import pytest

PERIOD = 1e-3
LIMIT = 100.0
FIELDS = ("effort", "observed_energy", "alpha", "shortfall", "accepted")


def recorded(ticks, loops, axes, seed=1):
    of = np.random.default_rng(seed)
    shape = (ticks, loops) if axes == 1 else (ticks, loops, axes)
    position = of.normal(0.0, 1e-4, shape).cumsum(0)
    position[of.random((ticks, loops)) < 0.01] = np.nan
    return position, of.normal(0.0, 2.0, shape), of.normal(0.0, 2.0, shape)


def tick_by_tick(stabilizer, position, applied, effort, axes):
    """One loop through its blocks."""
    readings = ly.Readings(PERIOD, axes=axes, no_faster_than=5.0)
    told = [stabilizer.stabilize(readings.read(*now[:2]), now[2]) for now in zip(position, applied, effort)]
    return {field: np.array([getattr(one, field) for one in told]) for field in FIELDS}


MEMBERS = [("popc", {"limit": LIMIT}), ("lolc", {"limit": LIMIT, "damping": 0.2}), ("popc-rate-limited", {"limit": LIMIT, "rate": 50.0})]


@pytest.mark.parametrize("axes", [1, 3])
@pytest.mark.parametrize("name, numbers", MEMBERS, ids=[name for name, _ in MEMBERS])
def test_loops_of_a_batch_are_the_loops_one_by_one(name, numbers, axes):
    loops = 21  # two groups of lanes, and five loops more
    log = recorded(120, loops, axes)
    stabilizer = ly.Stabilizer(name, axes=axes, **numbers)
    whole = ly.Batch(stabilizer, loops, PERIOD, no_faster_than=5.0).stabilize(*log)
    ticking = ly.Batch(stabilizer, loops, PERIOD, no_faster_than=5.0)
    steps = [ticking.stabilize(*now) for now in zip(*log)]
    for field in FIELDS:
        assert np.array_equal(getattr(whole, field), [getattr(step, field) for step in steps], equal_nan=True)
    assert whole.effort.shape == log[0].shape and whole.alpha.shape == (120, loops)
    for loop in range(loops):
        alone = tick_by_tick(ly.Stabilizer(name, axes=axes, **numbers), *(it[:, loop] for it in log), axes)
        for field in FIELDS:
            assert np.array_equal(getattr(whole, field)[:, loop], alone[field], equal_nan=True), (field, loop)
    assert not whole.accepted.all() and (whole.alpha > 0.0).any()


@pytest.mark.parametrize("axes", [1, 3])
def test_a_replay_is_the_loop_tick_by_tick(axes):
    log = [it[:, 0].copy() for it in recorded(300, 1, axes)]
    make = lambda: ly.Stabilizer("lolc", limit=LIMIT, damping=0.2, axes=axes)  # noqa: E731
    stabilizer, readings = make(), ly.Readings(PERIOD, axes=axes, no_faster_than=5.0)
    halves = [ly.replay(readings, stabilizer, *(it[part] for it in log)) for part in (slice(0, 150), slice(150, 300))]
    alone = tick_by_tick(make(), *log, axes)
    for field in FIELDS:
        told = np.concatenate([getattr(half, field) for half in halves])
        assert np.array_equal(told, alone[field], equal_nan=True)


def test_a_replay_asks_a_candidate_in_python():
    class Energy:
        def decrease(self, sample):
            return sample.work

    log = [it[:, 0].copy() for it in recorded(100, 1, 1)]
    own = ly.Stabilizer("lolc", limit=LIMIT, candidate=Energy())
    told = ly.replay(ly.Readings(PERIOD), own, *log)
    popc = ly.replay(ly.Readings(PERIOD), ly.Stabilizer("popc", limit=LIMIT), *log)
    assert np.array_equal(told.effort, popc.effort)


def test_a_replay_ends_where_a_candidate_raises():
    class Broken:
        calls = 0

        def decrease(self, sample):
            self.calls += 1
            if self.calls == 3:
                raise LookupError("third")
            return 0.0

    broken, log = Broken(), [it[:, 0].copy() for it in recorded(100, 1, 1)]
    with pytest.raises(LookupError, match="third"):
        ly.replay(ly.Readings(PERIOD), ly.Stabilizer("lolc", limit=LIMIT, candidate=broken), *log)
    assert broken.calls == 3


def closed_in_numpy(ticks, period, mass, damping, stiffness, position, velocity, wall_stiffness, wall_damping, limit):
    """The same loops in NumPy: the exact motion by the closed form of a damped oscillator."""
    decay, natural = damping / (2 * mass), np.sqrt(stiffness / mass - (damping / (2 * mass)) ** 2)
    shrink, s, c = np.exp(-decay * period), np.sin(natural * period), np.cos(natural * period)
    xx, xv = shrink * (c + decay / natural * s), shrink * s / natural
    vx, vv = -stiffness / mass * xv, shrink * (c - decay / natural * s)
    xf, vf = (xx - 1) / stiffness, vx / stiffness
    x, v = position.copy(), velocity + np.zeros_like(position)
    before, energy, acted = x.copy(), np.zeros_like(x), np.zeros_like(x)
    largest = np.zeros_like(x)
    for tick in range(ticks):
        if 2 * tick >= ticks:
            largest = np.maximum(largest, np.abs(x))
        moved = x - before
        speed = moved / period
        wall = np.where(x > 0, np.maximum(wall_stiffness * x + wall_damping * speed, 0), 0)
        energy = energy + acted * moved
        observed, square = energy, speed * speed * period
        acts = (energy < 0) & (square > 2.3e-308)
        alpha = np.where(acts, np.minimum(-energy / np.where(acts, square, 1.0), limit), 0.0)
        acted, before = wall + alpha * speed, x
        x, v = xx * x + xv * v + xf * acted, vx * x + vv * v + vf * acted
    largest = np.maximum(largest, np.abs(x))
    return {"position": x, "velocity": v, "observed_energy": observed, "largest": largest}


def test_closed_loops_are_those_of_numpy():
    of = np.random.default_rng(1)
    loops = 100
    mass, wall = of.uniform(0.2, 0.4, loops), of.uniform(100.0, 3000.0, loops)
    given = {
        "mass": mass,
        "damping": 0.2,
        "stiffness": 50.0,
        "position": np.full(loops, -0.004),
        "velocity": 0.0,
        "wall_stiffness": wall,
        "wall_damping": 2.0,
    }
    # A tenth of a second: rounding grows in a loop with contact.
    told = ly.closed_loop(200, PERIOD, **given, stabilizer=ly.Stabilizer("popc", limit=LIMIT))
    expected = closed_in_numpy(200, PERIOD, **given, limit=LIMIT)
    for name, numbers in expected.items():
        assert told[name] == pytest.approx(numbers, abs=1e-9), name
    # Any loop is what it is alone.
    one = {name: it[7:8].copy() if isinstance(it, np.ndarray) else it for name, it in given.items()}
    alone = ly.closed_loop(200, PERIOD, **one, stabilizer=ly.Stabilizer("popc", limit=LIMIT))
    assert all(alone[name][0] == told[name][7] for name in told)


@pytest.mark.parametrize("ticks", [0, 1, 2, 3, 10, 11])
def test_the_second_half_begins_at_half_of_the_ticks(ticks):
    # Uniform motion inwards: the largest is the first that counts.
    told = ly.closed_loop(ticks, PERIOD, mass=1.0, wall_stiffness=0.0, position=-1.0, velocity=1.0)
    assert told["largest"][0] == pytest.approx(1.0 - PERIOD * ((ticks + 1) // 2), abs=1e-12)
    assert told["position"][0] == pytest.approx(PERIOD * ticks - 1.0, abs=1e-12)


@pytest.mark.parametrize("stabilizer", [None, "none"])
def test_the_port_is_observed_without_a_stabilizer(stabilizer):
    given = {"mass": 0.2, "damping": 0.1, "stiffness": 20.0, "position": -0.01, "velocity": 0.3, "wall_stiffness": 8000.0}
    block = None if stabilizer is None else ly.Stabilizer(stabilizer)
    # A debt that rises at every contact: the wall that is sampled gives more than it takes.
    ends = [ly.closed_loop(ticks, PERIOD, **given, stabilizer=block) for ticks in range(1, 302)]
    places = np.array([-0.01, *(end["position"][0] for end in ends)])
    forces = np.maximum(0.0, 8000.0 * places)
    books = np.concatenate([[0.0], np.cumsum(forces[:-1] * np.diff(places))])
    assert [end["observed_energy"][0] for end in ends] == pytest.approx(books[:-1], abs=1e-12)
    assert books[-2] < -1e-3
    watched = ly.closed_loop(301, PERIOD, **given, stabilizer=ly.Stabilizer("popc", limit=0.0))
    assert {name: it[0] for name, it in watched.items()} == {name: it[0] for name, it in ends[-1].items()}


def test_a_stiff_wall_runs_away_alone_and_not_with_popc():
    given = {"mass": 0.3, "damping": 0.201, "stiffness": 50.0, "position": np.full(16, -0.004), "wall_stiffness": 8000.0}
    alone = ly.closed_loop(1000, 0.01, **given)
    limit = ly.damping_limit(0.3, 0.01)
    held = ly.closed_loop(1000, 0.01, **given, stabilizer=ly.Stabilizer("popc", limit=limit))
    assert (alone["largest"] > 1.0).all() and (held["largest"] < 0.01).all()


@pytest.mark.parametrize(
    "position, error, message",
    [
        (np.zeros(7), ValueError, r"position has the shape \[7\]; give \[8\]"),
        (np.zeros((8, 3)), ValueError, "with a first axis of time"),
        (np.zeros(8, dtype=np.float32), TypeError, "position is an array of float32; give an array of float64"),
        (np.zeros(16)[::2], ValueError, "not contiguous.*ascontiguousarray"),
        ([0.0] * 8, TypeError, "position is list"),
    ],
)
def test_wrong_arrays_say_what_is_right(position, error, message):
    batch = ly.Batch(ly.Stabilizer("popc", limit=LIMIT), 8, PERIOD)
    with pytest.raises(error, match=message):
        batch.stabilize(position, np.zeros(8), np.zeros(8))


def test_arrays_of_other_shapes_do_not_mix():
    batch = ly.Batch(ly.Stabilizer("popc", limit=LIMIT), 8, PERIOD)
    with pytest.raises(ValueError, match="applied has the shape"):
        batch.stabilize(np.zeros(8), np.zeros(7), np.zeros(8))
    with pytest.raises(ValueError, match="same length"):
        ly.closed_loop(10, PERIOD, mass=np.ones(3), wall_stiffness=np.ones(4))
    with pytest.raises(ValueError, match="mass is 0.0"):
        ly.closed_loop(10, PERIOD, mass=np.array([1.0, 0.0]), wall_stiffness=1.0)
    with pytest.raises(ValueError, match="loops is 0"):
        ly.Batch(ly.Stabilizer("popc", limit=LIMIT), 0, PERIOD)


@pytest.mark.parametrize("value", [-1.0, np.nan])
@pytest.mark.parametrize(
    "name", ["mass", "damping", "stiffness", "position", "velocity", "wall_stiffness", "wall_damping", "wall_position"]
)
def test_what_a_closed_loop_cannot_have_is_named(name, value):
    given = {"mass": 1.0, "wall_stiffness": 1.0}
    if value < 0.0 and name in {"position", "velocity", "wall_position"}:
        assert ly.closed_loop(3, PERIOD, **{**given, name: value})["position"].shape == (1,)
        return
    for told in (value, np.array([1.0, value])):
        with pytest.raises(ly.InputError, match=f"^{name} is "):
            ly.closed_loop(3, PERIOD, **{**given, name: told})


def test_members_of_an_ensemble_are_scenes_by_their_numbers():
    scene = ly.Scene.shipped("paper-8k-popc")
    told = ly.ensemble(scene, 12, seed=5)
    again = ly.ensemble(scene, 5, seed=5)
    for name, column in again.table.items():
        assert list(map(str, told.table[name][:5])) == list(map(str, column))
    assert sum(told.verdicts.values()) == 12 and len(set(told.table["peak_force_acting_n"])) == 12
    still = ly.ensemble(scene, 3, phase=0.0, mass=0.0, damping=0.0, stiffness=0.0)
    run = ly.run(scene)
    assert still.table["peak_force_acting_n"].tolist() == [run.document["peak_force_acting_n"]] * 3
    assert still.table["verdict"] == [run.verdict] * 3
    with pytest.raises(ly.InputError, match="share below 1"):
        ly.ensemble(scene, 20, mass=3.0)


class OfOldNumPy(np.ndarray):
    """An array that is a number where it holds one, as all were once."""

    def __float__(self):
        return 1.0


def test_an_array_of_one_number_is_one_loop():
    """With every NumPy: it is no number for all loops, and no float."""
    with pytest.raises(ly.InputError, match=r"^arrays of \[1, 3\] loops; give all the same length"):
        ly.closed_loop(3, 1e-3, mass=np.ones(1).view(OfOldNumPy), wall_stiffness=np.ones(3))
    with pytest.raises(TypeError, match=r"^period is an array of float64 of shape \[1\], which is no number"):
        ly.Readings(np.ones(1).view(OfOldNumPy))
    ends = ly.closed_loop(3, 1e-3, mass=np.ones(1), wall_stiffness=1.0)
    assert ends["position"].shape == (1,)
    with pytest.raises(ly.InputError, match=r"^arrays of \[1, 3\] loops; give all the same length"):
        ly.closed_loop(3, 1e-3, mass=np.ones(1), wall_stiffness=np.ones(3))
    assert ly.closed_loop(3, 1e-3, mass=np.ones(3), wall_stiffness=np.array(1.0))["largest"].shape == (3,)
    with pytest.raises(TypeError, match="^mass is an array of int64; give an array of float64"):
        ly.closed_loop(3, 1e-3, mass=np.ones(1, dtype=np.int64), wall_stiffness=1.0)


def test_a_closed_loop_says_what_it_leaves_out():
    assert "no delay, encoder, saturation or other effect" in ly.closed_loop.__doc__
