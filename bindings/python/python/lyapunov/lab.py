"""The lab: a function for each study. Every one is a command too, and returns what that prints with `--json`."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Iterable, Mapping
from functools import wraps
from typing import TYPE_CHECKING, Any, ParamSpec, Protocol, TypeVar, Union

from lyapunov import _lyapunov, logs
from lyapunov._lyapunov import InputError, Scene
from lyapunov.logs import Log
from lyapunov.progress import shown
from lyapunov.results import (
    Accuracy,
    Bound,
    Comparison,
    Ensemble,
    Explanation,
    Map,
    Observation,
    Run,
    Tuning,
)

if TYPE_CHECKING:
    from lyapunov._lyapunov import Correction, Sample

SceneLike = Union[Scene, str, "os.PathLike[str]", Mapping[str, Any]]
"""A scene, the path of its file, or a dictionary with its keys."""

Progress = Union[bool, Callable[[int, int], object], None]
"""Whether a bar is shown, or what is called with (done, total) now and then; None: a bar in notebooks and terminals."""


_P = ParamSpec("_P")
_R = TypeVar("_R")

BY_NAME = """this study takes names of docs/family.md
  = an object, as one written in Python, runs in run(scene, stabilizer=it) and in compare(*scenes, own={"mine": lambda scene: it}), over
    as many scenes as you make; one in Rust takes part in every study: docs/own-stabilizer.md"""
"""What is said of an object where stabilizers are named."""


class StabilizerLike(Protocol):
    """A stabilizer written in Python. It is called on every tick, so it is about a hundred times slower than one in Rust."""

    def stabilize(self, sample: Sample, effort: Any) -> Correction:
        """The correction of `effort`, N, with which a controller answers `sample`.

        Reports have the share of active ticks and the energies from its `alpha`, `observed_energy` and `shortfall`. Where it changes
        efforts and `alpha` is 0 on every tick, or observed energy and shortfall are, they have None.
        """
        ...


def _scene(source: SceneLike) -> Scene:
    if isinstance(source, Scene):
        return source
    return Scene(dict(source) if isinstance(source, Mapping) else source)


def _by_name(study: Callable[_P, _R]) -> Callable[_P, _R]:
    """The study, which takes stabilizers by name alone, and says so where it is given `own`."""

    @wraps(study)
    def called(*args: _P.args, **kwargs: _P.kwargs) -> _R:
        if "own" in kwargs:
            raise TypeError(f"{study.__name__} takes no own; {BY_NAME}")
        return study(*args, **kwargs)

    return called


def _names(argument: str, given: str | Iterable[str] | None) -> str | None:
    if hasattr(given, "stabilize"):
        raise TypeError(f"{argument} is {type(given).__name__}; {BY_NAME}")
    if given is None or isinstance(given, str):
        return given
    words = _words(argument, given)
    if not words:
        raise InputError(f"{argument} is empty\n  = give one or more names, or leave it out")
    return ",".join(words)


def _name(argument: str, given: str | None) -> str | None:
    """The one name that the call's argument is."""
    if given is None or isinstance(given, str):
        return given
    remedy = BY_NAME if hasattr(given, "stabilize") else "give one name, a str"
    raise TypeError(f"{argument} is {type(given).__name__}; {remedy}")


def _words(argument: str, given: Iterable[str]) -> list[str]:
    """The words of a list that the call's argument is, which names itself where it holds something else."""
    try:
        words = list(given)
    except TypeError:
        raise TypeError(f"{argument} is {type(given).__name__}; give a str, or a list of them") from None
    for word in words:
        if hasattr(word, "stabilize"):
            raise TypeError(f"{argument} holds {type(word).__name__}; {BY_NAME}")
        if not isinstance(word, str):
            raise TypeError(f"{argument} holds {word!r}, of the type {type(word).__name__}; give a str, or a list of them")
    return words


def _scales(given: str | Iterable[str] | Mapping[str, float] | None) -> list[str]:
    if isinstance(given, Mapping):
        return [f"{name}={_factor(name, factor)!r}" for name, factor in given.items()]
    if not isinstance(given, str):
        return [] if given is None else _words("scale", given)
    return given.split(",")


def _factor(name: str, given: float) -> float:
    try:
        return float(given)
    except (TypeError, ValueError):
        raise TypeError(f"scale[{name!r}] is {given!r}; give the factor to SI, a float") from None


def run(
    scene: SceneLike,
    *,
    stabilizer: str | StabilizerLike | None = None,
    rows: bool = True,
    progress: Progress = None,
) -> Run:
    """What this loop does: a summary with its verdict, and the rows of docs/contract.md, one for each tick.

    `stabilizer` takes the place of the scene's own: a name of docs/family.md, an object with a method
    `stabilize(sample, effort)`, or a `Stabilizer`, of which a fresh copy runs. A table has at most 10,000,000 rows, of about 0.1 kB
    each; with `rows=False` there are none, and a run may be as long as it takes.
    """
    with shown(progress, "run") as bar:
        return Run(_lyapunov.run(_scene(scene), stabilizer, rows, bar))


