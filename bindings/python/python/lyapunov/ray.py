"""Maps and ensembles on many machines with Ray: shards of some seconds, which outlive killed workers and lost nodes.

Results are the same bytes as those of one process, whatever the number of workers: a shard is a function of its arguments, and shards
are put together in their order. Call `ray.init()` first, with the address of the cluster; by default Ray starts on this machine.
"""

from __future__ import annotations

import contextlib
import math
import os
import re
import time
from collections.abc import Callable, Iterable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lyapunov import _lyapunov
from lyapunov._lyapunov import InputError, Scene
from lyapunov.lab import Progress, SceneLike, _by_name, _name, _names, _scene
from lyapunov.progress import shown
from lyapunov.results import Ensemble, Map, _asked_for

with _asked_for():
    import ray
    from ray.exceptions import RayTaskError

if TYPE_CHECKING:
    from lyapunov.results import Column

    Moves = tuple[float | None, float | None, float | None, float | None]

SECONDS = 2.0
"""Time that a shard takes, about: what a killed worker loses, and long beside the cost of a task."""

TRIAL = 0.1
"""Time that the trial takes at least by which shards are cut, where the whole takes that long: what each shard begins with is short
beside it, and so is the time in which other cores wait for it."""

RETRIES = 100
"""Times that a shard is begun again whose worker or node was lost."""


