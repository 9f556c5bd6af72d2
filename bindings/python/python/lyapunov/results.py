"""Results of the lab: the JSON of the command, its words, its table in the usual forms, and pictures."""

from __future__ import annotations

import html
import json
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from lyapunov import _lyapunov, plots
from lyapunov._lyapunov import InputError, Scene

if TYPE_CHECKING:
    import matplotlib.axes
    import numpy.typing as npt
    import pandas
    import polars
    import pyarrow

    from lyapunov._lyapunov import Told

    Column = Union[npt.NDArray[Any], list[Any]]

ROWS_SHOWN = 12
"""Rows of a table that a notebook shows."""


class Table:
    """A table in the usual forms."""

    def __init__(self, table: dict[str, Column]) -> None:
        self.table = table
        """The table by columns: numbers as float64 arrays of shape (rows,) with NaN where there is none, counts as int64 arrays, truths
        as bool arrays, words as lists, and truths that may be unknown as lists of True, False and None."""

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a DataFrame of pandas."""
        with _asked_for():
            import pandas

        # A truth that is not known is one of pandas' own.
        known = {name: pandas.array(it, dtype="boolean") if _may_be_unknown(it) else it for name, it in self.table.items()}
        return pandas.DataFrame(known)

    def to_polars(self) -> polars.DataFrame:
        """The table as a DataFrame of Polars."""
        with _asked_for():
            import polars

        of = {name: polars.Boolean for name, it in self.table.items() if _may_be_unknown(it)}
        # What is not there is null there, which means and comparisons leave out; NaN they take for a number.
        return polars.DataFrame(self.table, schema_overrides=of).fill_nan(None)

    def to_arrow(self) -> pyarrow.Table:
        """The table as one of Arrow."""
        with _asked_for():
            import pyarrow

        def column(it: Column) -> pyarrow.Array[Any]:
            # NaN is null there too.
            return pyarrow.array(it, pyarrow.bool_()) if _may_be_unknown(it) else pyarrow.array(it, from_pandas=True)

        return pyarrow.table({name: column(it) for name, it in self.table.items()})

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {', '.join(self.table)}>"

    def _repr_html_(self) -> str:
        return self._rows_in_html() or f"<pre>{html.escape(repr(self))}</pre>"

    def _rows_in_html(self) -> str:
        columns = list(self.table.items())
        rows = len(columns[0][1]) if columns else 0
        if rows == 0:
            return ""
        head = "".join(f"<th>{html.escape(name)}</th>" for name, _ in columns)
        shown = range(min(rows, ROWS_SHOWN))
        body = "".join(f"<tr>{''.join(_cell(column[row]) for _, column in columns)}</tr>" for row in shown)
        more = f"<p>{rows - ROWS_SHOWN} more rows</p>" if rows > ROWS_SHOWN else ""
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table>{more}"


class Result(Table):
    """What a study tells."""

    def __init__(self, told: Told) -> None:
        super().__init__(told.columns())
        self._told = told

    @property
    def json(self) -> str:
        """What the command prints with `--json`, byte for byte but for measured times."""
        return self._told.json

    @cached_property
    def document(self) -> dict[str, Any]:
        """The JSON, read."""
        read: dict[str, Any] = json.loads(self.json)
        return read

    @property
    def svg(self) -> list[str]:
        """The figures that the command draws with `--out`."""
        return self._told.figures

    def plot(self, ax: matplotlib.axes.Axes | None = None) -> matplotlib.axes.Axes:
        """Draws the result on axes of matplotlib, new ones by default."""
        raise NotImplementedError

    def __str__(self) -> str:
        return self._told.text

    def _repr_html_(self) -> str:
        first = self.svg[0] if self.svg else ""
        return f"<pre>{html.escape(str(self))}</pre>{first}{self._rows_in_html()}"


@contextmanager
def _asked_for() -> Iterator[None]:
    """Says of a package that is not there how it is installed."""
    try:
        yield
    except ModuleNotFoundError as missing:
        remedy = f"{missing}; install it with `pip install {missing.name}`"
        raise ModuleNotFoundError(remedy, name=missing.name) from None


def _may_be_unknown(column: Column) -> bool:
    """Whether a column holds truths of which some may be unknown."""
    return isinstance(column, list) and len(column) > 0 and not any(isinstance(it, str) for it in column)


def _cell(value: Any) -> str:
    if isinstance(value, str):
        return f"<td>{html.escape(value)}</td>"
    if value is None or isinstance(value, (bool, int, np.bool_, np.integer)):
        return f"<td>{'-' if value is None else value}</td>"
    return f"<td>{'-' if value != value else format(value, '.6g')}</td>"


def _axes(ax: matplotlib.axes.Axes | None, rows: int = 0) -> matplotlib.axes.Axes:
    """The axes, or new ones, high enough for so many rows."""
    if ax is not None:
        return ax
    with _asked_for():
        import matplotlib.pyplot

    size = (6.4, max(4.8, 1.2 + 0.28 * rows))
    return matplotlib.pyplot.figure(figsize=size, layout="constrained").subplots()


class Run(Result):
    """One run. The table has a row for each tick, with the columns of docs/contract.md."""

    @property
    def verdict(self) -> str:
        """"settles", "swinging", "grows" or "too short", as docs/verdicts.md defines them."""
        return str(self.document["verdict"])

    @property
    def settling_time(self) -> float | None:
        """Time after which the motion stays in its band, s; None if it does not."""
        told: float | None = self.document["settling_time_s"]
        return told

    def plot(self, ax: matplotlib.axes.Axes | None = None) -> matplotlib.axes.Axes:
        """Draws the position along each axis over time, mm over s."""
        if not self.table:
            raise InputError("this run has no rows to draw\n  = run it without rows=False; the figures in `svg` are there all the same")
        ax = _axes(ax)
        plots.run(ax, self.table)
        return ax


class Comparison(Result):
    """Stabilizers on scenes. The table has a row for each stabilizer on each scene, with the columns of docs/compare.md."""

    @property
    def left_out(self) -> list[str]:
        """Why scenes were left out, a reason for each."""
        return list(self.document.get("left_out", []))

    def plot(self, ax: matplotlib.axes.Axes | None = None, *, column: str = "settling_time_s") -> matplotlib.axes.Axes:
        """Draws a column of numbers as bars, one for each stabilizer on each scene."""
        of_numbers = [name for name, it in self.table.items() if not isinstance(it, list)]
        if column not in of_numbers:
            raise InputError(f"no column of numbers is called `{column}`\n  = they are: {', '.join(of_numbers)}")
        ax = _axes(ax, len(self.table[column]))
        plots.bars(ax, self.table, column, _lyapunov.label_of(column))
        return ax


class Map(Result):
    """A map or a sweep. The table has a row for each cell and stabilizer."""

    def plot(self, ax: matplotlib.axes.Axes | None = None, *, stabilizer: str | None = None) -> matplotlib.axes.Axes:
        """Draws the verdicts: over two numbers a field under one stabilizer, over one a row for each.

        A field is of the first stabilizer by default, and names the others.
        """
        if not self.table:
            raise InputError("this map has more rows than its table may have\n  = draw from map.csv; the figures in `svg` are there all the same")
        known = list(dict.fromkeys(str(name) for name in self.table["stabilizer"]))
        if stabilizer is not None and stabilizer not in known:
            raise InputError(f"`{stabilizer}` is not in this map\n  = the names are: {', '.join(known)}")
        ax = _axes(ax)
        x, y = self.document["x"], self.document.get("y")
        if y is None:
            plots.sweep(ax, self.table, x, known if stabilizer is None else [stabilizer])
        else:
            plots.field(ax, self.table, [x, y], known[0] if stabilizer is None else stabilizer)
            ax.set_ylabel(_label(y))
            if stabilizer is None and len(known) > 1:
                ax.set_title(f"{known[0]}; stabilizer= draws {', '.join(known[1:])}")
        ax.set_xlabel(_label(x))
        return ax


def _label(axis: dict[str, Any]) -> str:
    unit = _lyapunov.unit_of(f"{axis['key']}={axis['from']!r}..{axis['to']!r}:{axis['count']}")
    return f"{axis['key']}, {unit}" if unit else str(axis["key"])


class Bound(Result):
    """Limits of the stiffness. The table is the spectral radius over the stiffness."""

    def plot(self, ax: matplotlib.axes.Axes | None = None) -> matplotlib.axes.Axes:
        """Draws the spectral radius over the stiffness, with the line at 1 and the scene's stiffness."""
        if not self.table:
            raise InputError("these limits have no curve to draw\n  = print them: they say why")
        ax = _axes(ax)
        plots.radius(ax, self.table, self.document)
        return ax


