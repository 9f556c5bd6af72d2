"""Pictures: what is drawn is what the table says."""

import lyapunov as ly
import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
pyplot = pytest.importorskip("matplotlib.pyplot")


@pytest.fixture(autouse=True)
def closed():
    yield
    pyplot.close("all")


SCENE = ly.Scene.shipped("paper-8k-popc")


def test_a_comparison_draws_every_column_of_numbers():
    told = ly.compare(SCENE, SCENE, stabilizers="none,popc")
    for name, column in told.table.items():
        if isinstance(column, list):
            with pytest.raises(ly.InputError, match=f"no column of numbers is called `{name}`"):
                told.plot(column=name)
            continue
        ax = told.plot(column=name)
        drawn = [bar.get_width() for bar in ax.patches]
        pyplot.close(ax.figure)
        # Rows of one name are bars of their own.
        assert len(drawn) == 4 and np.array_equal(drawn, column, equal_nan=True), name


def test_an_ensemble_draws_those_that_settle():
    told = ly.ensemble(ly.Scene.shipped("press-1khz"), 20, stabilizer="lolc")
    times, settles = (np.asarray(told.table[name]) for name in ("settling_time_s", "verdict"))
    settled = times[np.isfinite(times)]
    assert 0 < len(settled) < 20 and (np.isfinite(times) == (settles == "settles")).all()
    times, shares = told.plot().lines[0].get_data()
    assert list(times) == [0.0, *sorted(settled)] and shares[-1] == len(settled) / 20


def test_a_map_names_its_axes_and_stabilizers():
    key = "environment.wall.stiffness"
    sweep = ly.map(SCENE, f"{key}=500..9000:4", stabilizers="none,popc")
    field = ly.map(SCENE, f"{key}=500..9000:4", "device.mass=0.1..0.4:3", stabilizers="none,popc")
    assert sweep.plot().get_xlabel() == field.plot().get_xlabel() == f"{key}, N/m"
    assert field.plot().get_ylabel() == "device.mass, kg"
    assert field.plot(stabilizer="popc").get_title() == "popc"
    # Who is not drawn is named.
    assert field.plot().get_title() == "none; stabilizer= draws popc"
    with pytest.raises(ly.InputError, match="`tank` is not in this map\n  = the names are: none, popc"):
        field.plot(stabilizer="tank")


def test_a_map_draws_a_cell_of_the_same_colour_for_each_verdict():
    key, axes = "environment.wall.stiffness", ("500..9000:4:log", "0.1..0.4:3")
    told = ly.map(SCENE, f"{key}={axes[0]}", f"device.mass={axes[1]}", stabilizers="none,popc")
    ax = told.plot(stabilizer="none")
    (mesh,) = ax.collections
    verdicts = [it for it, name in zip(told.table["verdict"], told.table["stabilizer"]) if name == "none"]
    colours = [matplotlib.colors.to_hex(colour) for colour in mesh.to_rgba(mesh.get_array()).reshape(-1, 4)]
    assert colours == [ly.plots.VERDICTS[verdict] for verdict in verdicts] and len(colours) == 12
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "linear")
    # Cells meet, and each lies around its value.
    edges = np.asarray(mesh.get_coordinates())[0, :, 0]
    values = np.unique(told.table[key])
    assert (edges[:-1] < values).all() and (values < edges[1:]).all()
    assert edges[1:-1] == pytest.approx(np.sqrt(values[1:] * values[:-1]))


def test_a_sweep_draws_a_row_for_each_stabilizer():
    told = ly.map(SCENE, "device.mass=0.1..0.4:5", stabilizers="none,popc")
    assert told.plot().collections[0].get_array().shape == (2, 5)
    assert [label.get_text() for label in told.plot(stabilizer="popc").get_yticklabels()] == ["popc"]


def test_a_comparison_says_why_a_bar_is_missing():
    told = ly.compare(ly.Scene.shipped("paper-50k-none"), stabilizers="none,popc")
    ax = told.plot()
    assert [text.get_text() for text in ax.texts] == ["grows"] and ax.get_ylim() == (1.5, -0.5)
    assert ax.get_xlabel() == "settled, s"
    assert told.plot(column="peak_force_short_contact_n").get_xlabel() == "peak in contacts < 0.5 s, N"
    # Judged by speed nothing settles in a place.
    free = {**SCENE.to_dict(), "operator": {"mass": 0.1}}
    label = ly.compare(free, stabilizers="none,popc").plot().get_xlabel()
    assert label == "settled, s: no row has one, column= draws another"


def test_limits_draw_one_and_the_scene():
    ax = ly.bound(SCENE).plot()
    curve, one, own = ax.lines
    assert set(one.get_ydata()) == {1.0} and set(own.get_xdata()) == {8000.0}
    assert ax.get_xlim()[0] <= 8000.0 <= ax.get_xlim()[1] and ax.get_ylim()[0] < 1.0 < ax.get_ylim()[1]
    assert len(curve.get_xdata()) > 10


def test_a_run_draws_each_axis():
    assert len(ly.run(SCENE).plot().lines) == 1
    told = ly.run(ly.Scene.shipped("plane"))
    drawn = {line.get_label(): line.get_ydata() for line in told.plot().lines}
    assert list(drawn) == ["x", "y"] and np.array_equal(drawn["y"], 1e3 * told.table["y"])


def test_an_explanation_draws_each_stretch_apart():
    told = ly.explain(SCENE)
    ax = told.plot()
    given = sum(1 for part, it in zip(told.table["part"], told.table["given_j"]) if it != 0.0)
    assert len(ax.containers) == len(set(told.table["stretch"])) == 2
    assert sum(1 for bar in ax.patches if bar.get_width() != 0.0) == given
    # In mJ, as the text.
    assert ax.get_xlabel() == "energy given, mJ"
    assert max(abs(bar.get_width()) for bar in ax.patches) == pytest.approx(1e3 * np.abs(told.table["given_j"]).max())


def test_a_log_draws_its_contacts_over_time():
    rows = ly.run(ly.Scene.shipped("paper-50k-none")).table
    told = ly.observe({"t": rows["t"], "x": rows["x"], "f": rows["f_act"]})
    bars = told.plot().patches
    assert [bar.get_x() for bar in bars] == list(told.table["start"])
    heights = np.array([bar.get_height() for bar in bars])
    assert heights / told.table["generated"] == pytest.approx(heights[0] / told.table["generated"][0])
    ramp = np.arange(100.0)
    nothing = ly.observe({"t": 1e-3 * ramp, "x": 1e-4 * ramp, "f": 0.0 * ramp}).plot()
    assert not nothing.patches and nothing.texts


def test_tuning_draws_default_beside_tuned():
    told = ly.tune(SCENE, stabilizers="popc,lolc", trials=6, runs=2)
    costs = [entry[which]["mean_cost"] for entry in told.document["stabilizers"] for which in ("default", "tuned")]
    assert [bar.get_height() for bar in told.plot().patches] == costs


def test_accuracy_draws_decades():
    table = {
        "propagator": ["exact", "rk4", "rk4"],
        "scalar": ["f64", "f64", "f64"],
        "max_error": np.array([0.0, 1e-9, 1e-12]),
        "ns_per_simulated_second": np.array([1e4, 3e4, 1e5]),
        "pareto": np.array([True, True, False]),
    }
    ax = pyplot.figure().subplots()
    ly.plots.accuracy(ax, table)
    # An error of 0 has no place there.
    assert (ax.get_xscale(), ax.get_yscale()) == ("log", "log") and len(ax.lines) == 1
    assert list(ax.lines[0].get_ydata()) == [1e-9, 1e-12]