@_by_name
def map(  # noqa: A001
    scene: SceneLike,
    x: str,
    y: str,
    *,
    folder: str | os.PathLike[str],
    stabilizers: str | Iterable[str] = "none,popc,lolc",
    shards: int | None = None,
    progress: Progress = None,
) -> Map:
    """The map of `lyapunov.map` on all workers, as map.csv and map.json in `folder`, which is made if it is not there.

    The tables of shards that are complete stay in the folder until the map is: a call with the same arguments goes on from them.
    The table of a map of more than 10,000,000 rows is in map.csv alone, and that of the result is empty.
    Only this process writes into it. A worker holds the table of its shard in memory. `shards` is their number, by default such that
    each takes some seconds.
    """
    read, names, place = _scene(scene), _names("stabilizers", stabilizers) or "", Path(folder)
    place.mkdir(parents=True, exist_ok=True)
    cells = _lyapunov.map_cells(read, x, y, names)
    _connect()
    asked = (read, x, y, names)
    count = _begun(place) or shards or _count(cells, lambda trial: _timed_shard.remote(*asked, f"0/{trial}"))
    if not 1 <= count <= cells:
        raise InputError(f"shards is {count}; it must be from 1 to the {cells} cells of the map")
    tables = [place / f"map-{index}-of-{count}.csv" if count > 1 else place / "map-0.csv" for index in range(count)]
    missing = []
    for index, table in enumerate(tables):
        if not table.exists():
            missing.append(index)
        elif not _begins(table, _lyapunov.shard_head(read, x, y, names, f"{index}/{count}")):
            raise InputError(f"{table} is of another map\n  = go on with the arguments that it was begun with, or choose another folder")
    # Only this process writes into the folder: what is begun there is of one that was killed.
    for begun in place.glob("map.*.begun"):
        begun.unlink()
    with contextlib.closing(_Whole(tables, place / "map.csv")) as whole:
        whole.grow()
        tasks = {_shard.remote(*asked, f"{index}/{count}"): index for index in missing}

        def keep(index: int, table: bytes) -> None:
            _write(tables[index], table)
            whole.grow()

        with shown(progress, "map") as bar:
            _gather(tasks, keep, bar, count)
        told = whole.end()
    _write(place / "map.json", told.json.encode())
    for table in tables:
        table.unlink()
    return Map(told)


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
    shards: int | None = None,
    progress: Progress = None,
) -> Ensemble:
    """The ensemble of `lyapunov.ensemble` on all workers."""
    read = _scene(scene)
    _connect()
    moves = (phase, mass, damping, stiffness)
    asked = (read, seed, _name("stabilizer", stabilizer), moves)
    count = shards or _count(members, lambda trial: _timed_members.remote(*asked, 0, max(1, members // trial)))
    edges = [members * index // count for index in range(count + 1)]
    pairs = list(zip(edges, edges[1:]))
    tasks = {_members.remote(*asked, first, last - first): index for index, (first, last) in enumerate(pairs)}
    parts: dict[int, dict[str, Column]] = {}
    with shown(progress, "ensemble") as bar:
        _gather(tasks, parts.__setitem__, bar, count)
    return Ensemble(_joined([parts[index] for index in range(count)]))


def _connect() -> None:
    if not ray.is_initialized():
        ray.init(include_dashboard=False, log_to_driver=False)


def _count(whole: int, timed: Callable[[int], Any]) -> int:
    """The number of shards of `whole` cells or members that take some seconds each, by a trial of a larger and larger share."""
    share = max(1, whole // 64)
    while True:
        seconds: float = ray.get(timed(share))
        if seconds >= TRIAL or share == 1:
            # As many for each core: the last ones end together.
            cores = max(1, int(_resources().get("CPU", 1)))
            return max(1, min(whole, math.ceil(share * seconds / SECONDS / cores) * cores))
        share = max(1, share // 8)


def _begun(folder: Path) -> int | None:
    """The number of shards of the unfinished map in the folder."""
    found = [re.fullmatch(r"map-\d+-of-(\d+)\.csv", path.name) for path in folder.glob("map-*-of-*.csv")]
    counts = {int(match[1]) for match in found if match}
    if len(counts) > 1:
        raise InputError(f"{folder} holds shards of maps of {sorted(counts)} shards\n  = remove those of one, or choose another folder")
    return counts.pop() if counts else None


def _begins(path: Path, head: str) -> bool:
    with path.open("rb") as file:
        return file.read(len(head.encode())) == head.encode()


def _gather(tasks: Mapping[Any, int], keep: Callable[[int, Any], object], bar: Callable[[int, int], object] | None, count: int) -> None:
    """Keeps the result of each task as it comes; cancels the others if one fails or the caller is interrupted."""
    waiting = dict(tasks)
    try:
        while waiting:
            done, _ = ray.wait(list(waiting), num_returns=1, timeout=1.0)
            for task in done:
                keep(waiting.pop(task), _got(task))
            if bar is not None:
                bar(count - len(waiting), count)
    finally:
        for task in waiting:
            ray.cancel(task, force=True)


def _got(task: Any) -> Any:
    try:
        return ray.get(task)
    except RayTaskError as error:
        # What the shard raised, as if it had been computed here.
        raise (error.cause if isinstance(error.cause, Exception) else error) from None


def _write(path: Path, text: bytes) -> None:
    """Writes the file under another name, and names it when it is complete."""
    begun = path.with_name(f"{path.name}.begun")
    with begun.open("wb") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    begun.replace(path)


class _Whole:
    """The map at `path`, which grows by each table that is there and has all before it, while others are computed."""

    def __init__(self, tables: list[Path], path: Path) -> None:
        self.tables, self.path = tables, path
        self.merge: _lyapunov.MapMerge | None = None
        self.merged = 0

    def grow(self) -> None:
        while self.merged < len(self.tables) and self.tables[self.merged].exists():
            self.merge = self.merge or _lyapunov.MapMerge(self.tables[0], self.path)
            self.merge.add(self.tables[self.merged])
            self.merged += 1

    def end(self) -> _lyapunov.Told:
        assert self.merge is not None, "every table is there"
        return self.merge.end()

    def close(self) -> None:
        # Its unfinished file goes with it, whoever holds the error that ended it.
        self.merge = None


def _joined(parts: list[dict[str, Column]]) -> dict[str, Column]:
    import numpy

    def column(name: str) -> Column:
        columns = [part[name] for part in parts]
        if isinstance(columns[0], list):
            return [word for words in columns for word in words]
        return numpy.concatenate(columns)

    return {name: column(name) for name in parts[0]}


def _table(scene: Scene, x: str, y: str, names: str, shard: str) -> bytes:
    return _lyapunov.map_shard(scene, x, y, names, shard)


def _run_members(
    scene: Scene, seed: int, stabilizer: str | None, moves: Moves, first: int, count: int
) -> dict[str, Column]:
    # A task has one core.
    os.environ.setdefault("RAYON_NUM_THREADS", "1")
    return _lyapunov.ensemble(scene, first, count, seed, stabilizer, *moves).columns()


def _timed(work: Callable[..., object]) -> Callable[..., float]:
    def timed(*asked: Any) -> float:
        began = time.monotonic()
        work(*asked)
        return time.monotonic() - began

    return timed


# It has no types.
_resources: Any = ray.cluster_resources
_shard: Any = ray.remote(num_cpus=1, max_retries=RETRIES)(_table)
_timed_shard: Any = ray.remote(num_cpus=1, max_retries=RETRIES)(_timed(_table))
_members: Any = ray.remote(num_cpus=1, max_retries=RETRIES)(_run_members)
_timed_members: Any = ray.remote(num_cpus=1, max_retries=RETRIES)(_timed(_run_members))
