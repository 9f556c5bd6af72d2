"""The lab, against the command."""

import json
import os
import re
import signal
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from pathlib import Path

import lyapunov as ly
import numpy as np
import pytest

ROOT = Path(__file__).parents[3]
SCENES = ROOT / "scenes"
WALL = str(SCENES / "paper-8k-popc.toml")
BARE = str(SCENES / "paper-50k-none.toml")


def command(*words):
    """What the command prints; it runs in a process of its own."""
    called = [sys.executable, "-m", "lyapunov", *words]
    return subprocess.run(called, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize("scene", [WALL, BARE])
def test_a_run_is_that_of_the_command(scene, tmp_path):
    run = ly.run(scene)
    assert run.json == command("run", scene, "--json")
    assert str(run) == command("run", scene).replace("`lyapunov ", "`lyapunov.")
    rows = tmp_path / "rows.csv"
    command("run", scene, "--csv", str(rows), "--quiet")
    lines = [line for line in rows.read_text().splitlines() if not line.startswith("#")]
    assert list(run.table) == lines[0].split(",")
    told = np.array([[float(field) for field in line.split(",")] for line in lines[1:]])
    assert np.array_equal(np.column_stack(list(run.table.values())), told)
    assert run.verdict == ("settles" if scene == WALL else "grows")


@pytest.mark.parametrize("study, name", [(ly.bound, "bound"), (ly.explain, "explain")])
@pytest.mark.parametrize("scene", [WALL, BARE])
def test_studies_of_a_scene_are_those_of_the_command(study, name, scene):
    told = study(scene)
    assert told.json == command(name, scene, "--json")
    assert str(told) == command(name, scene).replace("`lyapunov ", "`lyapunov.")


def without(text, document):
    """A JSON text without the values of the keys that it says come from a clock or a machine."""
    for key in document.get("not_deterministic", ()):
        text = re.sub(rf'"{key}": (\{{[^}}]*\}}|[^,\n]*)', f'"{key}": 0', text)
    return text


def test_a_comparison_is_that_of_the_command():
    told = ly.compare(WALL, BARE, stabilizers=["none", "popc", "tank"])
    text = command("compare", WALL, BARE, "--stabilizers", "none,popc,tank", "--json")
    assert told.document["not_deterministic"] == ["ns_per_step"]
    assert without(told.json, told.document) == without(text, told.document)
    assert len(told.document["rows"]) == 6


X, Y = "environment.wall.stiffness=500..9000:12", "device.mass=0.1..0.4:5"


def test_a_map_is_that_of_the_command(tmp_path):
    told = ly.map(WALL, X, Y, stabilizers="none,popc", threads=2)
    text = command("map", WALL, "--x", X, "--y", Y, "--stabilizers", "none,popc", "--threads", "2", "--json", "--out", str(tmp_path))
    assert without(told.json, told.document) == without(text, told.document)
    rows = [line for line in (tmp_path / "map.csv").read_text().splitlines() if not line.startswith("#")]
    assert list(told.table) == rows[0].split(",")
    assert told.table["verdict"] == [row.split(",")[3] for row in rows[1:]]
    numbers = [float(row.split(",")[5] or "nan") for row in rows[1:]]
    assert np.array_equal(told.table["peak_force_n"], numbers, equal_nan=True)


def test_a_sweep_is_that_of_the_command():
    told = ly.map(WALL, X, stabilizers="popc")
    text = command("map", WALL, "--x", X, "--stabilizers", "popc", "--json")
    assert without(told.json, told.document) == without(text, told.document)


def test_tuning_is_that_of_the_command():
    told = ly.tune(WALL, stabilizers="popc", trials=6, runs=2, seed=3)
    text = command("tune", WALL, "--stabilizers", "popc", "--trials", "6", "--runs", "2", "--seed", "3", "--json")
    assert told.json == text
    assert ly.run(told.scenes["popc"]).verdict in {"settles", "swinging"}


def test_a_log_is_observed_as_by_the_command(tmp_path):
    log = str(tmp_path / "log.csv")
    command("run", BARE, "--csv", log, "--quiet")
    assert ly.observe(log).json == command("observe", log, "--json")
    told = ly.observe(log, stabilizers="popc", scene=BARE, candidate="device-damping", damping=0.001)
    text = command(
        "observe", log, "--stabilizers", "popc", "--scene", BARE, "--candidate", "device-damping", "--damping", "0.001", "--json"
    )
    assert told.json == text
    with pytest.raises(ly.InputError, match="no such file|No such file"):
        ly.observe("nowhere.csv")


@pytest.mark.skipif(ly._lyapunov.debug_assertions, reason="a study of times takes a minute in a build for tests")
def test_accuracy_is_that_of_the_command(tmp_path):
    file = tmp_path / "short.toml"
    file.write_text(ly.Scene({**ly.Scene(BARE).to_dict(), "duration": 0.1}).to_toml())
    told, other = ly.accuracy(file, target=1e-9), json.loads(command("accuracy", str(file), "--target", "1e-9", "--json"))
    fixed = ("propagator", "steps_per_tick", "tolerance", "scalar", "max_error", "horizon_s")
    rows = [sorted(str([row[key] for key in fixed]) for row in document["rows"]) for document in (told.document, other)]
    assert rows[0] == rows[1] and "the fastest within 1e-9 m" in str(told)


def test_accuracy_refuses_what_it_cannot_study():
    with pytest.raises(ly.InputError, match="target is -1.0"):
        ly.accuracy(BARE, target=-1.0)
    with pytest.raises(ly.InputError, match=r"\[space\] is not for this study"):
        ly.accuracy(str(SCENES / "plane.toml"))


TABLES = {"duration": 1.0, "servo_rate": 1000, "device": {"mass": 0.2}, "environment": {"wall": {"stiffness": 8000.0}}}


def test_a_dictionary_is_a_scene_as_a_file_is(tmp_path):
    file = tmp_path / "wall.toml"
    file.write_text("duration = 1.0\nservo_rate = 1000\ndevice.mass = 0.2\nenvironment.wall.stiffness = 8000.0\n")
    scene = ly.Scene(TABLES, name=str(file))
    assert scene == ly.Scene(file) and scene.ticks == 1000 and scene.dimensions == 1
    assert ly.Scene(scene.to_dict(), name=scene.name) == scene
    arrays = {**TABLES, "device": {"mass": np.float64(0.2)}, "servo_rate": np.int64(1000)}
    assert ly.Scene(arrays, name=scene.name) == scene
    assert ly.run(scene).json == command("run", str(file), "--json")


def test_a_wrong_scene_names_key_place_and_remedy(tmp_path):
    file = tmp_path / "wall.toml"
    file.write_text("duration = 1.0\nservo_rate = 1000\ndevice.mass = 0.2\nenvironment.wall.stifness = 8000.0\n")
    with pytest.raises(ly.SceneError, match="did you mean `stiffness`") as told:
        ly.Scene(file)
    assert told.value.key == "environment.wall.stifness"
    assert (told.value.line, told.value.name) == (4, str(file))
    assert told.value.remedies
    said = subprocess.run([sys.executable, "-m", "lyapunov", "run", str(file)], capture_output=True, text=True, check=False)
    assert said.returncode == 2 and said.stderr.strip() == f"error: {told.value}".strip()
    wrong = {**TABLES, "device": {"mass": -0.2}}
    with pytest.raises(ly.SceneError) as told:
        ly.Scene(wrong)
    assert (told.value.key, told.value.value) == ("device.mass", "-0.2")
    with pytest.raises(ly.InputError, match="`device.mass` is object, which no scene holds"):
        ly.Scene({**TABLES, "device": {"mass": object()}})
    with pytest.raises(TypeError, match="a dictionary, or the path"):
        ly.Scene(3)


@pytest.mark.parametrize(
    "call, message",
    [
        (lambda: ly.run(WALL, stabilizer="popcorn"), "no stabilizer is called `popcorn`"),
        (lambda: ly.compare(WALL, stabilizers="popc,popc"), "`popc` is named twice"),
        (lambda: ly.compare(WALL, by="beauty"), "no column has that name"),
        (lambda: ly.map(WALL, "device.mass"), "give KEY=FROM..TO:N"),
        (lambda: ly.map(WALL, "device.mas=0.1..0.2:3"), "device.mas"),
        (lambda: ly.tune(WALL, stabilizers="none"), "nothing to tune"),
        (lambda: ly.tune(WALL, runs=1), "runs is 1"),
        (lambda: ly.tune(WALL, objective="fame"), "fame"),
    ],
)
def test_wrong_input_is_said_in_the_words_of_the_command(call, message):
    with pytest.raises(ly.InputError, match=message):
        call()


class Damper:
    """A constant damper of 5 N·s/m."""

    def stabilize(self, sample, effort):
        return ly.Correction(effort + 5.0 * sample.velocity, alpha=5.0)


class PopcByHand:
    """POPC in Python."""

    def __init__(self, limit):
        self.energy, self.limit = 0.0, limit

    def stabilize(self, sample, effort):
        self.energy += sample.work
        observed, square = self.energy, sample.velocity**2 * sample.period
        alpha = min(-self.energy / square, self.limit) if self.energy < 0.0 and square > 2.3e-308 else 0.0
        return ly.Correction(effort + alpha * sample.velocity, observed_energy=observed, alpha=alpha)


def test_a_stabilizer_in_python_runs_in_scenes():
    # At 50 kN/m the loop contracts, so that rounding does not grow.
    scene = ly.Scene(str(SCENES / "paper-50k-popc.toml"))
    limit = ly.damping_limit(0.3, 0.01)
    own, ours = ly.run(scene, stabilizer=PopcByHand(limit)), ly.run(scene)
    assert own.verdict == ours.verdict
    assert own.table["x"] == pytest.approx(ours.table["x"], abs=1e-6)
    short = ly.Scene({**scene.to_dict(), "duration": 0.5})
    told = ly.compare(short, stabilizers="none", own={"damper": lambda scene: Damper()})
    assert [row["stabilizer"] for row in told.document["rows"]] == ["none", "damper"]

    class Broken:
        def stabilize(self, sample, effort):
            raise KeyError("mine")

    with pytest.raises(KeyError, match="mine"):
        ly.run(scene, stabilizer=Broken())
    with pytest.raises(KeyError, match="mine"):
        ly.compare(short, stabilizers="none", own={"broken": lambda scene: Broken()})


def test_words_name_functions():
    """The command has others; what it prints is the same."""
    told = str(ly.run(ly.Scene.shipped("paper-50k-none"), rows=False))
    assert "`lyapunov.explain` says where" in told and "`lyapunov explain`" not in told
    many = str(ly.map(WALL, "device.mass=0.1..0.4:40"))
    assert "120 rows: `table` has them" in many


def test_progress_is_told():
    told = []
    ly.tune(WALL, stabilizers="popc", trials=20, runs=8, progress=lambda done, total: told.append((done, total)))
    assert told[-1][0] == told[-1][1] > 0
    assert all(one[0] <= other[0] for one, other in zip(told, told[1:]))


def test_the_progress_of_a_run_stays_within_its_total():
    told = []
    ly.run({**ly.Scene(WALL).to_dict(), "duration": 600.0}, progress=lambda done, total: told.append((done, total)))
    assert all(0 <= done <= total == 60_000 for done, total in told)
    assert all(one[0] <= other[0] for one, other in zip(told, told[1:]))


@contextmanager
def interrupted():
    """An interrupt half a second from now, that has to end what is done meanwhile."""
    # Whoever starts the tests in the background has them ignore interrupts.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    began = time.monotonic()
    try:
        with pytest.raises(KeyboardInterrupt):
            yield
    finally:
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - began < 30.0


def test_an_interrupt_ends_long_work():
    endless = {**ly.Scene(WALL).to_dict(), "duration": 1e6}
    with interrupted():
        ly.map(endless, "environment.wall.stiffness=500..9000:300", "device.mass=0.1..0.4:300", stabilizers="popc")


def test_an_interrupt_ends_closed_loops():
    with interrupted():
        ly.closed_loop(10**12, 1e-3, mass=np.linspace(1.0, 2.0, 100), wall_stiffness=1.0)
    with interrupted():
        ly.closed_loop(10**9, 1e-3, mass=np.linspace(1.0, 2.0, 10**5), wall_stiffness=1.0, stabilizer=ly.Stabilizer("tank", start=1.0))


def test_an_explanation_does_not_go_on_after_an_interrupt():
    with interrupted():
        ly.explain({**ly.Scene(WALL).to_dict(), "duration": 1e6})
    used = time.process_time()
    time.sleep(1.0)
    assert time.process_time() - used < 0.3


def test_what_progress_raises_ends_the_work():
    def stop(done, total):
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        ly.tune(WALL, trials=2000, runs=64, progress=stop)


def test_tables_in_all_forms():
    told = ly.compare(WALL, stabilizers="none,popc")
    columns = list(told.table)
    for module, make in (("pandas", told.to_pandas), ("polars", told.to_polars), ("pyarrow", told.to_arrow)):
        pytest.importorskip(module)
        table = make()
        names = table.column_names if module == "pyarrow" else list(table.columns)
        assert names == columns and len(table) == 2
    text = told._repr_html_()
    assert "<table>" in text and "<svg" in text and "popc" in text
    assert json.loads(told.json) == told.document


def test_every_result_draws_itself():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    drawn = [
        ly.run(WALL).plot(),
        ly.compare(WALL, stabilizers="none,popc").plot(column="peak_force_short_contact_n"),
        ly.map(WALL, X, Y, stabilizers="popc").plot(),
        ly.map(WALL, X, stabilizers="popc").plot(),
        ly.bound(WALL).plot(),
        ly.explain(BARE).plot(),
    ]
    for ax in drawn:
        assert ax.lines or ax.patches or ax.collections


def test_scenes_travel():
    import pickle

    scene = ly.Scene(WALL)
    assert pickle.loads(pickle.dumps(scene)) == scene
    shipped = ly.Scene.shipped("paper-8k-popc")
    assert shipped.to_dict() == scene.to_dict()


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork here")
def test_work_goes_on_after_a_fork():
    # Threads are there before: a child has none of them.
    expected = ly.tune(WALL, stabilizers="popc", trials=2, runs=2).json
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reader)
        told = ly.tune(WALL, stabilizers="popc", trials=2, runs=2).json
        os.write(writer, b"same" if told == expected else b"other")
        os._exit(0)
    os.close(writer)
    signal.alarm(60)
    assert os.read(reader, 5) == b"same"
    signal.alarm(0)
    os.waitpid(child, 0)


