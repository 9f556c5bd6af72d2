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


def read(log: Log, named: str | None = None) -> str | os.PathLike[str] | bytes:
    """The path that `log` is, or the text of the table that it is, with every number in full.

    `named` are the columns that are asked for, "T,X,F[,V]" by name or number: others may hold what is no number.
    """
    if isinstance(log, (str, os.PathLike)):
        return log
    asked = None if named is None else {name.strip() for name in named.split(",")}
    columns = {
        name: _numbers(name, column, asked is None or not asked.isdisjoint((name, str(number))))
        for number, (name, column) in enumerate(_columns(log).items(), start=1)
    }
    lengths = {name: len(column) for name, column in columns.items()}
    if len(set(lengths.values())) > 1:
        told = ", ".join(f"{name} has {length}" for name, length in lengths.items())
        raise InputError(f"the columns of the log are not equally long: {told} rows\n  = give columns of one length")
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    rows.writerow(columns)
    # What is no number is left empty.
    rows.writerows(zip(*(column.tolist() for column in columns.values())))
    return text.getvalue().encode()


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


def _numbers(name: str, column: Any, is_asked_for: bool) -> np.ndarray[Any, Any]:
    try:
        return _checked(name, column)
    except InputError:
        if is_asked_for:
            raise
        return np.full(len(column), None, dtype=object)


def _checked(name: str, column: Any) -> np.ndarray[Any, Any]:
    if np.ma.isMaskedArray(column):
        raise InputError(f"the column {name} of the log is a masked array\n  = give it filled, with NaN where there is no reading")
    try:
        kind = np.asarray(column).dtype
        numbers = np.asarray(column, dtype=np.float64) if kind.kind not in KINDS else None
    except (TypeError, ValueError):
        raise InputError(f"the column {name} of the log holds what is no number\n  = leave the column out, or give numbers") from None
    if numbers is None:
        remedy = "give real numbers" if kind.kind == "c" else f'give seconds: ({name} - {name}[0]) / numpy.timedelta64(1, "s")'
        raise InputError(f"the column {name} of the log holds {KINDS[kind.kind]}, of the type {kind}\n  = {remedy}")
    if numbers.ndim != 1:
        raise InputError(f"the column {name} of the log has the shape {numbers.shape}\n  = give one of shape (rows,)")
    return numbers
