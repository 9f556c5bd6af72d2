"""Numbers that an argument does not take: the error names the argument, its value and the range."""

import lyapunov as ly
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
@pytest.mark.parametrize("value", [-1, 10**30])
def test_a_whole_number_out_of_range_is_named(name, call, value):
    with pytest.raises(ly.InputError, match=f"^{name} is {value}; it must be a whole number from 0 to "):
        call(value)
    with pytest.raises(TypeError):
        call("one")


def test_a_number_too_large_for_a_scene_is_named():
    with pytest.raises(ly.InputError, match=f"`duration` is {10**30}, which is no number of 64 bits"):
        ly.Scene({**TABLES, "duration": 10**30})
    assert ly.Scene({**TABLES, "duration": 10}).ticks == 10_000


def test_a_fault_of_a_scene_begins_with_its_place():
    with pytest.raises(ly.SceneError) as told:
        ly.Scene({**TABLES, "servo_rate": -1.0}, name="mine")
    assert str(told.value).startswith("mine:")