def test_a_merge_that_is_refused_or_inherited_leaves_its_folder_alone(tmp_path):
    scene = ly.Scene(WALL).to_dict()
    asked = (ly.Scene({**scene, "duration": 0.1}), "environment.wall.stiffness=500..9000:4", "device.mass=0.1..0.4:4", "popc")
    tables = [tmp_path / f"{index}.csv" for index in range(2)]
    for index, table in enumerate(tables):
        table.write_bytes(ly._lyapunov.map_shard(*asked, f"{index}/2"))
    (tmp_path / "bad.csv").write_text("no table")
    with pytest.raises(ly.InputError, match="bad.csv"):
        ly._lyapunov.MapMerge(tmp_path / "bad.csv", tmp_path / "out.csv")
    assert not list(tmp_path.glob("*.begun"))
    merge = ly._lyapunov.MapMerge(tables[0], tmp_path / "out.csv")
    with pytest.raises(ly.InputError, match="shard 0/2 is missing"):
        merge.add(tables[1])
    merge = ly._lyapunov.MapMerge(tables[0], tmp_path / "out.csv")
    for table in tables:
        merge.add(table)
    child = os.fork()
    if child == 0:
        del merge
        os._exit(0)
    os.waitpid(child, 0)
    merge.end()
    whole = ly._lyapunov.map_shard(*asked, "0/1")
    assert (tmp_path / "out.csv").read_bytes() == whole
    assert not list(tmp_path.glob("*.begun"))