class Explanation(Result):
    """An explanation. The table has the energies by cause."""

    @property
    def verdict(self) -> str:
        """The verdict on the run."""
        return str(self.document["verdict"])

    def plot(self, ax: matplotlib.axes.Axes | None = None) -> matplotlib.axes.Axes:
        """Draws the energies by cause as bars, a colour for each stretch of the run."""
        ax = _axes(ax)
        plots.energies(ax, self.table)
        return ax


class Accuracy(Result):
    """Accuracy against time. The table has a row for each integrator, step and scalar."""

    def plot(self, ax: matplotlib.axes.Axes | None = None) -> matplotlib.axes.Axes:
        """Draws the largest error over the time of a simulated second, both by decades; an error of 0 has no place there."""
        ax = _axes(ax)
        plots.accuracy(ax, self.table)
        return ax


class Observation(Result):
    """An observed log. The table has a row for each contact, the worst first."""

    @property
    def replay(self) -> Table:
        """What stabilizers would have done, a row for each, in SI units; empty where nobody was asked."""
        return Table(self._told.further())

    def plot(self, ax: matplotlib.axes.Axes | None = None) -> matplotlib.axes.Axes:
        """Draws the energy that each contact of the table generated over time, J over s."""
        ax = _axes(ax)
        plots.contacts(ax, self.table)
        return ax


