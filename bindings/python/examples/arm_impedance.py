"""Seven-joint arm that presses on a table under a Cartesian impedance too stiff for its rate, in MuJoCo, without and with POPC.

    python arm_impedance.py [picture.png]

Franka's FR3 (`fr3.py`) presses with 20 N on MuJoCo's own stiff table and is knocked aside by 0.5 N·s. The controller, spring and
damper in six axes, runs at 1 kHz, and its torques act five ticks late. The stabilizer stands at the joints, in coordinates in
which the arm has the mass 1 in every direction: the work is that of the torques, exactly, and the limit is known.

What it shows: at 40 kN/m the energy that MuJoCo counts grows without a stabilizer, and with POPC dies after a first burst, to less
than three times what arm and virtual spring start with; at 1 kN/m the controller needs no help. Five ticks late and at 60 kN/m POPC does not
save it. What it does not show: joint friction at rest, elastic joints, or limits of the torques.
"""

import collections
import sys

import fr3
import lyapunov as ly
import mujoco
import numpy as np
import servo

DELAY = 5  # ticks
PRESS = 20.0  # N
DAMPING = np.array([20.0] * 3 + [0.4] * 3)  # N·s/m, N·m·s/rad


def scene():
    """The arm, and a table under the end of its tool."""
    arm = fr3.spec()
    arm.option.timestep = 1e-4
    model = arm.compile()
    data = mujoco.MjData(model)
    data.qpos[:] = fr3.HOME
    mujoco.mj_forward(model, data)
    height = data.site("tool").xpos[2] - fr3.BALL
    arm.worldbody.add_geom(
        type=mujoco.mjtGeom.mjGEOM_PLANE, size=[1, 1, 1], pos=[0, 0, height], solref=[0.002, 1], friction=[0.1, 0.005, 1e-4]
    )
    return arm.compile()


def run(name, stiffness=40e3, delay=DELAY, knock=(0.3, 0.2, 0.35), seconds=0.6, share=0.5):
    """Energies in joules and places of the tool in metres at every tick, and the force on the table at the end, N."""
    model = scene()
    data = mujoco.MjData(model)
    data.qpos[:] = fr3.HOME
    mujoco.mj_forward(model, data)
    root, level = fr3.inertia_root(model, data), data.site("tool").xmat.reshape(3, 3).copy()
    data.qvel[:] = np.linalg.solve(root @ root.T, fr3.jacobian(model, data)[:3].T @ np.array(knock))
    springs = np.array([stiffness] * 3 + [0.01 * stiffness] * 3)
    target = data.site("tool").xpos - [0, 0, PRESS / stiffness]

    numbers = {"limit": ly.damping_limit(1.0, servo.PERIOD, delay=delay, cap=share)} if name != "none" else {}
    stabilizer = ly.Stabilizer(name, axes=7, **numbers)
    readings = ly.Readings(servo.PERIOD, axes=7)
    late = collections.deque([np.zeros(7)] * delay)
    applied, places = np.zeros(7), []

    def tick():
        nonlocal applied
        places.append(data.site("tool").xpos.copy())
        sample = readings.read(root.T @ data.qpos, applied)
        jacobian, tool = fr3.jacobian(model, data), data.site("tool")
        turned = tool.xmat.reshape(3, 3)
        twisted = -0.5 * sum(np.cross(turned[:, axis], level[:, axis]) for axis in range(3))
        stretched = np.concatenate([tool.xpos - target, twisted])
        wrench = springs * stretched + DAMPING * (jacobian @ data.qvel)
        late.append(stabilizer.stabilize(sample, np.linalg.solve(root, jacobian.T @ wrench)).effort)
        applied = late.popleft()
        return -root @ applied

    told = servo.run(model, data, tick, seconds)
    pressed = np.zeros(6)
    if data.ncon > 0:
        mujoco.mj_contactForce(model, data, 0, pressed)
    return told, np.array(places), pressed[0]


def start(stiffness):
    """Energy that the virtual spring starts with, J."""
    return PRESS**2 / (2 * stiffness)


def main(path):
    from pictures import energies, paths, plt

    runs = {"none": run("none"), "POPC": run("popc")}
    figure = plt.figure(figsize=(7.2, 4.0), layout="constrained")
    rows = figure.subfigures(2, 1)
    paths(rows[0], {name: places for name, (_, places, _) in runs.items()}, [(0, 50), (50, 150), (150, 300), (300, 450)])
    energies(rows[1].subplots(), {name: told for name, (told, _, _) in runs.items()})
    figure.savefig(path, dpi=120)
    for name, (told, _, pressed) in runs.items():
        print(f"{name:>5}: starts with {1e3 * told[0]:.1f} mJ and {1e3 * start(40e3):.1f} in the virtual spring, has at most "
              f"{1e3 * told.max():.3g}, ends with {1e3 * told[-1]:.2g} and {pressed:.1f} N on the table")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "arm_impedance.png")
