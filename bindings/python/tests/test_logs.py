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


STEPS = np.arange(200)
SECONDS = {"t": STEPS / 1000, "x": 1e-3 * np.sin(0.04 * STEPS), "f": np.maximum(0.0, 8.0 * np.sin(0.04 * STEPS + 0.3))}


SINCE = r'give seconds: \(t - t\[0\]\) / numpy.timedelta64\(1, "s"\)'


@pytest.mark.parametrize(
    "column, told, remedy",
    [
        (STEPS.astype("m8[ms]"), r"times, of the type timedelta64\[ms\]", SINCE),
        (np.datetime64("2026-01-01", "ns") + STEPS.astype("m8[ms]"), r"times, of the type datetime64\[ns\]", SINCE),
        (SECONDS["t"] + 1j, "complex numbers, of the type complex128", "give real numbers"),
    ],
)
def test_times_and_complex_numbers_are_no_seconds(column, told, remedy):
    """As numbers they would be whole nanoseconds, or lose a part. What is told to do about times is right."""
    with pytest.raises(ly.InputError, match=rf"^the column t of the log holds {told}\n  = {remedy}$"):
        ly.observe({**SECONDS, "t": column})
    if column.dtype.kind != "c":
        seconds = (column - column[0]) / np.timedelta64(1, "s")
        assert numbers(ly.observe({**SECONDS, "t": seconds})) == numbers(ly.observe(SECONDS))


@pytest.mark.parametrize("form", ["pandas", "polars"])
def test_times_of_frames_are_no_seconds(form):
    library = pytest.importorskip(form)
    times = np.datetime64("2026-01-01", "us") + STEPS.astype("m8[ms]")
    with pytest.raises(ly.InputError, match=r"^the column t of the log holds times, of the type datetime64"):
        ly.observe(library.DataFrame({**SECONDS, "t": times}))


@pytest.mark.parametrize("columns", ["t,x,f", ["t", "x", "f"], "2,4,5"])
@pytest.mark.parametrize("other", [["a"] * 200, STEPS.astype("m8[ms]"), [None] * 200, [[0.0, 1.0]] * 200])
def test_a_column_that_nobody_asks_for_may_hold_anything(columns, other):
    log = {"label": other, "t": SECONDS["t"], "note": other, "x": SECONDS["x"], "f": SECONDS["f"]}
    assert numbers(ly.observe(log, columns=columns)) == numbers(ly.observe(SECONDS))
    with pytest.raises(ly.InputError):
        ly.observe(log, columns="label,x,f")


def test_a_column_that_is_asked_for_holds_numbers():
    log = {**SECONDS, "label": ["a"] * 200}
    for columns in ("label,x,f", "4,2,3", None):
        with pytest.raises(ly.InputError, match="^the column label of the log holds what is no number"):
            ly.observe(log, columns=columns)


def test_scales_may_be_a_dictionary():
    log = {**SECONDS, "x": 1e3 * SECONDS["x"]}
    by_words = ly.observe(log, scale=["x=1e-3", "f=-1"])
    assert numbers(ly.observe(log, scale={"x": np.float64(1e-3), "f": -1})) == numbers(by_words)
    assert numbers(ly.observe(SECONDS, scale=None)) == numbers(ly.observe(SECONDS))
    assert numbers(ly.observe(log, scale="x=1e-3,f=-1")) == numbers(by_words)
    with pytest.raises(ly.InputError, match="^`time` is none of t, x, f and v\n.*whatever the log calls them"):
        ly.observe({"time": log["t"], "x": log["x"], "f": log["f"]}, scale={"time": 1e-3})
    with pytest.raises(TypeError, match=r"^scale\['x'\] is 'mm'; give the factor to SI, a float"):
        ly.observe(log, scale={"x": "mm"})
    with pytest.raises(TypeError, match="^scale is int; give a str, or a list of them"):
        ly.observe(log, scale=3)