class Tuning(Result):
    """Tuned stabilizers. The table has a row for each setting."""

    @property
    def scenes(self) -> dict[str, Scene]:
        """The scene with each stabilizer, tuned, ready to run."""
        return {name: Scene.parse(text, name=name) for name, text in self._told.scenes}

    def plot(self, ax: matplotlib.axes.Axes | None = None) -> matplotlib.axes.Axes:
        """Draws the mean cost of each stabilizer as the scene sets it and tuned, on runs that tuning never saw."""
        ax = _axes(ax)
        plots.costs(ax, self.document)
        return ax


class Ensemble(Table):
    """Runs of scenes around a scene. The table has a row for each member: verdict, settling time, peaks and energies."""

    @property
    def verdicts(self) -> dict[str, int]:
        """The number of members with each verdict."""
        words = list(self.table["verdict"])
        return {str(word): words.count(word) for word in dict.fromkeys(words)}

    def __str__(self) -> str:
        return ", ".join(f"{count} {verdict}" for verdict, count in self.verdicts.items())

    def __repr__(self) -> str:
        return f"<Ensemble: {self}>"

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(str(self))}</pre>{self._rows_in_html()}"

    def plot(self, ax: matplotlib.axes.Axes | None = None) -> matplotlib.axes.Axes:
        """Draws the share of members that have settled over time, s."""
        ax = _axes(ax)
        verdicts = self.table["verdict"]
        # One that swings or grows may be within its band at the end all the same.
        times = sorted(time for time, verdict in zip(self.table["settling_time_s"], verdicts) if verdict == "settles")
        shares = [count / len(verdicts) for count in range(len(times) + 1)]
        ax.step([0.0, *times], shares, where="post")
        ax.set(xlabel="time, s", ylabel="share that has settled", ylim=(0, 1))
        return ax
