"""The compiled part."""

import os
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, Protocol, SupportsIndex, final, overload

import numpy as np
import numpy.typing as npt
from typing_extensions import Self

_Vector = npt.NDArray[np.float64]
_Real = np.floating[Any] | np.integer[Any]
_Number = float | _Real
_Signal = _Number | npt.NDArray[_Real] | Sequence[float]
_Axes = Literal[1, 2, 3, 6, 7]

__version__: str
debug_assertions: bool
"""Whether this is a build for tests, which is slow."""

class InputError(ValueError):
    """Input that is wrong; the message names it, its value and the remedy."""

class SceneError(InputError):
    """A scene that cannot be read."""

    name: str
    message: str
    key: str | None
    value: str | None
    line: int | None
    column: int | None
    remedies: list[str]

@final
class Sample:
    """What the port's other side did since the last call. Signals: float on one axis, else arrays of shape (axes,)."""

    def __new__(
        cls,
        period: _Number,
        position: _Signal,
        velocity: _Signal,
        displacement: _Signal,
        applied: _Signal,
        *,
        axes: _Axes = 1,
    ) -> Self: ...
    @property
    def axes(self) -> _Axes: ...
    @property
    def period(self) -> float:
        """s: since the last accepted reading, or this tick's where this one was not accepted."""
    @property
    def position(self) -> Any:
        """m: float, or array of shape (axes,)."""
    @property
    def velocity(self) -> Any:
        """m/s: float, or array of shape (axes,)."""
    @property
    def displacement(self) -> Any:
        """m: float, or array of shape (axes,)."""
    @property
    def applied(self) -> Any:
        """N: float, or array of shape (axes,)."""
    @property
    def work(self) -> Any:
        """J on each axis: float, or array of shape (axes,); of several efforts the least, NaN where not accepted."""
    @property
    def accepted(self) -> bool: ...
    @property
    def jumped(self) -> bool:
        """False where a candidate or a stabilizer in Python is asked."""
    @property
    def late(self) -> bool:
        """False where a candidate or a stabilizer in Python is asked."""
    def __eq__(self, other: object, /) -> bool: ...
    def __copy__(self) -> Sample: ...
    def __deepcopy__(self, memo: object, /) -> Sample: ...

@final
class Correction:
    """What a stabilizer makes of an effort; what is left out is 0, and untold: see docs/python.md."""

    def __new__(
        cls,
        effort: _Signal,
        *,
        observed_energy: _Number = 0.0,
        alpha: _Number = 0.0,
        shortfall: _Number = 0.0,
        accepted: bool = True,
        axes: _Axes = 1,
    ) -> Self: ...
    @property
    def axes(self) -> _Axes: ...
    @property
    def effort(self) -> Any:
        """N: float, or array of shape (axes,)."""
    @property
    def observed_energy(self) -> float:
        """J."""
    @property
    def alpha(self) -> float:
        """N·s/m."""
    @property
    def shortfall(self) -> float:
        """J."""
    @property
    def accepted(self) -> bool: ...
    def __eq__(self, other: object, /) -> bool: ...
    def __copy__(self) -> Correction: ...
    def __deepcopy__(self, memo: object, /) -> Correction: ...

class _Candidate(Protocol):
    def decrease(self, sample: Sample) -> float: ...

@final
class Readings:
    """Memory of a port: readings of a device in, samples out."""

    def __new__(
        cls,
        period: _Number,
        *,
        axes: _Axes = 1,
        no_faster_than: _Number | None = None,
        cutoff: _Number | None = None,
        measured: bool = False,
        clocked: bool = False,
    ) -> Self: ...
    def read(
        self,
        position: _Signal | None,
        applied: _Signal,
        *,
        velocity: _Signal | None = None,
        now: _Number | None = None,
    ) -> Sample: ...
    def restart(self) -> None: ...
    @property
    def period(self) -> float:
        """s."""
    @property
    def axes(self) -> _Axes: ...
    def __copy__(self) -> Readings: ...
    def __deepcopy__(self, memo: object, /) -> Readings: ...

