"""Tables: their columns and types are the same whatever the numbers are."""

import subprocess
import sys
from pathlib import Path

import lyapunov as ly
import numpy as np
import pytest

TABLES = {"duration": 1.0, "servo_rate": 1000, "device": {"mass": 0.2}, "environment": {"wall": {"stiffness": 8000.0}}}
WORDS = {"scene", "stabilizer", "verdict", "judged_by"}


def kinds(table):
    def kind(name, column):
        if isinstance(column, np.ndarray):
            return {"f": "numbers", "i": "counts", "b": "truths"}[column.dtype.kind]
        return "words" if name in WORDS else "judgements" if set(column) <= {True, False, None} else "?"

    return {name: kind(name, column) for name, column in table.items()}


def of_scores(table):
    rare = {"broke_it": "judgements", "state_bytes": "counts"}
    return {name: "words" if name in WORDS else rare.get(name, "numbers") for name in table}


def test_a_column_without_a_number_is_one_of_numbers():
    """Nothing settles and nothing is felt in a scene that grows."""
    scene = ly.Scene.shipped("paper-50k-none")
    one, two = ly.compare(scene, stabilizers="none").table, ly.compare(scene, stabilizers="none,popc").table
    assert kinds(one) == kinds(two) == of_scores(one)
    assert np.isnan(one["settling_time_s"]).all() and one["settling_time_s"].dtype == np.float64
    sweep = ly.map(scene, "environment.wall.stiffness=50000..60000:2", stabilizers="none").table
    assert kinds(sweep) == of_scores(sweep) and "broke_it" in sweep


def test_truths_are_truths_in_every_form():
    scene = ly.Scene.shipped("paper-50k-none")
    told, alone = ly.compare(scene, stabilizers="none,popc"), ly.compare(scene, stabilizers="popc")
    assert told.table["broke_it"] == [False, False] and alone.table["broke_it"] == [None]
    assert told.table["state_bytes"].dtype == np.int64
    assert str(told.to_pandas()["broke_it"].dtype) == str(alone.to_pandas()["broke_it"].dtype) == "boolean"
    assert str(told.to_polars()["broke_it"].dtype) == str(alone.to_polars()["broke_it"].dtype) == "Boolean"
    assert str(told.to_arrow()["broke_it"].type) == str(alone.to_arrow()["broke_it"].type) == "bool"
    assert ly.run(scene).table["accepted"].dtype == bool
    assert ly.ensemble(scene, 3).table["member"].tolist() == [0, 1, 2]
    assert "<td>False</td>" in told._repr_html_() and "<td>-</td>" in alone._repr_html_()


@pytest.mark.parametrize("name", ["#1", "50000", "nan", 'a,"b', "inf"])
def test_a_scene_may_have_any_name(name):
    table = ly.compare(ly.Scene(TABLES, name=name), stabilizers="none,popc").table
    assert table["scene"] == [name, name] and table["stabilizer"] == ["none", "popc"]
    assert all(len(column) == 2 for column in table.values())


def test_the_numbers_are_those_of_the_document():
    told = ly.compare(ly.Scene.shipped("paper-8k-popc"), stabilizers="none,popc,tank")
    for row, values in enumerate(told.document["rows"]):
        for name, column in told.table.items():
            # A time of a step is a range in the document.
            if name in values and isinstance(column, np.ndarray) and not isinstance(values[name], dict):
                expected = np.nan if values[name] is None else values[name]
                assert column[row] == expected or np.isnan([column[row], expected]).all(), name


def test_a_log_without_contacts_has_the_columns_of_one_with_them(tmp_path):
    log, table = tmp_path / "log.csv", {}
    for kind, force in (("contact", 5.0), ("none", 0.0)):
        rows = [f"{1e-3 * tick},{1e-4 * tick},{force if 20 < tick < 60 else 0.0}" for tick in range(100)]
        log.write_text("\n".join(["t,x,f", *rows]) + "\n")
        table[kind] = ly.observe(log).table
        out = tmp_path / kind
        subprocess.run([sys.executable, "-m", "lyapunov", "observe", str(log), "--out", str(out), "--quiet"], check=True)
    assert kinds(table["contact"]) == kinds(table["none"]) and len(table["none"]["start"]) == 0
    header, row = (tmp_path / "contact" / "observe.csv").read_text().splitlines()
    assert list(table["contact"]) == header.split(",")
    assert [column[0] for column in table["contact"].values()] == [float(field or "nan") for field in row.split(",")]


def test_a_number_that_is_not_there_is_null():
    """As NaN it would be taken for a number, the largest of all."""
    told = ly.compare(ly.Scene.shipped("paper-50k-none"), stabilizers="none")
    assert np.isnan(told.table["settling_time_s"]).tolist() == [True]
    pytest.importorskip("polars")
    assert told.to_polars()["settling_time_s"].to_list() == [None] and str(told.to_polars()["settling_time_s"].dtype) == "Float64"
    pytest.importorskip("pyarrow")
    assert told.to_arrow()["settling_time_s"].to_pylist() == [None] and str(told.to_arrow()["settling_time_s"].type) == "double"


def test_the_table_of_a_replay_is_shown_as_one():
    steps = np.arange(200)
    log = {"t": 1e-3 * steps, "x": 1e-3 * np.sin(0.04 * steps), "f": np.maximum(0.0, 8.0 * np.sin(0.04 * steps + 0.3))}
    told = ly.observe(log, stabilizers="popc", scene=ly.Scene(TABLES)).replay
    assert repr(told).startswith("<Table: stabilizer, ") and "<td>popc</td>" in told._repr_html_()
    assert repr(ly.observe(log).replay) == "<Table: >" and "Table" in ly.observe(log).replay._repr_html_()


RESULTS = [ly.Run, ly.Comparison, ly.Map, ly.Bound, ly.Explanation, ly.Accuracy, ly.Tuning, ly.Observation, ly.Ensemble]


@pytest.mark.parametrize("kind", RESULTS)
def test_the_page_has_what_a_result_has(kind):
    page = (Path(__file__).parents[3] / "docs" / "python.md").read_text()
    missing = [name for name in dir(kind) if not name.startswith("_") and f"`{name}" not in page]
    assert not missing
