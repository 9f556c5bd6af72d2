"""Common parts of the scripts: the loop of scenes/paper-8k-none.toml over 2 s with the plant's own velocity, and the
protocol of rows.

A script prints one line of JSON that lists its rows, or says why there are none:

    {"package": "scipy", "version": "1.17.1", "rows": [{"method": "...", "steps": null, "tolerance": 1e-06}]}
    {"package": "scipy", "skipped": "No module named 'scipy'"}

For each number of a row on its input it then runs that row once, and prints the nanoseconds per simulated second and the
201 positions in metres, or what went wrong:

    {"ns": 123.4, "positions": [...]}
    {"failed": "..."}
"""

import json
import sys
import time

MASS, DAMPING, STIFFNESS, START = 0.1 + 0.2, 0.2 + 0.001, 50.0, -0.004
WALL_STIFFNESS, WALL_DAMPING = 8000.0, 2.0
PERIOD, PERIODS = 0.01, 200


def rate(position, velocity, force):
    """Rates of position and velocity under the held force."""
    return velocity, (-STIFFNESS * position - DAMPING * velocity - force) / MASS


def rollout(advance):
    """Sampled loop around `advance`, which takes a state and the held force and returns the state a period later."""
    position, velocity = START, 0.0
    positions = [position]
    for _ in range(PERIODS):
        force = max(0.0, WALL_STIFFNESS * position + WALL_DAMPING * velocity) if position > 0.0 else 0.0
        position, velocity = advance(position, velocity, force)
        positions.append(position)
    return positions


def row(method, run, steps=None, tolerance=None):
    return {"method": method, "steps": steps, "tolerance": tolerance, "run": run}


def tell(**line):
    print(json.dumps(line), flush=True)


def serve(package, load):
    """Serves the rows of `package`; `load` imports it, and returns its version and its rows."""
    try:
        version, rows = load()
    except Exception as error:  # Whatever the reason, the rows of a package that does not load are SKIPPED.
        tell(package=package, skipped=str(error))
        return
    tell(package=package, version=version, rows=[{key: it[key] for key in it if key != "run"} for it in rows])
    for line in sys.stdin:
        try:
            run = rows[int(line)]["run"]
            # A row takes many slices of the scheduler; processor time leaves out the other processes in between.
            start = time.process_time_ns()
            positions = run()
            elapsed = time.process_time_ns() - start
            tell(ns=elapsed / (PERIODS * PERIOD), positions=[float(position) for position in positions])
        except Exception as error:
            tell(failed=repr(error))
