"""Calls within calls: what Python does while the lab asks it, and after the lab was interrupted."""

import os
import subprocess
import sys
import textwrap

import pytest

PRELUDE = """
import os, signal, threading, time
import lyapunov as ly
import numpy as np

SCENE = {"duration": 0.02, "servo_rate": 1000, "device": {"mass": 0.2}, "environment": {"wall": {"stiffness": 8000.0}}}
signal.signal(signal.SIGINT, signal.default_int_handler)


class Mine:
    calls = 0

    def stabilize(self, sample, effort):
        Mine.calls += 1
        asked()
        return ly.Correction(effort)
"""


def told(script, threads=1):
    """What a program prints whose lab has so many threads; it has to end by itself, and well."""
    ran = subprocess.run(
        [sys.executable, "-c", PRELUDE + textwrap.dedent(script)],
        capture_output=True,
        text=True,
        timeout=60,
        env={**os.environ, "RAYON_NUM_THREADS": str(threads)},
    )
    assert (ran.returncode, ran.stderr) == (0, "")
    return ran.stdout.split()


@pytest.mark.parametrize(
    "call",
    [
        "ly.bound(SCENE)",
        "ly.run(SCENE)",
        "ly.ensemble(SCENE, 3, progress=lambda done, total: None)",
        "ly.map(SCENE, 'environment.wall.stiffness=100..200:3', threads=2)",
        "ly.closed_loop(3, 1e-3, mass=np.ones(3), wall_stiffness=1.0)",
        "ly.Batch(ly.Stabilizer('popc', limit=1.0), 500, 1e-3).stabilize(*[np.zeros(500)] * 3)",
    ],
)
def test_a_stabilizer_may_ask_the_lab(call):
    """On the only thread that there is."""
    script = f"""
        def asked():
            if Mine.calls == 1:
                {call}
        print(ly.run(SCENE, stabilizer=Mine()).table["t"].size)
    """
    assert int(told(script)[0]) > 0


def test_what_makes_a_stabilizer_may_ask_the_lab():
    script = """
        asked = lambda: None
        bounds = []
        def make(scene):
            if not bounds:
                bounds.append(ly.bound(SCENE))
            return Mine()
        print(*ly.compare(SCENE, stabilizers="none", own={"mine": make}).table["stabilizer"])
    """
    assert told(script) == ["none", "mine"]


def test_all_threads_may_ask_the_lab_at_once():
    script = """
        both = threading.Barrier(2)
        class Nested(Mine):
            asked = False
            def stabilize(self, sample, effort):
                if not self.asked:
                    self.asked = True
                    both.wait()
                    ly.bound(SCENE)
                return ly.Correction(effort)
        threads = [threading.Thread(target=lambda: print(ly.run(SCENE, stabilizer=Nested()).verdict)) for _ in range(2)]
        for thread in threads: thread.start()
        for thread in threads: thread.join()
    """
    assert len(told(script, threads=2)) >= 2


def test_a_stabilizer_may_wait_for_a_thread_that_asks_the_lab():
    script = """
        def asked():
            if Mine.calls == 1:
                thread = threading.Thread(target=ly.bound, args=(SCENE,))
                thread.start()
                thread.join()
        print(ly.run(SCENE, stabilizer=Mine()).table["t"].size)
    """
    assert int(told(script)[0]) > 0


def test_a_small_batch_does_not_wait_for_the_pool():
    """A tick of it is no longer than it is alone, whatever another thread computes."""
    script = """
        scene = {**SCENE, "duration": 5.0}
        began, is_over = threading.Event(), threading.Event()
        def work():
            try:
                ly.ensemble(scene, 10_000_000, progress=lambda done, total: (began.set(), is_over.is_set() and 1 / 0))
            except ZeroDivisionError:
                print("over")
        thread = threading.Thread(target=work)
        thread.start()
        began.wait()
        ly.Batch(ly.Stabilizer("popc", limit=1.0), 128, 1e-3).stabilize(*[np.zeros(128)] * 3)
        print("ticked", thread.is_alive())
        is_over.set()
        thread.join()
    """
    assert told(script) == ["ticked", "True", "over"]


LONG = """
    def asked():
        time.sleep(0.002)
    scene = {**SCENE, "duration": 30.0}
    def stop(done, total):
        raise LookupError
"""

CALLS = ["ly.run(scene, stabilizer=Mine(){})", "ly.compare(scene, stabilizers='none', own={{'mine': lambda scene: Mine()}}{})"]


@pytest.mark.parametrize("call", CALLS)
@pytest.mark.parametrize("progress", [False, True])
def test_nothing_is_called_after_an_interrupt(call, progress):
    """Whether Ctrl-C or the progress ends the call."""
    script = f"""
        if not {progress}:
            threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        began = time.monotonic()
        try:
            {call.format(", progress=stop" if progress else "")}
        except (KeyboardInterrupt, LookupError):
            print(time.monotonic() - began < 2.0, Mine.calls > 0)
        calls = Mine.calls
        time.sleep(0.5)
        print(Mine.calls == calls)
    """
    assert told(textwrap.dedent(LONG) + textwrap.dedent(script)) == ["True"] * 3


@pytest.mark.parametrize("call", CALLS)
def test_a_program_ends_well_after_an_interrupt(call):
    script = f"""
        threading.Timer(0.5, lambda: os.kill(os.getpid(), signal.SIGINT)).start()
        try:
            {call.format("")}
        except KeyboardInterrupt:
            print("interrupted")
    """
    assert told(textwrap.dedent(LONG) + textwrap.dedent(script)) == ["interrupted"]