def test_rows_in_memory_are_counted_from_0():
    """A file has lines, and its options are those of the command."""
    force, time = SECONDS["f"].copy(), SECONDS["t"].copy()
    force[[50, 70]], time[30] = (np.nan, np.inf), time[29]
    told = ly.observe({"t": time, "x": SECONDS["x"], "f": force})
    for words in ("log: 197 rows", "row 50: f is `nan`", "row 70: f", "row 30: t = 0.029 s is not after 0.029 s of row 29"):
        assert words in str(told), words
    assert "line" not in str(told) and "--" not in str(told).split("contacts")[0] and "scale may be wrong" in str(told)
    assert [row["line"] for row in told.document["bad_rows"]["first"]] == [32, 52, 72]
    with pytest.raises(ly.InputError, match=r"(?s)^log: fewer than two .* the first at row 0: f"):
        ly.observe({"t": time[:3], "x": SECONDS["x"][:3], "f": [np.nan] * 3})
    with pytest.raises(ly.InputError, match="^log: there is no column `x`"):
        ly.observe({"t": time, "y": SECONDS["x"], "f": force})


def test_a_file_has_lines(tmp_path):
    file = tmp_path / "log.csv"
    file.write_text("t,x,f\n0,0,0\n1,0,nan\n2,0,0\n3,0,1\n")
    assert "line 3: f is `nan`" in str(ly.observe(file))


def test_signs_of_a_mistake_name_arguments():
    told = str(ly.observe({**SECONDS, "x": 1e5 * SECONDS["x"]}))
    assert 'scale="x=1e-3"' in told and "--scale" not in told
    assert "contact is 9 N" in str(ly.observe(SECONDS, contact=9.0))


def test_an_array_may_have_velocities():
    four = {**SECONDS, "v": np.full(200, 5.0)}
    credited = {"candidate": "device-damping", "damping": 1.0}
    named = numbers(ly.observe(four, columns="t,x,f,v", **credited))
    assert numbers(ly.observe(np.column_stack(list(four.values())), **credited)) == named
    assert named != numbers(ly.observe(SECONDS, **credited))


@pytest.mark.parametrize("labels", [[0, 1, 2], [1, 2, 3], ["time, s", "# x", "f\nN"], ["1e3", "nan", ""]])
def test_a_label_is_never_a_number(labels):
    log = pytest.importorskip("pandas").DataFrame(np.column_stack(list(SECONDS.values())), columns=labels)
    by_label = [str(label) for label in labels]
    for columns in (by_label, "1,2,3"):
        assert numbers(ly.observe(log, columns=columns)) == numbers(ly.observe(SECONDS))


def test_labels_come_before_numbers():
    log = pytest.importorskip("pandas").DataFrame(np.column_stack([STEPS, *SECONDS.values()]))
    assert numbers(ly.observe(log, columns="1,2,3")) == numbers(ly.observe(SECONDS))
    with pytest.raises(ly.InputError, match="the log has no column 7\n  = its columns are: 0, 1, 2, 3; or give"):
        ly.observe(log, columns="7,2,3")
    with pytest.raises(ly.InputError, match="columns names 2 columns"):
        ly.observe(log, columns=["1", "2"])


def test_whole_numbers_keep_their_digits():
    """Nanoseconds of today are 256 ns apart in float64."""
    time = 1_700_000_000_123_456_789 + 50_000 * STEPS.astype(np.int64)
    told = ly.observe({**SECONDS, "t": time}, scale={"t": 1e-9})
    assert told.document["median_period"] == pytest.approx(5e-5, rel=1e-9)


@pytest.mark.parametrize("other", [1000.0, None, "omega.3", [1, 2]])
def test_what_is_beside_a_log_is_left_out(other):
    assert numbers(ly.observe({**SECONDS, "rate": other}, columns=["t", "x", "f"])) == numbers(ly.observe(SECONDS))
