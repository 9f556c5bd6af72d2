"""Scenes that travel: as text, as dictionaries, by pickle."""

import copy
import pickle
from pathlib import Path

import lyapunov as ly
import pytest

ROOT = Path(__file__).parents[3]
SCENES = sorted((ROOT / "scenes").glob("*.toml"))
TABLES = {"duration": 1.0, "servo_rate": 1000, "device": {"mass": 0.2}, "environment": {"wall": {"stiffness": 8000.0}}}


def copies(scene):
    return [
        pickle.loads(pickle.dumps(scene)),
        copy.copy(scene),
        copy.deepcopy(scene),
        ly.Scene(scene.to_dict(), name=scene.name),
        ly.Scene.parse(scene.to_toml(), name=scene.name),
    ]


@pytest.mark.parametrize("file", SCENES, ids=[file.stem for file in SCENES])
def test_a_copy_is_the_scene(file):
    scene = ly.Scene(file)
    assert all(again == scene for again in copies(scene))


def test_the_scenes_that_ship_are_listed():
    told = ly.scenes()
    assert sorted(told) == [file.stem for file in SCENES]
    for name, comment in told.items():
        lines = (ROOT / "scenes" / f"{name}.toml").read_text().splitlines()
        assert comment.splitlines() == [line[2:] for line in lines if line.startswith("# ")][:2]
        assert ly.Scene.shipped(name).name == name
    with pytest.raises(ly.InputError, match="`lyapunov.scenes` lists them"):
        ly.Scene.shipped("nobody")


@pytest.mark.parametrize("effects", [{}, {"delay": {"ticks": 0}}, {"delay": {"ticks": 8}}])
@pytest.mark.parametrize("name", ["popc", "lolc", "popc-bounded", "tank"])
def test_a_cap_that_is_left_out_stays_left_out(name, effects):
    scene = ly.Scene({**TABLES, "stabilizer": {name: {}}, "effects": effects})
    assert all(again == scene for again in copies(scene))
    assert "damping_cap" not in scene.to_dict()["stabilizer"][name]
    # A delay that is added to the copy sets the cap, as where the file has it from the start.
    later = ly.Scene({**scene.to_dict(), "effects": {"delay": {"ticks": 5}}})
    assert later == ly.Scene({**TABLES, "stabilizer": {name: {}}, "effects": {"delay": {"ticks": 5}}})


def test_a_recorded_motion_travels_with_its_scene(tmp_path, monkeypatch):
    shipped, read = ly.Scene.shipped("motion-file"), ly.Scene(ROOT / "scenes" / "motion-file.toml")
    monkeypatch.chdir(tmp_path)
    for scene in (shipped, ly.Scene.shipped("motion-file"), read):
        assert pickle.loads(pickle.dumps(scene)) == copy.deepcopy(scene) == scene
    expected = ly.run(read).table
    for name, column in ly.run(pickle.loads(pickle.dumps(shipped))).table.items():
        assert list(column) == list(expected[name]), name


def test_what_is_told_of_a_run_has_the_cap_that_ran():
    told = ly.run({**TABLES, "stabilizer": {"popc": {}}})
    assert "damping_cap = 0.5" in told.document["file"]["scene"]
