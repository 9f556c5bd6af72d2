"""Numbers that an argument does not take: the error names the argument, its value and the range."""

from pathlib import Path

import lyapunov as ly
import numpy as np
import pytest

PERIOD = 1e-3
TABLES = {"duration": 1.0, "servo_rate": 1000, "device": {"mass": 0.2}, "environment": {"wall": {"stiffness": 8000.0}}}


@pytest.mark.parametrize(
    "name, call",
    [
        ("loops", lambda it: ly.Batch(ly.Stabilizer("none"), it, PERIOD)),
        ("ticks", lambda it: ly.closed_loop(it, PERIOD, mass=1.0, wall_stiffness=1.0)),
        ("members", lambda it: ly.ensemble(TABLES, it)),
        ("seed", lambda it: ly.ensemble(TABLES, 1, seed=it)),
        ("seed", lambda it: ly.tune(TABLES, seed=it)),
        ("trials", lambda it: ly.tune(TABLES, trials=it)),
        ("runs", lambda it: ly.tune(TABLES, runs=it)),
        ("threads", lambda it: ly.map(TABLES, "device.mass=0.1..0.2:2", threads=it)),
        ("delay", lambda it: ly.damping_limit(1.0, PERIOD, delay=it)),
        ("axes", lambda it: ly.Readings(PERIOD, axes=it)),
        ("axes", lambda it: ly.Stabilizer("none", axes=it)),
        ("axes", lambda it: ly.Sample(PERIOD, 0.0, 0.0, 0.0, 0.0, axes=it)),
        ("axes", lambda it: ly.Correction(0.0, axes=it)),
    ],
)
@pytest.mark.parametrize("value, remedy", [(-1, "it must be [01] or more"), (10**30, r"it must be \d+ or less")])
def test_a_whole_number_out_of_range_is_named(name, call, value, remedy):
    remedy = r"blocks are compiled for \[1, 2, 3, 6, 7\]" if name == "axes" else remedy
    with pytest.raises(ly.InputError, match=f"^{name} is {value}; {remedy}"):
        call(value)
    for wrong, kind in (("one", "str"), (3.0, "float")):
        with pytest.raises(TypeError, match=f"^{name} is {wrong}, of the type {kind}; give a whole number"):
            call(wrong)


def test_axes_that_no_block_has_are_wrong_input():
    with pytest.raises(ly.InputError, match="^axes is 4; blocks are compiled for"):
        ly.Readings(PERIOD, axes=4)
    sample = ly.Sample(PERIOD, 0.0, 0.0, 0.0, 0.0)
    with pytest.raises(ly.InputError, match="^the sample has 1 axis and the block 3"):
        ly.Stabilizer("none", axes=3).stabilize(sample, np.zeros(3))


def test_a_number_of_ticks_says_its_range():
    with pytest.raises(ly.InputError, match=r"^ticks is 1000000000000.0; it must be a whole number from 1 to 4294967295$"):
        ly.Stabilizer("popc-windowed", limit=1.0, ticks=1e12)


@pytest.mark.parametrize(
    "name, call",
    [
        ("stabilizer", lambda: ly.Batch(3, 8, PERIOD)),
        ("stabilizer", lambda: ly.closed_loop(3, PERIOD, mass=1.0, wall_stiffness=1.0, stabilizer=3)),
        ("stabilizer", lambda: ly.replay(ly.Readings(PERIOD), 3, np.zeros(3), np.zeros(3), np.zeros(3))),
        ("readings", lambda: ly.replay(3, ly.Stabilizer("none"), np.zeros(3), np.zeros(3), np.zeros(3))),
        ("sample", lambda: ly.Stabilizer("none").stabilize(3, 0.0)),
        ("sample", lambda: ly.Observer().observe(3)),
    ],
)
def test_an_argument_of_another_class_is_named(name, call):
    with pytest.raises(TypeError, match=rf"^{name} is int; give an object of <class 'lyapunov.{name.title()}'>"):
        call()


@pytest.mark.parametrize("name, share", [("mass", -0.1), ("damping", 1.0), ("stiffness", float("inf")), ("phase", -1.0)])
def test_a_share_of_an_ensemble_is_named(name, share):
    with pytest.raises(ly.InputError, match=f"^{name} is {share}; it must be "):
        ly.ensemble(TABLES, 2, **{name: share})


def test_what_is_no_scene_says_what_it_is():
    with pytest.raises(ly.InputError, match="^`device.mass` is None, which no scene holds\n  = leave the key out"):
        ly.run({**TABLES, "device": {"mass": None}})
    for text in (ly.Scene(TABLES).to_toml(), "duration = 1.0"):
        with pytest.raises(ly.InputError, match=r"^this is the text of a scene, and not .*\n  = give Scene.parse\(text\)"):
            ly.run(text)
    with pytest.raises(TypeError, match=r"and not list; give several one by one, as in compare\(\*scenes\)"):
        ly.compare([TABLES, TABLES])


@pytest.mark.parametrize("file, what", [("teleoperation/lossy.toml", "a teleoperator"), ("models/dc-motor.toml", "a model")])
def test_what_only_the_command_compares_is_told_as_such(file, what):
    path = Path(__file__).parents[3] / "scenes" / file
    with pytest.raises(ly.SceneError, match=f"(?s)this is {what}.*only the command takes it: `python -m lyapunov compare FILE`") as told:
        ly.compare(path)
    assert told.value.remedies == ["only the command takes it: `python -m lyapunov compare FILE`"]


def test_a_number_too_large_for_a_scene_is_named():
    with pytest.raises(ly.InputError, match=f"`duration` is {10**30}, which is no number of 64 bits"):
        ly.Scene({**TABLES, "duration": 10**30})
    assert ly.Scene({**TABLES, "duration": 10}).ticks == 10_000


def test_a_fault_of_a_scene_begins_with_its_place():
    with pytest.raises(ly.SceneError) as told:
        ly.Scene({**TABLES, "servo_rate": -1.0}, name="mine")
    assert str(told.value).startswith("mine:")
