"""Pictures: what is drawn is what the table says."""

import lyapunov as ly
import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
pyplot = pytest.importorskip("matplotlib.pyplot")

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
    assert sweep.plot().get_xlabel() == field.plot().get_xlabel() == key
    assert field.plot(stabilizer="popc").get_title() == "popc"
    with pytest.raises(ly.InputError, match="`tank` is not in this map\n  = the names are: none, popc"):
        field.plot(stabilizer="tank")
