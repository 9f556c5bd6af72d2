"""What Ray adds to a map on one machine, beside `lyapunov map --threads`: wall time, and processor time, which other work does not change.

    python bindings/python/bench/overhead.py [rounds [cells [scene]]]        # needs ray

Both make the same map on all cores, in turns, `cells` along each axis; told are medians over the rounds and of the ratios of a round. Ray has
started before, and both tables have the same bytes. What Ray adds is mostly per cell, so it counts most where a cell is soon computed, as in
the plain wall that is the scene by default.
"""

import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile
import time

import lyapunov as ly

# Workers of Ray give way to everything else; beside other work on the machine they would hardly run.
os.environ["RAY_worker_niceness"] = "0"

import lyapunov.ray  # noqa: E402
import ray  # noqa: E402

NAMES = "none,popc,lolc"
CORES = len(os.sched_getaffinity(0))


def descendants_seconds():
    """Processor time of all processes below this one, and of those that they have waited for, s."""
    fields = {}
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            told = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue  # It has ended.
        fields[int(stat.parent.name)] = (int(told[1]), sum(map(int, told[11:15])))
    below, found = {os.getpid()}, True
    while found:
        found = {pid for pid, (parent, _) in fields.items() if parent in below} - below
        below |= found
    return sum(fields[pid][1] for pid in below - {os.getpid()}) / os.sysconf("SC_CLK_TCK")


def by_the_command(file, x, y, folder):
    words = ["map", str(file), "--x", x, "--y", y, "--stabilizers", NAMES, "--threads", str(CORES), "--out", str(folder), "--quiet"]
    before, began = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
    subprocess.run([sys.executable, "-m", "lyapunov", *words], check=True, stdout=subprocess.DEVNULL)
    wall, after = time.perf_counter() - began, resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def by_ray(file, x, y, folder):
    before, own, began = descendants_seconds(), time.process_time(), time.perf_counter()
    lyapunov.ray.map(file, x, y, folder=folder, stabilizers=NAMES, progress=False)
    wall = time.perf_counter() - began
    return wall, descendants_seconds() - before + time.process_time() - own


def main():
    rounds, cells, scene = sys.argv[1:] + ["3", "2048", "paper-8k-popc"][len(sys.argv) - 1 :]
    rounds, cells = int(rounds), int(cells)
    x, y = f"environment.wall.stiffness=500..50000:{cells}", f"device.mass=0.1..1:{cells}"
    ray.init(num_cpus=CORES, include_dashboard=False, log_to_driver=False)
    times = {"--threads": [], "Ray": []}
    with tempfile.TemporaryDirectory() as place:
        file = pathlib.Path(place) / "scene.toml"
        file.write_text(ly.Scene.shipped(scene).to_toml())
        for at in range(rounds):
            folders = [pathlib.Path(place) / f"{name}-{at}" for name in ("threads", "ray")]
            times["--threads"].append(by_the_command(file, x, y, folders[0]))
            times["Ray"].append(by_ray(file, x, y, folders[1]))
            one, other = ((folder / "map.csv").read_bytes() for folder in folders)
            assert one == other, "the tables differ"
    for name, told in times.items():
        wall, processor = (statistics.median(column) for column in zip(*told))
        print(f"{name:10} {wall:7.1f} s, processor {processor:7.1f} s")
    pairs = list(zip(times["--threads"], times["Ray"]))
    for at, what in enumerate(["wall", "processor"]):
        print(f"Ray adds {100 * (statistics.median(ours[at] / theirs[at] for theirs, ours in pairs) - 1):.1f} % of {what} time")


if __name__ == "__main__":
    main()
