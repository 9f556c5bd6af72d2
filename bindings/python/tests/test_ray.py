"""Maps and ensembles on a local cluster of several nodes, with workers killed and a node lost on the way."""

import os
import pathlib
import signal
import subprocess
import sys

import lyapunov as ly
import pytest

ray = pytest.importorskip("ray")
cluster_utils = pytest.importorskip("ray.cluster_utils")

import lyapunov.ray  # noqa: E402

# Workers of Ray give way to everything else; beside other work on the machine they would hardly run.
os.environ["RAY_worker_niceness"] = "0"

X, Y = "environment.wall.stiffness=500..9000:16", "device.mass=0.1..0.4:8"
NAMES = "none,popc"


@pytest.fixture(scope="module")
def cluster():
    made = cluster_utils.Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
    nodes = [made.add_node(num_cpus=1) for _ in range(2)]
    ray.init(address=made.address, log_to_driver=False)
    yield made, nodes
    ray.shutdown()
    made.shutdown()


def wall(duration):
    return ly.Scene({**ly.Scene.shipped("paper-8k-popc").to_dict(), "duration": duration}, name="wall")


def by_the_command(scene, folder):
    """The table of the map of one process, by the command."""
    file = folder / "wall.toml"
    file.write_text(scene.to_toml())
    words = ["map", str(file), "--x", X, "--y", Y, "--stabilizers", NAMES, "--out", str(folder / "map"), "--quiet"]
    subprocess.run([sys.executable, "-m", "lyapunov", *words], check=True)
    return (folder / "map" / "map.csv").read_bytes()


@pytest.fixture(scope="module")
def scene():
    return wall(1.0)


@pytest.fixture(scope="module")
def alone(scene, tmp_path_factory):
    return by_the_command(scene, tmp_path_factory.mktemp("alone"))


def daemon(node):
    return node.all_processes["raylet"][0].process.pid


def workers(parent):
    """The processes that compute a shard now on the node whose daemon is `parent`."""
    found = []
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            words = pathlib.Path("/proc", entry, "cmdline").read_bytes()
            # The name in the second field may hold blanks; the parent is the second field after it.
            above = pathlib.Path("/proc", entry, "stat").read_text().rpartition(")")[2].split()[1]
        except OSError:
            continue
        if words.startswith(b"ray::_table") and int(above) == parent:
            found.append(int(entry))
    return found


def test_a_map_outlives_a_lost_node_and_killed_workers(cluster, tmp_path_factory, tmp_path):
    made, nodes = cluster
    # So long that a worker that is killed is begun again before the map is done.
    long = wall(20.0 if ly._lyapunov.debug_assertions else 4000.0)
    lost, killed, told = [], [], []

    def progress(done, total):
        told.append((done, total))
        if lost:
            daemons = [daemon(node) for node in (made.head_node, *nodes)]
            for worker in [it for parent in daemons for it in workers(parent)][: 2 - len(killed)]:
                os.kill(worker, signal.SIGKILL)
                killed.append(done)
            return
        for node in nodes:
            if workers(daemon(node)):
                made.remove_node(node, allow_graceful=False)
                lost.append(done)
                nodes.remove(node)
                return

    result = ly.ray.map(long, X, Y, folder=tmp_path, stabilizers=NAMES, shards=32, progress=progress)
    assert lost and lost[0] < 32, "no node that was at work on a shard was lost within the map"
    assert len(killed) == 2 and max(killed) < 32, "no workers that were at work were killed within the map"
    assert (tmp_path / "map.csv").read_bytes() == by_the_command(long, tmp_path_factory.mktemp("alone"))
    assert told[-1] == (32, 32)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["map.csv", "map.json"]
    assert (tmp_path / "map.json").read_text() == result.json


@pytest.mark.parametrize("shards", [1, 7, None])
def test_any_number_of_shards_gives_the_same_bytes(cluster, scene, alone, tmp_path, shards):
    ly.ray.map(scene, X, Y, folder=tmp_path, stabilizers=NAMES, shards=shards)
    assert (tmp_path / "map.csv").read_bytes() == alone


def test_an_interrupted_map_goes_on_from_its_shards(cluster, scene, alone, tmp_path):
    def stop(done, total):
        if done >= 4:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ly.ray.map(scene, X, Y, folder=tmp_path, stabilizers=NAMES, shards=12, progress=stop)
    kept = {path: path.stat().st_mtime_ns for path in tmp_path.glob("map-*-of-12.csv")}
    assert len(kept) >= 4
    with pytest.raises(ly.InputError, match="of another map"):
        ly.ray.map(scene, X, Y, folder=tmp_path, stabilizers="none,lolc")
    counted = []
    ly.ray.map(scene, X, Y, folder=tmp_path, stabilizers=NAMES, progress=lambda done, total: counted.append(done))
    assert min(counted) >= len(kept)
    assert (tmp_path / "map.csv").read_bytes() == alone


def test_a_table_that_was_changed_is_named_and_leaves_nothing_half_written(cluster, scene, tmp_path):
    def stop(done, total):
        if done >= 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        ly.ray.map(scene, X, Y, folder=tmp_path, stabilizers=NAMES, shards=6, progress=stop)
    table = tmp_path / "map-0-of-6.csv"
    head, comma, last = table.read_bytes().rpartition(b",")
    table.write_bytes(head + comma + b"1" + last)
    (tmp_path / "map.4242.0.begun").write_text("of a process that was killed")
    with pytest.raises(ly.InputError, match="map-0-of-6.csv") as held:
        ly.ray.map(scene, X, Y, folder=tmp_path, stabilizers=NAMES)
    # Shards only: what was begun is gone, whoever holds the error.
    assert held and {path.suffix for path in tmp_path.iterdir()} == {".csv"}
    assert not (tmp_path / "map.csv").exists()


def test_an_ensemble_is_the_one_of_one_process(cluster, scene):
    whole = ly.ensemble(scene, 50, seed=3)
    for shards in (1, 9, None):
        told = ly.ray.ensemble(scene, 50, seed=3, shards=shards)
        for name, column in whole.table.items():
            assert list(map(str, told.table[name])) == list(map(str, column))


def test_wrong_input_is_said_as_without_ray(cluster, scene, tmp_path):
    with pytest.raises(ly.InputError, match="device.mas"):
        ly.ray.map(scene, X, "device.mas=0.1..0.4:20", folder=tmp_path)
    with pytest.raises(ly.InputError, match="share below 1"):
        ly.ray.ensemble(scene, 50, mass=3.0, shards=3)
