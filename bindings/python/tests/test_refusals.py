"""Numbers that an argument does not take: the error names the argument, its value and the range."""

import subprocess
import sys
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


class Mine:
    def stabilize(self, sample, effort):
        return ly.Correction(effort)


@pytest.mark.parametrize(
    "what, call",
    [
        ("tune takes no own", lambda: ly.tune(TABLES, own={"mine": Mine})),
        ("map takes no own", lambda: ly.map(TABLES, "device.mass=0.1..0.2:2", own={"mine": Mine})),
        ("ensemble takes no own", lambda: ly.ensemble(TABLES, 2, own={"mine": Mine})),
        ("stabilizer is Mine", lambda: ly.ensemble(TABLES, 2, stabilizer=Mine())),
        ("stabilizers is Mine", lambda: ly.tune(TABLES, stabilizers=Mine())),
        ("observe takes no own", lambda: ly.observe(LOG, own={"mine": Mine})),
        ("stabilizers holds Mine", lambda: ly.map(TABLES, "device.mass=0.1..0.2:2", stabilizers=["none", Mine()])),
        ("stabilizers is Mine", lambda: ly.compare(TABLES, stabilizers=Mine())),
        ("stabilizers holds Stabilizer", lambda: ly.observe(LOG, stabilizers=[ly.Stabilizer("none")], scene=TABLES)),
    ],
)
def test_where_no_stabilizer_in_python_runs_says_where_one_does(what, call):
    where = r"this study takes names of .* = an object, as one written in Python, runs in run\(.*compare\("
    with pytest.raises(TypeError, match=f"(?s)^{what}; {where}"):
        call()


def test_an_ensemble_runs_under_one_stabilizer():
    with pytest.raises(TypeError, match="^stabilizer is list; give one name, a str$"):
        ly.ensemble(TABLES, 2, stabilizer=["popc", "lolc"])


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