def compare(
    *scenes: SceneLike,
    stabilizers: str | Iterable[str] | None = None,
    own: Mapping[str, Callable[[Scene], StabilizerLike]] | None = None,
    by: str | None = None,
    progress: Progress = None,
) -> Comparison:
    """Which stabilizer does best on these scenes, with the columns of docs/compare.md.

    `stabilizers` are names of docs/family.md, or "all"; `own` makes stabilizers written in Python by their names: each is called with
    the scene for each run, as in `own={"mine": lambda scene: Mine(damping_limit(scene.mass, scene.period, delay=scene.delay))}`.
    `by` sorts by a column, such as "settling_time_s". Of several scenes one that does not fit is left out with a warning.
    """
    read = [_scene(scene) for scene in scenes]
    with shown(progress, "compare") as bar:
        told = Comparison(_lyapunov.compare(read, _names("stabilizers", stabilizers), own, by, bar))
    for reason in told.left_out:
        warnings.warn(f"left out: {reason}", stacklevel=2)
    return told


@_by_name
def map(  # noqa: A001
    scene: SceneLike,
    x: str,
    y: str | None = None,
    *,
    stabilizers: str | Iterable[str] = "none,popc,lolc",
    threads: int | None = None,
    progress: Progress = None,
) -> Map:
    """Where the loop settles, swings or grows over one or two numbers of its scene.

    An axis is `"KEY=FROM..TO:N"` or `"KEY=FROM..TO:N:log"`, as in `"environment.wall.stiffness=100..50000:64"`. The table has a row for
    each cell and stabilizer, at most 10,000,000; `lyapunov.ray.map` and `lyapunov map --shard` write more into files. `threads` are at
    most 1024, one for each core by default.
    """
    with shown(progress, "map") as bar:
        names = _names("stabilizers", stabilizers) or ""
        return Map(_lyapunov.map(_scene(scene), x, y, names, threads, bar))


@_by_name
def ensemble(
    scene: SceneLike,
    members: int,
    *,
    seed: int = 1,
    stabilizer: str | None = None,
    phase: float | None = None,
    mass: float | None = None,
    damping: float | None = None,
    stiffness: float | None = None,
    progress: Progress = None,
) -> Ensemble:
    """The runs of scenes around a scene, whose numbers nobody knows exactly; a row for each member.

    `phase` moves the clock by up to so many periods of the environment, `mass`, `damping` and `stiffness` the masses, dampings and
    stiffnesses of hand, device and link by up to such a share; what is left out moves as in `tune`. A member is a function of scene,
    seed and number.
    """
    with shown(progress, "ensemble") as bar:
        told = _lyapunov.ensemble(
            _scene(scene), 0, members, seed, _name("stabilizer", stabilizer), phase, mass, damping, stiffness, bar
        )
    return Ensemble(told.columns())


def bound(scene: SceneLike) -> Bound:
    """How stiff the environment may be, by formula and exactly; the table is the spectral radius over the stiffness."""
    return Bound(_lyapunov.bound(_scene(scene)))


def explain(scene: SceneLike) -> Explanation:
    """Where the energy of the run comes from, and which changes of the scene help."""
    return Explanation(_lyapunov.explain(_scene(scene)))


def accuracy(scene: SceneLike, *, target: float | None = None, progress: Progress = None) -> Accuracy:
    """What accuracy costs in time: every integrator, step and scalar; `target`, m, asks for the fastest within it."""
    with shown(progress, "accuracy") as bar:
        return Accuracy(_lyapunov.accuracy(_scene(scene), target, bar))


@_by_name
def observe(
    log: Log,
    *,
    columns: str | Iterable[str] | None = None,
    scale: str | Iterable[str] | Mapping[str, float] | None = None,
    candidate: str = "spring",
    damping: float | None = None,
    surface: float | None = None,
    contact: float | None = None,
    stabilizers: str | Iterable[str] | None = None,
    scene: SceneLike | None = None,
    late: int = 0,
    progress: Progress = None,
) -> Observation:
    """When a recorded device generated energy, how much and in which contact.

    `log` is a file with the columns t, x and f, or those that `columns` names, "T,X,F[,V]" or a list, by label or else by number from 1;
    or a table in memory: a dictionary of columns, a DataFrame, or an array of shape (rows, 3) or (rows, 4), t, x, f[, v]. `scale` gives factors to SI by the
    letters t, x, f and v, whatever the log calls its columns: {"x": 1e-3}, "x=1e-3,f=-1" or a list. `candidate` is "spring",
    "device-damping" with `damping`, N·s/m, or "mass-spring-damper" with `surface`, m, too. `contact`, N, is the force above which there
    is contact. With `stabilizers` and the `scene` that sets their numbers, what they would have done on the recorded motion. `late` is by
    how many rows the force acts later than its own.
    """
    source, read = logs.read(log, columns if columns is None or isinstance(columns, str) else _words("columns", columns))
    with shown(progress, "observe") as bar:
        told = _lyapunov.observe(
            source,
            read,
            _scales(scale),
            candidate,
            damping,
            surface,
            contact,
            _names("stabilizers", stabilizers),
            None if scene is None else _scene(scene),
            late,
            bar,
        )
    return Observation(told)


@_by_name
def tune(
    scene: SceneLike,
    *,
    stabilizers: str | Iterable[str] = "popc,lolc",
    objective: str | None = None,
    trials: int | None = None,
    runs: int | None = None,
    seed: int | None = None,
    progress: Progress = None,
) -> Tuning:
    """The parameters of each stabilizer that are best on a scene, from as many runs for each; docs/tune.md defines the terms."""
    with shown(progress, "tune") as bar:
        names = _names("stabilizers", stabilizers) or ""
        return Tuning(_lyapunov.tune(_scene(scene), names, objective, trials, runs, seed, bar))
