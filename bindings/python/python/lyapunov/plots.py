"""Pictures of results, on axes of matplotlib."""

from __future__ import annotations

import math
from pathlib import PurePath
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import matplotlib.axes
    import numpy.typing as npt

    from lyapunov.results import Column

    Numbers = npt.NDArray[Any]

VERDICTS = {"settles": "#009e73", "swinging": "#f0c040", "grows": "#c8452a", "too short": "#c8ccd0"}
"""The colours of verdicts, the same in every picture."""

SCALARS: tuple[dict[str, Any], ...] = ({"marker": "o", "linestyle": "-"}, {"marker": "s", "linestyle": ":"})
"""The lines of the types of numbers, for each integrator in its colour."""

DEFAULT, CHOSEN, MARK = "#9aa4af", "#0072b2", "#c8452a"


def run(ax: matplotlib.axes.Axes, table: dict[str, Column]) -> None:
    """The position along each axis over time."""
    along = [name for name in ("x", "y", "z") if name in table]
    for name in along:
        ax.plot(table["t"], 1e3 * np.asarray(table[name]), label=name)
    ax.set(xlabel="time, s", ylabel="position, mm")
    if len(along) > 1:
        ax.legend()


def bars(ax: matplotlib.axes.Axes, table: dict[str, Column], column: str, label: str) -> None:
    """A column of numbers, a bar for each stabilizer on each scene; where there is none, the verdict."""
    scenes, names = table["scene"], list(table["stabilizer"])
    if len(set(scenes)) > 1:
        names = [f"{name}, {PurePath(str(scene)).name.removesuffix('.toml')}" for scene, name in zip(scenes, names)]
    numbers = np.asarray(table[column])
    ax.barh(range(len(names)), numbers, tick_label=[_short(name, 40) for name in names], color=CHOSEN)
    for place, (number, verdict) in enumerate(zip(numbers, table["verdict"])):
        if not math.isfinite(number):
            ax.annotate(str(verdict), (0, place), (4, 0), textcoords="offset points", va="center", color="#59636e")
    # A row without a bar has its place all the same.
    ax.set_ylim(len(names) - 0.5, -0.5)
    if not np.isfinite(numbers).any():
        ax.set_xlim(0, 1)
        ax.set_xticks([])
        label = f"{label}: no row has one, column= draws another"
    ax.set_xlabel(label)


def field(ax: matplotlib.axes.Axes, table: dict[str, Column], axes: list[dict[str, Any]], stabilizer: str) -> None:
    """The verdicts over two numbers under a stabilizer, a cell for each run."""
    rows = _rows(table, stabilizer)
    across, up = (np.asarray(table[axis["key"]])[rows] for axis in axes)
    x, y = np.unique(across), np.unique(up)
    cells = np.full((len(y), len(x)), -1)
    cells[np.searchsorted(y, up), np.searchsorted(x, across)] = _places(table, rows)
    _cells(ax, _edges(x, axes[0]), _edges(y, axes[1]), cells)
    for axis, (edges, scale) in zip(axes, ((x, ax.set_xscale), (y, ax.set_yscale))):
        if axis["spacing"] == "log" and len(edges) > 1:
            scale("log")
    ax.set(title=stabilizer)


def sweep(ax: matplotlib.axes.Axes, table: dict[str, Column], axis: dict[str, Any], stabilizers: list[str]) -> None:
    """The verdicts over one number, a row for each stabilizer."""
    x = np.unique(np.asarray(table["value"]))
    cells = np.full((len(stabilizers), len(x)), -1)
    for place, stabilizer in enumerate(stabilizers):
        rows = _rows(table, stabilizer)
        cells[place, np.searchsorted(x, np.asarray(table["value"])[rows])] = _places(table, rows)
    _cells(ax, _edges(x, axis), np.arange(len(stabilizers) + 1) - 0.5, cells)
    if axis["spacing"] == "log" and len(x) > 1:
        ax.set_xscale("log")
    for edge in range(1, len(stabilizers)):
        ax.axhline(edge - 0.5, color="white", linewidth=3)
    ax.set_yticks(range(len(stabilizers)), stabilizers)
    ax.set_ylim(len(stabilizers) - 0.5, -0.5)


