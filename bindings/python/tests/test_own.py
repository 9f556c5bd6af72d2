"""Stabilizers of one's own in scenes: what is told of them."""

import json
import subprocess
import sys
from pathlib import Path

import lyapunov as ly
import pytest


class Damper:
    """A constant damper of 2 N·s/m."""

    def stabilize(self, sample, effort):
        return ly.Correction(effort + 2.0 * sample.velocity, observed_energy=-1.0, alpha=2.0, shortfall=3.0)


@pytest.mark.parametrize("scene", ["paper-50k-none", "paper-50k-popc"])
def test_a_run_tells_the_stabilizer_that_ran(scene):
    """Whatever the scene names: its own stabilizer did not run."""
    told = ly.run(ly.Scene.shipped(scene), stabilizer=Damper())
    assert "stabilizer   Damper, which is the program's own" in str(told) and "POPC" not in str(told)
    assert "[stabilizer" not in told.document["file"]["scene"]
    of = told.document["stabilizer"]
    assert of["own"] == "Damper"
    assert of["shortfall_mj"] == 3000.0 and of["active_percent"] == 100.0
    # The energy that it asked for is what the rows say, in mJ.
    v = told.table["v"]
    assert of["energy_asked_for_mj"] == pytest.approx(1e3 * (2.0 * v * v).sum() * 0.01, rel=1e-9)
    assert "observed by the stabilizer" in told.svg[0]


KNOB = {
    "duration": 1.0,
    "servo_rate": 1000,
    "device": {"mass": 0.2, "damping": 0.1},
    "initial": {"velocity": 0.3},
    "environment": {"wall": {"stiffness": 3000.0}},
}


class Untold:
    """A damper that returns a force and says nothing more."""

    def stabilize(self, sample, effort):
        return ly.Correction(effort + 20.0 * sample.velocity)


def test_what_a_stabilizer_does_not_tell_is_no_finding():
    run, told = ly.run(KNOB, stabilizer=Untold()), ly.compare(KNOB, stabilizers="none", own={"mine": lambda scene: Untold()})
    of = run.document["stabilizer"]
    assert of.pop("own") == "Untold" and len(of) == 6 and set(of.values()) == {None}
    assert "it tells none" in str(run) and "tells no alpha" in str(run) and "asked for" not in str(run)
    assert "observed by the stabilizer" not in run.svg[0]
    none, mine = told.document["rows"]
    assert (none["active_percent"], none["shortfall_mj"]) == (0.0, 0.0)
    assert (mine["active_percent"], mine["shortfall_mj"]) == (None, None) and mine["energy_taken_mj"] > 1.0


def test_a_stabilizer_that_does_nothing_is_active_on_no_tick():
    class Idle:
        def stabilize(self, sample, effort):
            return ly.Correction(effort, observed_energy=1.0)

    of = ly.run(KNOB, stabilizer=Idle()).document["stabilizer"]
    assert (of["active_percent"], of["energy_asked_for_mj"], of["shortfall_mj"]) == (0.0, 0.0, 0.0)
    assert of["observed_energy_most_mj"] == 1000.0


def test_a_name_is_that_of_one_stabilizer():
    scene = ly.Scene.shipped("paper-50k-none")
    with pytest.raises(ly.InputError, match="`none` is a stabilizer of the family that takes part"):
        ly.compare(scene, stabilizers="none", own={"none": Damper})
    with pytest.raises(ly.InputError, match="there is no scene"):
        ly.compare()


def test_a_block_runs_in_a_scene_by_its_name_and_numbers():
    limit = ly.damping_limit(0.1 + 0.2, 0.01)
    block = ly.run(ly.Scene.shipped("paper-50k-none"), stabilizer=ly.Stabilizer("popc", limit=limit))
    named = ly.run(ly.Scene.shipped("paper-50k-none"), stabilizer="popc")
    assert f'Stabilizer("popc", limit={limit})' in str(block)
    of = dict(block.document["stabilizer"])
    assert of.pop("own") == f'Stabilizer("popc", limit={limit})'
    assert of == named.document["stabilizer"]
    assert list(block.table["alpha"]) == list(named.table["alpha"])


