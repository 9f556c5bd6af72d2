"""Recorded logs in memory: they are observed as their files are."""

import lyapunov as ly
import numpy as np
import pytest

ROWS = ly.run(ly.Scene.shipped("paper-50k-none")).table
LOG = {"t": ROWS["t"], "x": ROWS["x"], "f": ROWS["f_act"]}


def numbers(told):
    return {key: value for key, value in told.document.items() if key not in ("log", "columns")}


@pytest.fixture(scope="module")
def of_file(tmp_path_factory):
    file = tmp_path_factory.mktemp("logs") / "log.csv"
    rows = "\n".join(",".join(repr(float(it)) for it in row) for row in zip(*LOG.values()))
    file.write_text("t,x,f\n" + rows + "\n")
    return ly.observe(file)


@pytest.mark.parametrize("form", ["dictionary", "pandas", "polars", "array", "structured"])
def test_a_table_is_observed_as_its_file(of_file, form):
    if form in ("pandas", "polars"):
        log = pytest.importorskip(form).DataFrame(LOG)
    elif form == "array":
        log = np.column_stack(list(LOG.values()))
    elif form == "structured":
        log = np.rec.fromarrays(list(LOG.values()), names=list(LOG))
    else:
        log = LOG
    told = ly.observe(log)
    assert numbers(told) == numbers(of_file) and told.document["log"] == "log"


def test_columns_and_scales_may_be_lists(of_file):
    log = {"time": 1e3 * ROWS["t"], "place": ROWS["x"], "push": -ROWS["f_act"]}
    told = ly.observe(log, columns=["time", "place", "push"], scale=["t=1e-3", "f=-1"])
    assert told.table["generated"] == pytest.approx(of_file.table["generated"])


@pytest.mark.parametrize(
    "log, message",
    [
        (3, "^the log is int\n  = give a path, a dictionary"),
        (np.zeros((4, 2)), r"^the log is an array of shape \(4, 2\)"),
        ({"t": [0.0, 1.0], "x": [0.0], "f": [0.0, 0.0]}, "not equally long: t has 2, x has 1, f has 2 rows"),
        ({"t": [0.0, "a"], "x": [0.0], "f": [0.0]}, "the column t of the log holds what is no number"),
        ({"t": np.ma.masked_equal([0.0, 1.0], 1.0)}, "the column t of the log is a masked array"),
        ({"t": np.zeros((2, 2))}, r"the column t of the log has the shape \(2, 2\)"),
        ({"t": [0.0], "x": [0.0], "g": [0.0]}, 'name the column of f with columns="T,X,F"'),
    ],
)
def test_what_is_no_log_is_told_as_such(log, message):
    with pytest.raises(ly.InputError, match=message):
        ly.observe(log)


def test_what_stabilizers_would_have_done_is_a_table():
    told = ly.observe(LOG, stabilizers="popc,tank", scene=ly.Scene.shipped("paper-50k-none"))
    rows = told.document["replay"]["stabilizers"]
    table = told.replay.table
    assert table["stabilizer"] == [row["stabilizer"] for row in rows] == ["popc", "tank"]
    assert table["ticks"].tolist() == [row["ticks"] for row in rows] and table["ticks"].dtype == np.int64
    assert table["energy_taken"].tolist() == [row["energy_taken"] for row in rows]
    assert ly.observe(LOG).replay.table == {}