def radius(ax: matplotlib.axes.Axes, table: dict[str, Column], limits: dict[str, Any]) -> None:
    """The spectral radius over the stiffness, with what it may be, and the scene's own stiffness."""
    stiffness, numbers = (np.asarray(table[name]) for name in ("stiffness_n_per_m", "spectral_radius"))
    ax.plot(stiffness, numbers, color=CHOSEN)
    ax.axhline(1.0, color="black", linewidth=0.8, linestyle="--", label="1: beyond it grows")
    if limits["stiffness"] is not None:
        ax.axvline(limits["stiffness"], color=MARK, linewidth=1.2, label=f"the scene, {limits['stiffness']:g} N/m")
    # What grows does so however much: a larger radius, and a stiffness that has one, is left out.
    high, low = min(float(numbers.max()), 2.0), float(numbers.min())
    last = max(float(stiffness[numbers <= high].max(initial=stiffness[0])), 1.15 * (limits["stiffness"] or 0.0))
    room = 0.08 * max(high - low, 0.02)
    ax.set(xlabel="stiffness, N/m", ylabel="spectral radius", ylim=(low - room, max(high, 1.0) + room))
    ax.set_xlim(stiffness[0] - 0.02 * last, min(last, float(stiffness[-1])))
    ax.legend()


def energies(ax: matplotlib.axes.Axes, table: dict[str, Column]) -> None:
    """The energy that each part gave, a colour for each stretch of the run."""
    parts, stretches = (list(dict.fromkeys(table[name])) for name in ("part", "stretch"))
    given = np.asarray(table["given_j"])
    # Most scenes have few of the parts.
    parts = [part for part in parts if any(it for name, it in zip(table["part"], given) if name == part)]
    height = 0.8 / max(1, len(stretches))
    for place, stretch in enumerate(stretches):
        rows = [row for row, it in enumerate(table["stretch"]) if it == stretch and table["part"][row] in parts]
        at = [parts.index(table["part"][row]) + height * (place - (len(stretches) - 1) / 2) for row in rows]
        ax.barh(at, 1e3 * given[rows], height, label=stretch)
    ax.set_yticks(range(len(parts)), [str(part) for part in parts])
    ax.set_ylim(len(parts) - 0.5, -0.5)
    ax.axvline(0.0, color="black", linewidth=0.8)
    # One unit in picture and text: both are read side by side.
    ax.set_xlabel("energy given, mJ")
    if len(stretches) > 1:
        ax.legend()


def accuracy(ax: matplotlib.axes.Axes, table: dict[str, Column]) -> None:
    """The largest error over the time that a simulated second takes, for each integrator and scalar."""
    time, error = (np.asarray(table[name]) for name in ("ns_per_simulated_second", "max_error"))
    kinds = list(zip(table["propagator"], table["scalar"]))
    propagators, scalars = (list(dict.fromkeys(table[name])) for name in ("propagator", "scalar"))
    for kind in dict.fromkeys(kinds):
        style = {"color": f"C{propagators.index(kind[0])}", **SCALARS[scalars.index(kind[1]) % len(SCALARS)]}
        rows = [row for row, it in enumerate(kinds) if it == kind and error[row] > 0.0]
        rows.sort(key=lambda row: float(time[row]))
        if rows:
            label = " ".join(str(it) for it in kind)
            ax.plot(1e-3 * time[rows], error[rows], markersize=4, linewidth=1, label=label, **style)
    front = np.asarray(table["pareto"], dtype=bool) & (error > 0.0)
    label = "none as fast and as accurate"
    ax.scatter(1e-3 * time[front], error[front], s=70, facecolors="none", edgecolors="black", label=label, zorder=3)
    ax.set(xscale="log", yscale="log", xlabel="time of a simulated second, µs", ylabel="largest error, m")
    ax.legend(fontsize="small", loc="center left", bbox_to_anchor=(1.0, 0.5))


