"""Work that no machine holds: it is refused before it begins, with what to do instead."""

import resource
import subprocess
import sys

import lyapunov as ly
import pytest

TABLES = {
    "duration": 2.0,
    "servo_rate": 1000.0,
    "device": {"mass": 0.2, "damping": 0.1},
    "operator": {"mass": 0.1, "damping": 0.2, "stiffness": 50.0},
    "initial": {"position": -0.004},
    "environment": {"wall": {"stiffness": 8000.0}},
}


def test_a_run_of_more_rows_than_a_table_has_is_refused():
    with pytest.raises(ly.InputError) as told:
        ly.run({**TABLES, "duration": 1e5})
    assert str(told.value) == (
        "a table has at most 10000000 rows: the run has 100000001 rows, of 12 columns, 8.900 GB in all\n  = give rows=False, which leaves "
        "the rows out, or a shorter duration; `python -m lyapunov run SCENE --csv FILE` writes them into a file as it runs"
    )


def test_a_run_without_rows_tells_all_the_rest():
    whole, bare = ly.run(TABLES), ly.run(TABLES, rows=False)
    assert bare.table == {} and (bare.json, str(bare), bare.svg) == (whole.json, str(whole), whole.svg)
    with pytest.raises(ly.InputError, match="no rows to draw"):
        bare.plot()


@pytest.mark.skipif(sys.platform != "linux", reason="memory is limited as on Linux")
def test_a_table_without_memory_is_an_error_and_no_end():
    """The room of all columns is asked for before the run, and what is not there raises MemoryError."""
    script = f"""
import resource
import lyapunov as ly
scene = ly.Scene({ {**TABLES, "duration": 9e3} !r})
ly.run({TABLES!r})
held = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (held + 400_000_000,) * 2)
try:
    ly.run(scene)
except MemoryError as error:
    print(error)
"""
    told = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert told.stdout.startswith("there is no memory for the table: the run has 9000001 rows, of 12 columns, 0.801 GB in all")


def test_a_table_is_held_once():
    """As many bytes as its columns have, and not the twice of room that grows, nor a copy for Python."""
    script = f"""
import resource
import lyapunov as ly
ly.run({TABLES!r})
before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
run = ly.run({ {**TABLES, "duration": 1e3} !r})
print(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before)
"""
    told = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert int(told.stdout) < 1.2 * 89 * 1e6 / resource.getpagesize() * resource.getpagesize() / 1024


@pytest.mark.parametrize("axes", [("device.mass=0.1..1:100000", "device.damping=0.1..1:100000"), ("device.mass=0.1..1:1000000",)])
def test_a_map_of_more_rows_than_a_table_has_is_refused(axes):
    with pytest.raises(ly.InputError, match="rows that the table may have\n  = give coarser axes or fewer stabilizers") as told:
        ly.map(TABLES, *axes)
    assert ("lyapunov.ray.map(…, folder=…)" in str(told.value)) == ("--shard" in str(told.value)) == (len(axes) == 2)


def test_an_ensemble_of_more_rows_than_a_table_has_is_refused():
    with pytest.raises(ly.InputError, match="^members is 1000000000000; a table has at most 10000000 rows, one for each\n  = give fewer"):
        ly.ensemble(TABLES, 10**12)


@pytest.mark.parametrize("axes", [("device.mass=0.1..1:4",), ("device.mass=0.1..1:2", "device.damping=0.1..1:2")])
def test_threads_are_no_more_than_there_is_work_for(axes):
    with pytest.raises(ly.InputError, match="100000 are more than 1024\n  = give fewer threads"):
        ly.map(TABLES, *axes, threads=100_000)
    told = ly.map(TABLES, *axes, threads=1024, stabilizers="none")
    assert told.document.get("threads", 4) == 4


SETUP = """
import resource
import lyapunov as ly
import numpy as np
popc = ly.Stabilizer("popc", limit=1.0)
ly.Batch(popc, 1000, 1e-3).stabilize(*[np.zeros(1000)] * 3)
ly.closed_loop(1, 1e-3, mass=np.ones(1000), wall_stiffness=1.0)
wide, long = np.ones((1000, 10000)), np.ones(10**7)
batch = ly.Batch(popc, 10000, 1e-3)
held = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (held + 200_000_000,) * 2)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="memory is limited as on Linux")
@pytest.mark.parametrize(
    "call, told",
    [
        ("batch.stabilize(wide, wide, wide)", "there is no memory for the corrections of 1000 ticks of 10000 loops; give fewer"),
        ("ly.replay(ly.Readings(1e-3), popc, long, long, long)", "there is no memory for the corrections of 10000000 ticks of 1 loops"),
        ("ly.closed_loop(1, 1e-3, mass=long, wall_stiffness=1.0)", "there is no memory for the ends of 10000000 loops; give fewer"),
    ],
)
def test_arrays_without_memory_are_an_error_and_no_end(call, told):
    script = f"{SETUP}\ntry:\n    {call}\nexcept MemoryError as error:\n    print(error)\n"
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True)
    assert ran.returncode == 0 and ran.stdout.startswith(told), ran.stderr
