"""Calls that a type checker reads: right ones, and wrong ones that it has to refuse."""

import lyapunov as ly
import numpy as np

readings = ly.Readings(1e-3, axes=3)
popc = ly.Stabilizer("popc", limit=100.0, axes=3)
correction: ly.Correction = popc.stabilize(readings.read(np.zeros(3), np.zeros(3)), np.zeros(3))
energy: float = correction.observed_energy
run: ly.Result = ly.run({"duration": 1.0})
batch: ly.Corrections = ly.Batch(popc, 8, 1e-3).stabilize(np.zeros((8, 3)), np.zeros((8, 3)), np.zeros((8, 3)))
bare: ly.Result = ly.run({"duration": 1.0}, rows=False)
log: ly.Result = ly.observe({"t": np.zeros(3), "x": np.zeros(3), "f": np.zeros(3)}, columns=["t", "x", "f"], scale=["f=-1"])
converted: ly.Sample = readings.read(np.zeros(3, dtype=np.float32), np.zeros(3, dtype=np.int64))
scalar: ly.Sample = ly.Readings(1e-3).read(np.float32(1.0), np.int64(2))
whole: ly.Sample = readings.read([0, 0, 0], (0.0, 0.0, 0.0))
other: ly.Readings = ly.Readings(np.float32(1e-3), no_faster_than=2)
kept: ly.Tuning = ly.tune({"duration": 1.0})
same: ly.Ensemble = ly.lab.ensemble({"duration": 1.0}, 3)
table: ly.Table = ly.observe({"t": np.zeros(3)}, scale={"x": 1e-3}).replay


def named(name: str) -> ly.Stabilizer:
    """A stabilizer whose name is known when the program runs; what it lacks is said then."""
    return ly.Stabilizer(name, limit=100.0)


ly.Stabilizer("popc", 100.0)  # type: ignore[call-overload]  # pyright: ignore[reportCallIssue]
ly.Stabilizer(3, limit=1.0)  # type: ignore[call-overload]  # pyright: ignore[reportCallIssue, reportArgumentType]
ly.Readings("1 ms")  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]
ly.Readings(1e-3, axes=4)  # type: ignore[arg-type]  # pyright: ignore[reportArgumentType]