@final
class Stabilizer:
    """Stabilizer of one port, by a name of docs/family.md."""

    @overload
    def __new__(cls, name: Literal["none"], *, axes: _Axes = 1) -> Self: ...
    @overload
    def __new__(cls, name: Literal["popc"], *, limit: _Number, axes: _Axes = 1) -> Self: ...
    @overload
    def __new__(cls, name: Literal["lolc"], *, limit: _Number, damping: _Number, axes: _Axes = 1) -> Self: ...
    @overload
    def __new__(cls, name: Literal["lolc"], *, limit: _Number, candidate: _Candidate, axes: _Axes = 1) -> Self: ...
    @overload
    def __new__(cls, name: Literal["popc-bounded"], *, limit: _Number, credit: _Number, axes: _Axes = 1) -> Self: ...
    @overload
    def __new__(
        cls,
        name: Literal["popc-windowed", "popc-spread", "popc-rising"],
        *,
        limit: _Number,
        ticks: int,
        axes: _Axes = 1,
    ) -> Self: ...
    @overload
    def __new__(cls, name: Literal["popc-threshold"], *, limit: _Number, velocity: _Number, axes: _Axes = 1) -> Self: ...
    @overload
    def __new__(cls, name: Literal["popc-rate-limited"], *, limit: _Number, rate: _Number, axes: _Axes = 1) -> Self: ...
    @overload
    def __new__(cls, name: Literal["force-bound", "force-bounding"], *, damping: _Number, axes: _Axes = 1) -> Self: ...
    @overload
    def __new__(
        cls,
        name: Literal["tank"],
        *,
        start: _Number,
        floor: _Number = 0.0,
        ceiling: _Number = ...,
        power: _Number = ...,
        axes: _Axes = 1,
    ) -> Self: ...
    @overload
    def __new__(cls, name: Literal["energy-bounding"], *, c1: _Number, c2: _Number, axes: _Axes = 1) -> Self: ...
    @overload
    def __new__(cls, name: Literal["least-norm"], *, limit: _Number, decay: _Number, axes: _Axes = 1) -> Self: ...
    @overload
    def __new__(cls, name: Literal["slope-bound"], *, slope: _Number, axes: _Axes = 1) -> Self: ...
    @overload
    def __new__(cls, name: str, *, axes: _Axes = 1, **numbers: Any) -> Self:
        """One whose name a program finds out as it runs; what is missing is said then."""
    @property
    def name(self) -> str: ...
    @property
    def axes(self) -> _Axes: ...
    def stabilize(self, sample: Sample, effort: _Signal) -> Correction: ...
    def reset(self) -> None: ...
    def __copy__(self) -> Stabilizer: ...
    def __deepcopy__(self, memo: object, /) -> Stabilizer: ...

@final
class Observer:
    """Observed energy of a candidate, without a controller."""

    @overload
    def __new__(cls, *, damping: _Number | None = None, candidate: None = None) -> Self: ...
    @overload
    def __new__(cls, *, candidate: _Candidate) -> Self: ...
    def observe(self, sample: Sample) -> float:
        """The observed energy after the sample, J."""
    @property
    def observed_energy(self) -> float:
        """J."""
    def __copy__(self) -> Observer: ...
    def __deepcopy__(self, memo: object, /) -> Observer: ...

def damping_limit(mass: _Number, period: _Number, *, cap: _Number = 0.5, delay: SupportsIndex = 0) -> float:
    """The largest damping that a stabilizer may inject, N·s/m: `cap · mass / period`, less with a delay in ticks."""

@final
class Corrections:
    """Corrections of many ticks or loops."""

    @property
    def effort(self) -> _Vector:
        """N, in the shape of the effort given."""
    @property
    def observed_energy(self) -> _Vector:
        """J: (loops,), (time,) or (time, loops)."""
    @property
    def alpha(self) -> _Vector:
        """N·s/m, like observed_energy."""
    @property
    def shortfall(self) -> _Vector:
        """J, like observed_energy."""
    @property
    def accepted(self) -> npt.NDArray[np.bool_]:
        """Like observed_energy."""

@final
class Batch:
    """Loops that tick together, each with readings and a stabilizer of its own, on lanes and all cores."""

    def __new__(
        cls, stabilizer: Stabilizer, loops: SupportsIndex, period: _Number, *, no_faster_than: _Number | None = None
    ) -> Self: ...
    @property
    def loops(self) -> int: ...
    def stabilize(self, position: _Vector, applied: _Vector, effort: _Vector) -> Corrections:
        """The corrections of all loops: arrays (loops,) or (loops, axes), or with a first axis of time; m, N and N."""
    def __copy__(self) -> Batch: ...
    def __deepcopy__(self, memo: object, /) -> Batch: ...

def replay(
    readings: Readings, stabilizer: Stabilizer, position: _Vector, applied: _Vector, effort: _Vector
) -> Corrections:
    """What the blocks make of recorded ticks: arrays (time,) or (time, axes); m, N and N."""