def test_a_run_leaves_the_block_as_it_is():
    scene = ly.Scene.shipped("paper-50k-none")
    block = ly.Stabilizer("popc", limit=ly.damping_limit(0.1 + 0.2, 0.01))
    first, second = ly.run(scene, stabilizer=block), ly.run(scene, stabilizer=block)
    assert first.json == second.json
    # It is a fresh one for each run of a comparison too, whatever the function gives.
    told = ly.compare(scene, scene, stabilizers="none", own={"mine": lambda scene: block})
    rows = [{k: v for k, v in row.items() if k != "ns_per_step"} for row in told.document["rows"] if row["stabilizer"] == "mine"]
    assert len(rows) == 2 and rows[0] == rows[1]


class Bare:
    """A stabilizer that returns a force alone."""

    def stabilize(self, sample, effort):
        return 2.0


@pytest.mark.parametrize("scene, axes", [("paper-50k-none", 1), ("sphere", 3)])
def test_a_force_that_is_no_number_is_told_as_such(scene, axes):
    """The run would seem to grow."""

    class Lost:
        def stabilize(self, sample, effort):
            return ly.Correction(effort * float("nan"), axes=axes)

    with pytest.raises(ValueError, match="whose effort is not a number"):
        ly.run(ly.Scene.shipped(scene), stabilizer=Lost())


class Once:
    """A stabilizer that hands the force on, and on one tick a correction with something else in it."""

    def __init__(self, **odd):
        self.tick, self.odd = 0, odd

    def stabilize(self, sample, effort):
        self.tick += 1
        return ly.Correction(effort, **(self.odd if self.tick == 300 else {}))


@pytest.mark.parametrize("field", ["alpha", "observed_energy", "shortfall"])
@pytest.mark.parametrize("odd", [float("nan"), float("inf")])
def test_energies_and_dampings_are_numbers(field, odd):
    with pytest.raises(ValueError, match="whose energies and damping are not all finite; say accepted=False"):
        ly.run(ly.Scene.shipped("spring"), stabilizer=Once(**{field: odd}))


def test_a_run_that_its_stabilizer_cuts_short_is_told_as_such():
    told = str(ly.run(ly.Scene.shipped("spring"), stabilizer=Once(accepted=False)))
    assert "the stabilizer rejected a sample" in told and "its stabilizer cut it short" in told and "range" not in told


@pytest.mark.parametrize(
    "own, told",
    [
        ([Damper], "^own is list; give a dictionary"),
        ({1: Damper}, "^a name in own is 1, of the type int; give your own a name, a str"),
        ({"mine": Damper()}, r"^own\[\"mine\"\] is Damper, which cannot be called"),
        ({"mine": lambda scene: None}, "^what own made is NoneType; give"),
        ({"mine": lambda scene: Damper}, "^what own made is the class Damper; give an object of it"),
        ({"mine": Damper}, r"^own\[\"mine\"\] cannot be called with one argument, the scene of each run; give lambda scene: "),
        ({"mine": lambda scene: Bare()}, r"^stabilize\(sample, effort\) returned float; return a Correction"),
    ],
)
def test_what_is_no_stabilizer_is_told_as_such(own, told):
    with pytest.raises(TypeError, match=told):
        ly.compare(ly.Scene.shipped("paper-50k-none"), stabilizers="none", own=own)


@pytest.mark.parametrize(
    "given, told",
    [(["popc"], "^stabilizer is list; give a name"), (Damper, "^stabilizer is the class Damper; give an object of it")],
)
def test_a_run_takes_an_object_or_a_name(given, told):
    with pytest.raises(TypeError, match=told):
        ly.run(ly.Scene.shipped("paper-50k-none"), stabilizer=given)