def contacts(ax: matplotlib.axes.Axes, table: dict[str, Column]) -> None:
    """The energy that each contact generated, over the time that it took."""
    start, end, generated = (np.asarray(table[name]) for name in ("start", "end", "generated"))
    ax.set(xlabel="time, s", ylabel="energy generated by a contact, J")
    if len(start) == 0:
        ax.annotate("no contact generated energy", (0.5, 0.5), xycoords="axes fraction", ha="center", color="#59636e")
        return
    factor, unit = _prefix(generated)
    # What is too short to be seen is drawn as wide as can be seen.
    least = 0.004 * float(end.max() - start.min())
    ax.bar(start, factor * generated, np.maximum(end - start, least), align="edge", color=MARK)
    ax.axhline(0.0, color="black", linewidth=0.8)
    ax.set_ylabel(f"energy generated by a contact, {unit}J")


def costs(ax: matplotlib.axes.Axes, document: dict[str, Any]) -> None:
    """The mean cost of each stabilizer as the scene sets it and tuned, with the interval of the change."""
    entries = document["stabilizers"]
    for place, entry in enumerate(entries):
        for shift, which, colour in ((-0.2, "default", DEFAULT), (0.2, "tuned", CHOSEN)):
            cost = entry[which]["mean_cost"]
            label = which if place == 0 else None
            ax.bar(place + shift, math.nan if cost is None else cost, 0.36, color=colour, label=label)
            if cost is None:
                ax.annotate("grows", (place + shift, 0), (0, 4), textcoords="offset points", ha="center", color="#59636e")
        tuned, change = entry["tuned"]["mean_cost"], entry["change"]
        if tuned is not None and change is not None:
            label = "95 % interval of the change" if place == 0 else None
            ax.errorbar(place + 0.2, tuned, change[1], color="black", capsize=4, linestyle="none", label=label)
    ax.set_xticks(range(len(entries)), [entry["stabilizer"] for entry in entries])
    # Room for the legend.
    ax.set(xlim=(-0.6, len(entries) - 0.4), ylim=(0, 1.3 * ax.get_ylim()[1]), ylabel=f"mean cost, objective {document['objective']}")
    ax.legend()


def _rows(table: dict[str, Column], stabilizer: str) -> list[int]:
    return [row for row, name in enumerate(table["stabilizer"]) if name == stabilizer]


def _places(table: dict[str, Column], rows: list[int]) -> list[int]:
    known = list(VERDICTS)
    return [known.index(str(table["verdict"][row])) for row in rows]


def _cells(ax: matplotlib.axes.Axes, x: Numbers, y: Numbers, cells: Numbers) -> None:
    from matplotlib.colors import BoundaryNorm, ListedColormap
    from matplotlib.patches import Patch

    colours = ListedColormap(list(VERDICTS.values()))
    norm = BoundaryNorm(np.arange(len(VERDICTS) + 1) - 0.5, len(VERDICTS))
    ax.pcolormesh(x, y, np.ma.masked_less(cells, 0), cmap=colours, norm=norm, rasterized=True)
    seen = [(verdict, colour) for place, (verdict, colour) in enumerate(VERDICTS.items()) if (cells == place).any()]
    handles = [Patch(color=colour, label=verdict) for verdict, colour in seen]
    ax.legend(handles=handles, loc="lower center", bbox_to_anchor=(0.5, 1.06), ncols=len(handles), frameon=False)


def _edges(values: Numbers, axis: dict[str, Any]) -> Numbers:
    """The edges of cells that lie around these values, as far from them as from their neighbours."""
    if len(values) == 1:
        half = 0.5 * abs(float(values[0])) or 0.5
        return np.array([values[0] - half, values[0] + half])
    is_log = axis["spacing"] == "log"
    places = np.log(values) if is_log else values
    inner = 0.5 * (places[1:] + places[:-1])
    edges = np.concatenate([[2 * places[0] - inner[0]], inner, [2 * places[-1] - inner[-1]]])
    return np.exp(edges) if is_log else edges


def _prefix(numbers: Numbers) -> tuple[float, str]:
    """The factor and the prefix of a unit in which the largest of these numbers is easily read."""
    largest = float(np.nanmax(np.abs(numbers), initial=0.0))
    for factor, prefix in ((1.0, ""), (1e3, "m"), (1e6, "µ")):
        if largest * factor >= 1.0:
            return factor, prefix
    return (1.0, "") if largest == 0.0 else (1e9, "n")


def _short(name: str, room: int) -> str:
    return name if len(name) <= room else f"{name[: room - 1]}…"