def closed_loop(
    ticks: int,
    period: _Number,
    *,
    mass: _Number | _Vector,
    wall_stiffness: _Number | _Vector,
    damping: _Number | _Vector | None = None,
    stiffness: _Number | _Vector | None = None,
    position: _Number | _Vector | None = None,
    velocity: _Number | _Vector | None = None,
    wall_damping: _Number | _Vector | None = None,
    wall_position: _Number | _Vector | None = None,
    stabilizer: Stabilizer | None = None,
) -> dict[str, _Vector]:
    """Closed loops of a mass on a hand against a sampled wall; results of shape (loops,) by name.

    There is no delay, encoder, saturation or other effect: `ensemble` and `map` run scenes with them.
    `observed_energy`, J, is that of the wall's port before the last tick's correction, without a stabilizer too. `largest` is the
    largest |position| from half of the ticks on to the end, both counted.
    """

@final
class Scene:
    """A checked scene."""

    def __new__(cls, source: dict[str, Any] | str | os.PathLike[str], *, name: str | None = None) -> Self: ...
    @staticmethod
    def parse(text: str, *, name: str = ...) -> Scene:
        """The scene that a text in TOML tells."""
    @staticmethod
    def shipped(name: str) -> Scene:
        """One of the scenes that ship, which `lyapunov.scenes()` lists."""
    def to_toml(self) -> str: ...
    def to_dict(self) -> dict[str, Any]: ...
    @property
    def name(self) -> str: ...
    @property
    def ticks(self) -> int: ...
    @property
    def dimensions(self) -> Literal[1, 2, 3]: ...
    @property
    def mass(self) -> float: ...
    @property
    def period(self) -> float: ...
    @property
    def damping(self) -> float: ...
    @property
    def delay(self) -> int: ...
    def __eq__(self, other: object, /) -> bool: ...

@final
class Told:
    """What a study tells, in every form."""

    @property
    def json(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def figures(self) -> list[str]: ...
    @property
    def scenes(self) -> list[tuple[str, str]]: ...
    def columns(self) -> dict[str, _Column]:
        """The table: arrays of shape (rows,) of float64, int64 or bool; lists of words, or of True, False and None."""
    def further(self) -> dict[str, _Column]:
        """A second table of the same form, as that of stabilizers on a recorded log; empty where there is none."""

_Column = npt.NDArray[Any] | list[Any]
_Progress = Callable[[int, int], object] | None

def command(words: Sequence[str]) -> int: ...
def interrupt() -> None: ...
def run(scene: Scene, stabilizer: object = None, rows: bool = True, progress: _Progress = None) -> Told: ...
def compare(
    scenes: Sequence[Scene],
    stabilizers: str | None = None,
    own: Mapping[str, Callable[[Scene], Any]] | None = None,
    by: str | None = None,
    progress: _Progress = None,
) -> Told: ...
def map(
    scene: Scene,
    x: str,
    y: str | None = None,
    stabilizers: str = "none,popc,lolc",
    threads: int | None = None,
    progress: _Progress = None,
) -> Told: ...
def map_shard(scene: Scene, x: str, y: str, stabilizers: str, shard: str) -> bytes: ...

@final
class MapMerge:
    """A map that is put together from the tables of its shards, one after the other."""

    def __new__(cls, table: str | os.PathLike[str], path: str | os.PathLike[str]) -> Self: ...
    def add(self, table: str | os.PathLike[str]) -> None: ...
    def end(self) -> Told: ...

def unit_of(axis: str) -> str: ...
def label_of(column: str) -> str: ...
def scenes() -> dict[str, str]:
    """The scenes that ship, by their names for `Scene.shipped`: what each shows, and what to look at there."""
def shard_head(scene: Scene, x: str, y: str, stabilizers: str, shard: str) -> str: ...
def map_cells(scene: Scene, x: str, y: str, stabilizers: str) -> int: ...
def ensemble(
    scene: Scene,
    first: int,
    count: int,
    seed: int,
    stabilizer: str | None = None,
    phase: _Number | None = None,
    mass: _Number | None = None,
    damping: _Number | None = None,
    stiffness: _Number | None = None,
    progress: _Progress = None,
) -> Told: ...
def bound(scene: Scene) -> Told: ...
def explain(scene: Scene) -> Told: ...
def accuracy(scene: Scene, target: _Number | None = None, progress: _Progress = None) -> Told: ...
def tune(
    scene: Scene,
    stabilizers: str,
    objective: str | None = None,
    trials: int | None = None,
    runs: int | None = None,
    seed: int | None = None,
    progress: _Progress = None,
) -> Told: ...
def observe(
    log: str | os.PathLike[str] | bytes,
    columns: str | None = None,
    scale: Sequence[str] = ...,
    candidate: str = "spring",
    damping: _Number | None = None,
    surface: _Number | None = None,
    contact: _Number | None = None,
    stabilizers: str | None = None,
    scene: Scene | None = None,
    late: int = 0,
    progress: _Progress = None,
) -> Told: ...
