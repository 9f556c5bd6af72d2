"""The command `python -m lyapunov`: it ends as the program of Rust does."""

import os
import signal
import subprocess
import sys
import time

import pytest

MAP = ["map", "--x", "environment.wall.stiffness=1e3..1e5:4000", "--y", "device.damping=0.1..10:4000"]


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
def test_an_interrupt_ends_the_command(number, tmp_path):
    scene, out = tmp_path / "scene.toml", tmp_path / "out"
    scene.write_text("duration = 1\nservo_rate = 1000\ndevice = { mass = 0.2, damping = 0.1 }\nenvironment.wall.stiffness = 1000\n")
    called = [sys.executable, "-m", "lyapunov", *MAP, str(scene), "--out", str(out)]
    running = subprocess.Popen(called, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    # Until it computes: the folder is there from then on.
    deadline = time.monotonic() + 60
    while not out.exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    running.send_signal(number)
    _, told = running.communicate(timeout=60)
    assert running.returncode == 130 and "Traceback" not in told
    assert not list(out.glob("*.svg")) and not list(out.glob("*.html"))
