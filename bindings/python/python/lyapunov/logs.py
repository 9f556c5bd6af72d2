"""Recorded logs that are in memory, as the comma-separated values of a file."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Mapping, Sequence
from typing import Any, Union

import numpy as np

from lyapunov._lyapunov import InputError

Log = Union[str, "os.PathLike[str]", Mapping[str, Any], Any]
"""The path of a log, or a table: a dictionary of columns, a DataFrame of pandas or Polars, or an array of shape (rows, 3 or 4)."""

COLUMNS = ("t", "x", "f", "v")
"""The columns of an array: time, s, position, m, force, N, and perhaps velocity, m/s."""


KINDS = {"m": "times", "M": "times", "c": "complex numbers"}
"""What is converted to float64 and means something else then, by the kind of its dtype: times as whole numbers of their unit."""


def read(log: Log, named: str | Sequence[str] | None = None) -> tuple[str | os.PathLike[str] | bytes, str | None]:
    """The path that `log` is, or the text of the table that it is, with every number in full; and its columns that are asked for.

    `named` are those of t, x, f and perhaps v: labels of the table, or else their numbers from 1. Others may hold what is no number.
    """
    if isinstance(log, (str, os.PathLike)):
        return log, named if named is None or isinstance(named, str) else ",".join(named)
    given = _columns(log)
    asked = list(range(len(given))) if named is None else _asked(list(given), named)
    columns = {label: column for at, (label, raw) in enumerate(given.items()) if (column := _numbers(label, raw, at in asked)) is not None}
    lengths = {label: len(column) for label, column in columns.items()}
    wanted = [list(given)[at] for at in asked]
    if len({lengths[label] for label in wanted}) > 1:
        told = ", ".join(f"{label} has {lengths[label]}" for label in wanted)
        raise InputError(f"the columns of the log are not equally long: {told} rows\n  = give columns of one length")
    kept = [label for label in columns if lengths[label] == lengths[wanted[0]]]
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(_heading(label, number) for number, label in enumerate(kept, start=1))
    rows.writerows(zip(*(columns[label].tolist() for label in kept)))
    whole = named is None and not (isinstance(log, np.ndarray) and log.dtype.names is None)
    return text.getvalue().encode(), None if whole else ",".join(str(1 + kept.index(label)) for label in wanted)


def _asked(labels: list[str], named: str | Sequence[str]) -> list[int]:
    words = [word.strip() for word in (named.split(",") if isinstance(named, str) else named)]
    if len(words) not in (3, 4):
        raise InputError(f"columns names {len(words)} columns\n  = give three or four, in the order T,X,F[,V]")
    if all(word in labels for word in words):
        return [labels.index(word) for word in words]
    if all(word.isdecimal() and 1 <= int(word) <= len(labels) for word in words):
        return [int(word) - 1 for word in words]
    missing = next(word for word in words if word not in labels)
    raise InputError(f"the log has no column {missing}\n  = its columns are: {', '.join(labels)}; or give three or four of their numbers, from 1")


def _heading(label: str, number: int) -> str:
    """The label as a name in a file, which is no number there and begins no comment."""
    name = " ".join(label.lstrip("#").split())
    try:
        float(name or "0")
    except ValueError:
        return name
    return f"column {number}"


def _columns(log: Any) -> dict[str, Any]:
    if isinstance(log, Mapping):
        return {str(name): column for name, column in log.items()}
    if isinstance(log, np.ndarray) and log.dtype.names is None:
        if log.ndim != 2 or log.shape[1] not in (3, 4):
            raise InputError(f"the log is an array of shape {log.shape}\n  = give one of shape (rows, 3) or (rows, 4): t, x, f[, v]")
        return dict(zip(COLUMNS, log.T))
    names: Sequence[Any] | None = log.dtype.names if isinstance(log, np.ndarray) else getattr(log, "columns", None)
    if names is None:
        remedy = "give a path, a dictionary of columns, a DataFrame, or an array of shape (rows, 3) or (rows, 4)"
        raise InputError(f"the log is {type(log).__name__}\n  = {remedy}")
    return {str(name): log[name] for name in names}


def _numbers(name: str, column: Any, is_asked_for: bool) -> np.ndarray[Any, Any] | None:
    try:
        return _checked(name, column)
    except InputError:
        if is_asked_for:
            raise
        return None


def _checked(name: str, column: Any) -> np.ndarray[Any, Any]:
    if np.ma.isMaskedArray(column):
        raise InputError(f"the column {name} of the log is a masked array\n  = give it filled, with NaN where there is no reading")
    try:
        raw = np.asarray(column)
        kind = raw.dtype
        # Whole numbers stay what they are: nanoseconds of today are none that float64 has.
        numbers = None if kind.kind in KINDS else raw if kind.kind in "iu" else np.asarray(column, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(f"the column {name} of the log holds what is no number\n  = leave the column out, or give numbers") from None
    if numbers is None:
        remedy = "give real numbers" if kind.kind == "c" else f'give seconds: ({name} - {name}[0]) / numpy.timedelta64(1, "s")'
        raise InputError(f"the column {name} of the log holds {KINDS[kind.kind]}, of the type {kind}\n  = {remedy}")
    if numbers.ndim != 1:
        raise InputError(f"the column {name} of the log has the shape {numbers.shape}\n  = give one of shape (rows,)")
    return numbers
