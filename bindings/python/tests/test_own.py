"""Stabilizers of one's own in scenes: what is told of them."""

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
    told = ly.compare(scene, scene, stabilizers="none", own={"mine": lambda: block})
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


@pytest.mark.parametrize(
    "own, told",
    [
        ([Damper], "^own is list; give a dictionary"),
        ({1: Damper}, "^a name in own is 1, of the type int; give your own a name, a str"),
        ({"mine": Damper()}, r"^own\[\"mine\"\] is Damper, which cannot be called"),
        ({"mine": lambda: None}, "^what own made is NoneType; give"),
        ({"mine": lambda: Damper}, "^what own made is the class Damper; give an object of it"),
        ({"mine": Bare}, r"^stabilize\(sample, effort\) returned float; return a Correction"),
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


def test_a_name_is_not_empty():
    with pytest.raises(ly.InputError, match="a name in own is empty"):
        ly.compare(ly.Scene.shipped("paper-50k-none"), own={" ": Damper})
