"""Stabilizers for sampled control loops: blocks, batches and the lab.

Blocks stand in a loop of one's own: `Readings` make a `Sample` of what a device tells, a `Stabilizer` makes a `Correction`
of it. Batches do the same for arrays of loops or of recorded ticks. The lab simulates scenes: `run`, `compare`, `map`, `bound`,
`explain`, `accuracy`, `observe` and `tune` return results with the JSON of the command, tables and pictures. `lyapunov.ray`
spreads maps over machines.

Power effort · velocity > 0 flows into the environment: an effort resists the motion, `m x'' = ... - effort`. All units are SI.
"""

# First, so that an interrupt of a call never meets it half loaded.
import numpy as _numpy  # noqa: F401

from lyapunov import lab as lab
from lyapunov._lyapunov import (
    Batch,
    Correction,
    Corrections,
    InputError,
    Observer,
    Readings,
    Sample,
    Scene,
    SceneError,
    Stabilizer,
    __version__,
    closed_loop,
    damping_limit,
    replay,
    scenes,
)
from lyapunov.lab import (
    accuracy,
    bound,
    compare,
    ensemble,
    explain,
    map,
    observe,
    run,
    tune,
)
from lyapunov.results import (
    Accuracy,
    Bound,
    Comparison,
    Ensemble,
    Explanation,
    Map,
    Observation,
    Result,
    Run,
    Table,
    Tuning,
)

__all__ = [
    "Accuracy",
    "Batch",
    "Bound",
    "Comparison",
    "Correction",
    "Corrections",
    "Ensemble",
    "Explanation",
    "InputError",
    "Map",
    "Observation",
    "Observer",
    "Readings",
    "Result",
    "Run",
    "Sample",
    "Scene",
    "SceneError",
    "Stabilizer",
    "Table",
    "Tuning",
    "__version__",
    "accuracy",
    "bound",
    "closed_loop",
    "compare",
    "damping_limit",
    "ensemble",
    "explain",
    "lab",
    "map",
    "observe",
    "replay",
    "run",
    "scenes",
    "tune",
]
