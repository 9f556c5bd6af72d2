"""Threads, and memory over many calls."""

import gc
import threading
import time

import lyapunov as ly
import numpy as np
import pytest

PERIOD = 1e-3


def test_a_block_that_threads_share_never_gives_a_wrong_answer():
    """Calls of one block take turns, or say that it is in use; each that returns has been booked once."""

    class Yielding:
        """A candidate within whose call other threads run."""

        def decrease(self, sample):
            time.sleep(0)
            return sample.work

    readings, observer = ly.Readings(PERIOD), ly.Observer(candidate=Yielding())
    start = threading.Barrier(4)
    readings.read(0.0, 0.0)
    sample = readings.read(1e-4, 1.0)
    booked, refused = [], []

    def book():
        done = 0
        start.wait()
        for _ in range(5000):
            try:
                observer.observe(sample)
                done += 1
            except RuntimeError as error:
                refused.append(str(error))
        booked.append(done)

    threads = [threading.Thread(target=book) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert observer.observed_energy == pytest.approx(sum(booked) * sample.work, rel=1e-9)
    assert set(refused) == {"this Observer is in use by another call; make a Observer for each loop"}


def test_batches_run_without_the_interpreters_lock():
    ticks = np.zeros((400, 4000))
    batch = ly.Batch(ly.Stabilizer("popc", limit=1.0), 4000, PERIOD)
    thread = threading.Thread(target=batch.stabilize, args=(ticks, ticks, ticks))
    counted = 0
    thread.start()
    while thread.is_alive():
        counted += 1
        time.sleep(0)
    assert counted > 10


def test_a_batch_in_use_says_so():
    ticks = np.zeros((400, 4000))
    batch = ly.Batch(ly.Stabilizer("popc", limit=1.0), 4000, PERIOD)
    thread = threading.Thread(target=batch.stabilize, args=(ticks, ticks, ticks))
    thread.start()
    said = None
    while thread.is_alive() and said is None:
        try:
            batch.stabilize(ticks[0], ticks[0], ticks[0])
            time.sleep(0)
        except RuntimeError as error:
            said = str(error)
    thread.join()
    assert said == "this Batch is in use by another call; make a Batch for each loop"


def resident():
    """Memory of this process, kB."""
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS"))


def test_a_million_calls_keep_no_memory():
    pytest.importorskip("resource")
    readings, popc = ly.Readings(PERIOD, axes=3), ly.Stabilizer("lolc", limit=10.0, damping=0.1, axes=3)
    position, applied = np.zeros(3), np.ones(3)

    def calls(count):
        for _ in range(count):
            correction = popc.stabilize(readings.read(position, applied), applied)
            correction.effort  # noqa: B018
        gc.collect()

    calls(100_000)
    before = resident()
    calls(1_000_000)
    # A byte lost in each call would be about 1000 kB.
    assert resident() - before < 900
