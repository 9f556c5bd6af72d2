"""Torque loop at 1 kHz over Franka's wire protocol, without and with POPC.

    sudo unshare -n sh -c 'ip link set lo up && chrt -f 10 python franka_wire.py [picture.png]'

The maker's client library (`pylibfranka`) talks to a server of the protocol (`franka-sim`), which moves the FR3 of `fr3.py` in MuJoCo,
and enforces the constraints of communication and the limits of motion: late or abrupt torques end the motion, as at the robot. The
server listens on every interface, so this runs only where there is none but the loopback.

The arm is knocked, and held in place by springs and dampers at the joints. No torque changes by more than 0.9 N·m a tick. What acted over
the last period is the `tau_J_d` of three readings ago: so late a torque moves the arm here, which the accelerations show.

What it shows: at 300 N·m/rad the arm stands by itself; at 1200 its kinetic energy grows until the server stops it, while with POPC it
dies. What it does not show: a real arm, whose joints are elastic, or a computer that is late.
"""

import collections
import contextlib
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import time

import fr3
import lyapunov as ly
import mujoco
import numpy as np
import pylibfranka

PERIOD, DELAY = 1e-3, 3  # s, ticks
DAMPING = 1.0  # N·m·s/rad
CHANGE = 0.9  # N·m a tick; the robot allows 1
KNOCK = np.array([6.0, 6.0, 4.0, 4.0, 2.0, 2.0, 1.0])  # N·m, for 15 ticks


@contextlib.contextmanager
def server():
    """The server of the protocol, as a process of its own with a model of ours."""
    if {name for _, name in socket.if_nameindex()} != {"lo"}:
        raise SystemExit("the server would listen on the network: run this in a namespace, as its page says")
    with tempfile.TemporaryDirectory() as folder:
        arm = fr3.spec()
        arm.compile()
        pathlib.Path(folder, "fr3.xml").write_text(arm.to_xml())
        command = [sys.executable, "-m", "franka_sim.run_server", "--no-gripper", "--enforce-comm-constraints", "--enforce-motion-limits"]
        environment = dict(os.environ, FR3_MJCF=str(pathlib.Path(folder, "fr3.xml")))
        process = subprocess.Popen(command, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            yield
        finally:
            process.terminate()
            process.wait(30)


def connected():
    """The robot, as soon as it answers."""
    for _ in range(120):
        with contextlib.suppress(pylibfranka.NetworkException):
            robot = pylibfranka.Robot("127.0.0.1", pylibfranka.RealtimeConfig.kIgnore)
            robot.set_collision_behavior([100.0] * 7, [100.0] * 7, [100.0] * 6, [100.0] * 6)
            return robot
        time.sleep(0.5)
    raise SystemExit("the server does not answer within a minute")


def run(name, stiffness, ticks=500):
    """Kinetic energies in joules at every tick, why the server stopped, the smallest share of a hundred commands that arrived."""
    model = fr3.spec().compile()
    data = mujoco.MjData(model)
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    limits = {"limit": ly.damping_limit(1.0, PERIOD, delay=DELAY)} if name != "none" else {}
    stabilizer, readings = ly.Stabilizer(name, axes=7, **limits), ly.Readings(PERIOD, axes=7)
    late = collections.deque(maxlen=DELAY + 1)
    energies, stopped, arrived, root, read = [], "", [], None, time.monotonic()
    with server():
        robot = connected()
        control = robot.start_torque_control()
        try:
            for tick in range(ticks):
                state, _ = control.readOnce()
                read = time.monotonic()
                data.qpos[:], data.qvel[:] = state.q, state.dq
                mujoco.mj_forward(model, data)
                commanded, wanted = np.array(state.tau_J_d), KNOCK
                late.append(commanded)
                if tick >= 15:
                    if root is None:
                        root, target = fr3.inertia_root(model, data), data.qpos.copy()
                    energies.append(float(data.energy[1]))
                    arrived.append(state.control_command_success_rate)
                    asked = stiffness * (data.qpos - target) + DAMPING * data.qvel
                    sample = readings.read(root.T @ data.qpos, -np.linalg.solve(root, late[0]))
                    wanted = -root @ stabilizer.stabilize(sample, np.linalg.solve(root, asked)).effort
                torques = pylibfranka.Torques((commanded + np.clip(wanted - commanded, -CHANGE, CHANGE)).tolist())
                torques.motion_finished = tick == ticks - 1
                control.writeOnce(torques)
        except pylibfranka.ControlException as error:
            stopped = str(error)
            arrived += [0.0] * (time.monotonic() - read > 3.0 * PERIOD)  # No state tells any more what was lost.
    return np.array(energies), stopped, min(arrived, default=0.0)


def main(path):
    from pictures import energies, plt

    cases = (("none", 300), ("none", 1200), ("popc", 1200))
    runs = {f"{name}, {stiffness} N·m/rad": run(name, stiffness) for name, stiffness in cases}
    figure, axes = plt.subplots(figsize=(7.2, 2.6), layout="constrained")
    energies(axes, {name: told for name, (told, _, _) in runs.items()})
    figure.savefig(path, dpi=120)
    for name, (told, stopped, arrived) in runs.items():
        print(f"{name}: starts with {1e3 * told[0]:.2f} mJ, has at most {1e3 * told.max():.3g}, ends with {1e3 * told[-1]:.2g}; "
              f"{100 * arrived:.0f} % of the commands arrived where fewest did. {stopped}")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "franka_wire.png")
