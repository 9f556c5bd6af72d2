"""Axes that the examples share: energies over time, and a strip of postures."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

plt.rcParams.update({"font.size": 8, "axes.spines.top": False, "axes.spines.right": False, "legend.frameon": False})

__all__ = ["energies", "paths", "plt", "strip_of_boxes"]


def energies(axes, runs, period=1e-3):
    """Energies in joules by name, over time on a logarithmic axis."""
    for name, told in runs.items():
        axes.semilogy(np.arange(len(told)) * period, np.maximum(1e3 * np.asarray(told), 1e-9), lw=0.9, label=name)
    axes.axhline(1e3 * next(iter(runs.values()))[0], color="0.6", lw=0.6, ls=":")
    axes.set(xlabel="time, s", ylabel="energy in MuJoCo, mJ")
    axes.legend()


def strip_of_boxes(figure, configurations, edges, ticks, floor):
    """Postures of a free box at some ticks, seen from a side; heights are enlarged."""
    import mujoco

    figure.suptitle("with POPC, from the side; heights enlarged 5 times", fontsize=8)
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * edges
    sides = [(a, b) for a in range(8) for b in range(a) if bin(a ^ b).count("1") == 1]
    rotation = np.zeros(9)
    for axes, tick in zip(figure.subplots(1, len(ticks)), ticks):
        pose = configurations[tick]
        mujoco.mju_quat2Mat(rotation, pose[3:])
        points = 1e3 * (corners @ rotation.reshape(3, 3).T + pose[:3])
        for a, b in sides:
            axes.plot(points[[a, b], 0], points[[a, b], 2], color="C1", lw=0.8)
        axes.axhspan(1e3 * floor - 10, 1e3 * floor, color="0.85")
        axes.set(xlim=(-75, 75), ylim=(1e3 * floor - 6, 16), title=f"{tick} ms", xticks=[], yticks=[])
        axes.spines[:].set_visible(False)


def paths(figure, runs, windows):
    """Paths of a tool by name, in metres, seen from a side during windows of ticks; the first place is on the table."""
    origin = next(iter(runs.values()))[0]
    for axes, (first, last) in zip(figure.subplots(1, len(windows), sharex=True, sharey=True), windows):
        for name, places in runs.items():
            x, _, z = 1e3 * (places[first:last] - origin).T
            axes.plot(x, z, lw=0.7, label=name)
        axes.axhspan(-2, 0, color="0.85", zorder=0)
        axes.set(xlim=(-4, 4), ylim=(-1, 5), title=f"{first} to {last} ms", xlabel="x, mm")
    figure.axes[0].set(ylabel="tool above the table, mm")
    figure.axes[0].legend(loc="upper right")
