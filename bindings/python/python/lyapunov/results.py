"""Results of the lab: the JSON of the command, its words, its table in the usual forms, and pictures."""

from __future__ import annotations

import html
import json
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from typing import TYPE_CHECKING, Any, Union

from lyapunov._lyapunov import InputError, Scene

if TYPE_CHECKING:
    import matplotlib.axes
    import numpy as np
    import numpy.typing as npt
    import pandas
    import polars
    import pyarrow

    from lyapunov._lyapunov import Told

    Column = Union[npt.NDArray[np.float64], list[str]]

ROWS_SHOWN = 12
"""Rows of a table that a notebook shows."""


class Table:
    """A table in the usual forms."""

    def __init__(self, table: dict[str, Column]) -> None:
        self.table = table
        """The table by columns: numbers as float64 arrays of shape (rows,) with NaN where there is none, words as lists."""

    def to_pandas(self) -> pandas.DataFrame:
        """The table as a DataFrame of pandas."""
        with _asked_for():
            import pandas

        return pandas.DataFrame(self.table)

    def to_polars(self) -> polars.DataFrame:
        """The table as a DataFrame of Polars."""
        with _asked_for():
            import polars

        return polars.DataFrame(self.table)

    def to_arrow(self) -> pyarrow.Table:
        """The table as one of Arrow."""
        with _asked_for():
            import pyarrow

        return pyarrow.table(self.table)

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
        ax = _axes(ax)
        names = [name for name, column in self.table.items() if not isinstance(column, list)]
        if len(names) > 1:
            for name in names[1:]:
                ax.plot(self.table[names[0]], self.table[name], label=name)
            ax.set_xlabel(names[0])
            ax.legend()
        return ax

    def __str__(self) -> str:
        return self._told.text

    def __repr__(self) -> str:
        return f"<{type(self).__name__}: {', '.join(self.table)}>"

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


def _cell(value: Any) -> str:
    if isinstance(value, str):
        return f"<td>{html.escape(value)}</td>"
    return f"<td>{'-' if value != value else format(value, '.6g')}</td>"


def _axes(ax: matplotlib.axes.Axes | None) -> matplotlib.axes.Axes:
    if ax is not None:
        return ax
    with _asked_for():
        import matplotlib.pyplot

    return matplotlib.pyplot.figure(layout="constrained").subplots()


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
        """Draws the position over time, mm over s."""
        ax = _axes(ax)
        ax.plot(self.table["t"], 1e3 * self.table["x"])  # type: ignore[operator]
        ax.set(xlabel="time, s", ylabel="position, mm")
        return ax


class Comparison(Result):
    """Stabilizers on scenes. The table has a row for each stabilizer on each scene, with the columns of docs/compare.md."""

    def plot(self, ax: matplotlib.axes.Axes | None = None, *, column: str = "settling_time_s") -> matplotlib.axes.Axes:
        """Draws a column of numbers as bars, one for each stabilizer on each scene."""
        of_numbers = [name for name, it in self.table.items() if not isinstance(it, list)]
        if column not in of_numbers:
            raise InputError(f"no column of numbers is called `{column}`\n  = they are: {', '.join(of_numbers)}")
        ax = _axes(ax)
        scenes, names = self.table["scene"], self.table["stabilizer"]
        if len(set(scenes)) > 1:
            names = [f"{scene}: {name}" for scene, name in zip(scenes, names)]
        ax.barh(range(len(names)), self.table[column], tick_label=list(names))
        ax.invert_yaxis()
        ax.set_xlabel(column)
        return ax


class Map(Result):
    """A map or a sweep. The table has a row for each cell and stabilizer."""

    def plot(self, ax: matplotlib.axes.Axes | None = None, *, stabilizer: str | None = None) -> matplotlib.axes.Axes:
        """Draws the verdicts under a stabilizer, the first by default: over two numbers as a field, over one as points."""
        names = self.table["stabilizer"]
        stabilizer = names[0] if stabilizer is None else stabilizer
        if stabilizer not in names:
            raise InputError(f"`{stabilizer}` is not in this map\n  = the names are: {', '.join(dict.fromkeys(names))}")
        ax = _axes(ax)
        chosen = [at for at, name in enumerate(names) if name == stabilizer]
        verdicts = [self.table["verdict"][at] for at in chosen]
        keys = list(self.table)[: list(self.table).index("stabilizer")]
        x, y = keys[0], keys[1] if len(keys) > 1 else None
        for verdict in dict.fromkeys(verdicts):
            at = [one for one, it in zip(chosen, verdicts) if it == verdict]
            across = self.table[x][at]  # type: ignore[call-overload]
            up = [verdict] * len(at) if y is None else self.table[y][at]  # type: ignore[call-overload]
            ax.scatter(across, up, marker="s", s=9, label=verdict)
        # The table of a sweep calls what it sweeps `value`.
        ax.set(xlabel=self.document["x"]["key"], ylabel="verdict" if y is None else y, title=stabilizer)
        ax.legend()
        return ax


class Bound(Result):
    """Limits of the stiffness. The table is the spectral radius over the stiffness."""


class Explanation(Result):
    """An explanation. The table has the energies by cause."""

    @property
    def verdict(self) -> str:
        """The verdict on the run."""
        return str(self.document["verdict"])

    def plot(self, ax: matplotlib.axes.Axes | None = None) -> matplotlib.axes.Axes:
        """Draws the energies by cause as bars."""
        ax = _axes(ax)
        words = next(column for column in reversed(self.table.values()) if isinstance(column, list))
        name, numbers = next((name, it) for name, it in reversed(self.table.items()) if not isinstance(it, list))
        ax.barh(range(len(words)), numbers, tick_label=words)
        ax.invert_yaxis()
        ax.set_xlabel(name)
        return ax


class Accuracy(Result):
    """Accuracy against time. The table has a row for each integrator, step and scalar."""


class Observation(Result):
    """An observed log. The table has a row for each contact."""


class Tuning(Result):
    """Tuned stabilizers. The table has a row for each setting."""

    @property
    def scenes(self) -> dict[str, Scene]:
        """The scene with each stabilizer, tuned, ready to run."""
        return {name: Scene.parse(text, name=name) for name, text in self._told.scenes}


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
