"""Maps and ensembles on a local cluster of several nodes, with workers killed and a node lost on the way."""

import os
import signal
import threading
import time

import lyapunov as ly
import pytest

ray = pytest.importorskip("ray")
cluster_utils = pytest.importorskip("ray.cluster_utils")

import lyapunov.ray  # noqa: E402

X, Y = "environment.wall.stiffness=500..9000:24", "device.mass=0.1..0.4:20"
NAMES = "none,popc,lolc"


@pytest.fixture(scope="module")
def cluster():
    made = cluster_utils.Cluster(initialize_head=True, head_node_args={"num_cpus": 1, "include_dashboard": False})
    nodes = [made.add_node(num_cpus=1) for _ in range(2)]
    ray.init(address=made.address, log_to_driver=False)
    yield made, nodes
    ray.shutdown()
    made.shutdown()


@pytest.fixture(scope="module")
def scene():
    return ly.Scene({**ly.Scene.shipped("paper-8k-popc").to_dict(), "duration": 4.0}, name="wall")


@pytest.fixture(scope="module")
def alone(scene, tmp_path_factory):
    """The map of one process, by the command."""
    folder = tmp_path_factory.mktemp("alone")
    file = folder / "wall.toml"
    file.write_text(scene.to_toml())
    words = ["map", str(file), "--x", X, "--y", Y, "--stabilizers", NAMES, "--out", str(folder / "map"), "--quiet"]
    import subprocess
    import sys

    subprocess.run([sys.executable, "-m", "lyapunov", *words], check=True)
    return (folder / "map" / "map.csv").read_bytes()


def workers():
    """The processes that compute shards."""
    found = []
    for entry in os.listdir("/proc"):
        try:
            with open(f"/proc/{entry}/cmdline", "rb") as line:
                if line.read().startswith(b"ray::_table"):
                    found.append(int(entry))
        except (OSError, ValueError):
            continue
    return found


def test_a_map_outlives_killed_workers_and_a_lost_node(cluster, scene, alone, tmp_path):
    made, nodes = cluster
    killed, over = [], threading.Event()

    def kill():
        while not over.is_set() and len(killed) < 3:
            for worker in workers()[:1]:
                try:
                    os.kill(worker, signal.SIGKILL)
                    killed.append(worker)
                except ProcessLookupError:
                    pass
            time.sleep(0.5)
        if not over.is_set():
            made.remove_node(nodes.pop(), allow_graceful=False)

    killer = threading.Thread(target=kill)
    killer.start()
    told = []
    result = ly.ray.map(
        scene, X, Y, folder=tmp_path, stabilizers=NAMES, shards=40, progress=lambda done, total: told.append((done, total))
    )
    over.set()
    killer.join()
    assert killed, "no worker was found to kill"
    assert (tmp_path / "map.csv").read_bytes() == alone
    assert told[-1] == (40, 40)
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
        ly.ray.map(scene, X, Y, folder=tmp_path, stabilizers="none,popc")
    counted = []
    ly.ray.map(scene, X, Y, folder=tmp_path, stabilizers=NAMES, progress=lambda done, total: counted.append(done))
    assert min(counted) >= len(kept)
    assert (tmp_path / "map.csv").read_bytes() == alone


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