@pytest.mark.parametrize("stem", ["paper-50k-none", "a-scene-of-which-nobody-knows"])
def test_a_shipped_scene_is_no_path(stem, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(ly.SceneError) as told:
        ly.run(stem)
    shipped = f'`lyapunov.Scene.shipped("{stem}")` is the shipped scene of that name'
    assert (shipped in told.value.remedies[0]) == (stem in ly.scenes()) and "python -m" not in str(told.value)
    assert (shipped in " ".join(str(told.value).split())) == (stem in ly.scenes())


LOG = {"t": [0.0, 1.0], "x": [0.0, 0.0], "f": [0.0, 0.0]}


@pytest.mark.parametrize(
    "name, call",
    [
        ("period", lambda it: ly.Readings(it)),
        ("no_faster_than", lambda it: ly.Readings(PERIOD, no_faster_than=it)),
        ("cutoff", lambda it: ly.Readings(PERIOD, cutoff=it)),
        ("now", lambda it: ly.Readings(PERIOD, clocked=True).read(0.0, 0.0, now=it)),
        ("mass", lambda it: ly.damping_limit(it, PERIOD)),
        ("period", lambda it: ly.damping_limit(1.0, it)),
        ("cap", lambda it: ly.damping_limit(1.0, PERIOD, cap=it)),
        ("period", lambda it: ly.Batch(ly.Stabilizer("none"), 8, it)),
        ("no_faster_than", lambda it: ly.Batch(ly.Stabilizer("none"), 8, PERIOD, no_faster_than=it)),
        ("period", lambda it: ly.closed_loop(3, it, mass=1.0, wall_stiffness=1.0)),
        ("period", lambda it: ly.Sample(it, 0.0, 0.0, 0.0, 0.0)),
        ("observed_energy", lambda it: ly.Correction(0.0, observed_energy=it)),
        ("alpha", lambda it: ly.Correction(0.0, alpha=it)),
        ("shortfall", lambda it: ly.Correction(0.0, shortfall=it)),
        ("damping", lambda it: ly.Observer(damping=it)),
        ("limit", lambda it: ly.Stabilizer("popc", limit=it)),
        ("mass", lambda it: ly.ensemble(TABLES, 2, mass=it)),
        ("phase", lambda it: ly.ensemble(TABLES, 2, phase=it)),
        ("damping", lambda it: ly.ensemble(TABLES, 2, damping=it)),
        ("stiffness", lambda it: ly.ensemble(TABLES, 2, stiffness=it)),
        ("target", lambda it: ly.accuracy(TABLES, target=it)),
        ("damping", lambda it: ly.observe(LOG, damping=it)),
        ("surface", lambda it: ly.observe(LOG, surface=it)),
        ("contact", lambda it: ly.observe(LOG, contact=it)),
    ],
)
def test_what_is_no_number_is_named(name, call):
    """On every Python: the interpreter itself names the argument from 3.11 on."""
    for wrong, kind in (
        ("1", "str"),
        (1j, "complex"),
        (np.complex64(1.0), "complex64"),
        (np.ones(1), r"an array of float64 of shape \[1\]"),
        (np.array("1"), r"an array of <U1 of shape \[\]"),
        (np.timedelta64(1, "s"), "timedelta64"),
    ):
        with pytest.raises(TypeError, match=rf"^{name} is {kind}, which is no number\n  = give a float"):
            call(wrong)


@pytest.mark.parametrize(
    "name, call",
    [
        ("measured", lambda it: ly.Readings(PERIOD, measured=it)),
        ("clocked", lambda it: ly.Readings(PERIOD, clocked=it)),
        ("accepted", lambda it: ly.Correction(0.0, accepted=it)),
        ("rows", lambda it: ly.run(TABLES, rows=it)),
    ],
)
def test_what_is_no_truth_is_named(name, call):
    for wrong, kind in ((1, "int"), (None, "NoneType"), ("no", "str")):
        with pytest.raises(TypeError, match=f"^{name} is {kind}, which is no truth\n  = give True or False"):
            call(wrong)
    call(np.False_)


@pytest.mark.parametrize("wrong", [1j, np.complex128(1.0), np.complex64(1.0), np.array(1j), np.array("1"), np.str_("1"), np.array(None)])
def test_a_signal_is_real(wrong):
    with pytest.raises(TypeError, match="^position is .*; give a number$"):
        ly.Readings(PERIOD).read(wrong, 0.0)
    with pytest.raises(TypeError, match=r"^applied is list; give an array of real numbers of shape \(2,\)"):
        ly.Readings(PERIOD, axes=2).read([0.0, 0.0], [0.0, wrong])
    # A real one is taken in every form.
    for right in (1, True, np.array(1.0), np.float32(1.0), np.uint8(1), np.True_):
        assert ly.Readings(PERIOD).read(0.0, right).applied == 1.0


def test_an_error_of_a_number_is_its_own():
    class Broken:
        def __float__(self):
            raise LookupError("mine")

    for call in (
        lambda it: ly.Readings(PERIOD).read(it, 0.0),
        lambda it: ly.Readings(PERIOD, axes=2).read([0.0, it], [0.0, 0.0]),
        lambda it: ly.Stabilizer("popc", limit=it),
        lambda it: ly.Readings(it),
        lambda it: ly.closed_loop(3, PERIOD, mass=it, wall_stiffness=1.0),
    ):
        with pytest.raises(LookupError, match="^mine"):
            call(Broken())


def test_forgotten_axes_are_the_remedy():
    for several in ([0.0, 0.0, 0.0], np.zeros(3), np.zeros(3, dtype=int)):
        with pytest.raises(TypeError, match="^position is .*; give a number, or make it with axes=3$"):
            ly.Readings(PERIOD).read(several, 0.0)
    with pytest.raises(TypeError, match=r"^effort is .*; give an array of .* of 6 numbers, or make it with axes=3$"):
        ly.Correction(np.zeros(3), axes=6)
    for none in (np.zeros(4), np.zeros((3, 1)), "abc"):
        with pytest.raises(TypeError, match="give a number$"):
            ly.Readings(PERIOD).read(none, 0.0)


def test_readings_of_other_axes_are_told_as_such():
    with pytest.raises(ly.InputError, match="^the readings have 1 axis and the stabilizer 3; make both with the same axes=$"):
        ly.replay(ly.Readings(PERIOD), ly.Stabilizer("none", axes=3), *np.zeros((3, 4, 3)))
    with pytest.raises(ly.InputError, match="^the readings have 2 axes and the stabilizer 1; make both"):
        ly.replay(ly.Readings(PERIOD, axes=2), ly.Stabilizer("none"), *np.zeros((3, 4)))


@pytest.mark.parametrize(
    "call",
    [
        lambda it: ly.compare(TABLES, stabilizers=it),
        lambda it: ly.map(TABLES, "device.mass=0.1..0.2:2", stabilizers=it),
        lambda it: ly.tune(TABLES, stabilizers=it),
        lambda it: ly.observe(LOG, stabilizers=it, scene=TABLES),
    ],
)
def test_what_are_no_names_is_told_as_such(call):
    with pytest.raises(ly.InputError, match="^stabilizers is empty\n  = give one or more names"):
        call([])
    with pytest.raises(TypeError, match="^stabilizers is int; give a str, or a list of them"):
        call(3)
    for wrong, kind in ((1, "int"), (None, "NoneType")):
        with pytest.raises(TypeError, match=rf"^stabilizers holds .*, of the type {kind}; give a str, or a list of them"):
            call(["popc", wrong])


def test_a_package_that_is_not_there_says_how_it_is_installed():
    script = """
import sys
sys.modules["ray"] = None
try:
    import lyapunov.ray
except ModuleNotFoundError as missing:
    print(missing.name, missing, sep=": ")
"""
    told = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout
    assert told.startswith("ray: ") and told.endswith("; install it with `pip install ray`\n")