LATE = {**KNOB, "servo_rate": 500, "device": {"mass": 0.5}, "effects": {"delay": {"ticks": 3}}}
LINKED = {**KNOB, "operator": {"mass": 0.1}, "link": {"stiffness": 300.0}}


def test_what_makes_a_stabilizer_gets_the_scene():
    """POPC with the limit of each scene is the family's own."""
    popc = {"mine": lambda scene: ly.Stabilizer("popc", limit=ly.damping_limit(scene.mass, scene.period, delay=scene.delay))}
    told = ly.compare(KNOB, LATE, LINKED, stabilizers="popc", own=popc)
    measured = ("verdict", "energy_taken_mj", "energy_given_mj", "shortfall_mj", "active_percent")
    rows = [[row[key] for key in measured] for row in told.document["rows"]]
    assert rows[::2] == rows[1::2] and len(rows) == 6 and all(row[1] > 0.0 for row in rows)


def test_a_scene_tells_its_loop():
    for scene, loop in ((KNOB, (0.2, 1e-3, 0.1, 0)), (LATE, (0.5, 2e-3, 0.0, 3)), (LINKED, (0.2, 1e-3, 0.1, 0))):
        it = ly.Scene(scene)
        assert (it.mass, it.period, it.damping, it.delay) == loop
    held = {key: value for key, value in LINKED.items() if key != "link"}
    assert ly.Scene(held).mass == pytest.approx(0.3)


class Broken:
    def stabilize(self, sample, effort):
        raise KeyError("mine")


@pytest.mark.skipif(sys.version_info < (3, 11), reason="Python 3.10 has no notes")
def test_an_exception_tells_its_stabilizer_and_scene():
    def failing(scene):
        raise LookupError if scene.name == "late" else KeyError

    scenes = ly.Scene(KNOB, name="knob"), ly.Scene(LATE, name="late")
    for call, who, kind in (
        (lambda: ly.run(scenes[1], stabilizer=Broken()), "Broken on the scene late", KeyError),
        (lambda: ly.compare(*scenes, own={"mine": lambda scene: Broken()}), "mine on the scene knob", KeyError),
        (lambda: ly.compare(scenes[1], own={"mine": failing}), "mine on the scene late", LookupError),
    ):
        with pytest.raises(kind) as raised:
            call()
        assert raised.value.__notes__ == [f"raised by the stabilizer {who}"]


def test_a_scene_that_does_not_fit_is_left_out():
    ball, names = ly.Scene.shipped("sphere"), "none,reference-following"
    with pytest.warns(UserWarning, match="(?s)^left out: sphere: .*in one dimension only"):
        told = ly.compare(KNOB, ball, stabilizers=names)
    assert told.document["left_out"] == told.left_out and len(told.left_out) == 1
    assert told.table["scene"] == ["scene"] * 2
    # The command does so too, and tells it in the same key.
    files = [str(Path(__file__).parents[3] / "scenes" / name) for name in ("sphere.toml", "paper-50k-none.toml")]
    words = [sys.executable, "-m", "lyapunov", "compare", *files, "--stabilizers", names, "--json"]
    with pytest.warns(UserWarning):
        same = ly.compare(*files, stabilizers=names)
    ended = subprocess.run(words, capture_output=True, text=True)
    assert ended.returncode == 2 and json.loads(ended.stdout)["left_out"] == same.left_out
    with pytest.raises(ly.InputError, match="(?s)^sphere: .*\nbox: "):
        ly.compare(ball, ly.Scene.shipped("box"), stabilizers=names)
    single = ly.Scene({**KNOB, "scalar": "f32"}, name="single")
    with pytest.raises(ly.InputError, match="^single: a stabilizer written in Python runs in f64"):
        ly.compare(single, own={"mine": lambda scene: Untold()})
    assert ly.compare(KNOB, stabilizers="none").left_out == []


def test_a_name_is_not_empty():
    with pytest.raises(ly.InputError, match="a name in own is empty"):
        ly.compare(ly.Scene.shipped("paper-50k-none"), own={" ": Damper})
