"""Six-axis haptic device that is let go onto a stiff virtual floor, in MuJoCo, without and with POPC.

    python haptic_six_axes.py [picture.png]

Two models of MuJoCo: the device (a bar of 0.4 kg in the springs of a hand, which press it down) and the virtual world, whose
contact solver tells the wrench of the floor on the bar's corners. The servo puts the bar's pose into the world at 1 kHz and
holds that wrench. The bar meets the floor with an edge, so that energy passes from translation to rotation and back.

Metres and radians are brought together by the plant's own inertia matrix `M = L Lᵀ`: in the coordinates `Lᵀ q` every axis has the
mass 1, so one sum and one limit serve all six.

What it shows: the energy that MuJoCo counts in the device grows without a stabilizer, and dies with POPC. What it does not show:
friction at the floor, noise, or a wrench that acts late.
"""

import sys

import lyapunov as ly
import mujoco
import numpy as np
import servo

EDGES = np.array([0.06, 0.015, 0.01])  # m: half of the bar's
BAR = 'type="box" size="{} {} {}"'.format(*EDGES)
DEVICE = f"""
<mujoco><option timestep="1e-4" gravity="0 0 0"/><worldbody><body>
  <joint type="slide" axis="1 0 0" stiffness="50" damping="0.2"/>
  <joint type="slide" axis="0 1 0" stiffness="50" damping="0.2"/>
  <joint type="slide" axis="0 0 1" stiffness="50" damping="0.2" springref="-0.006"/>
  <joint type="ball" stiffness="0.1" damping="2e-4"/>
  <geom {BAR} mass="0.4"/></body></worldbody></mujoco>"""

# The upper side of the floor is at rest under the lower side of the bar.
WORLD = f"""
<mujoco><option gravity="0 0 0"/><default><geom condim="1" solref="{{}} 0" solimp="0.9 0.9"/></default><worldbody>
  <geom type="plane" pos="0 0 {-EDGES[2] - 0.004}" size="1 1 1"/>
  <body><freejoint/><geom {BAR} mass="0.4"/></body>
</worldbody></mujoco>"""


def run(name, contact=100e3, tilt=0.05, seconds=2.0, share=0.5):
    """Energies in joules and configurations at every tick; a corner has the stiffness `contact` times its apparent mass, N/m."""
    model = mujoco.MjModel.from_xml_string(DEVICE)
    device = mujoco.MjData(model)
    mujoco.mju_axisAngle2Quat(device.qpos[3:], np.array([0.8, 0.6, 0.0]), tilt)
    world_model = mujoco.MjModel.from_xml_string(WORLD.format(-contact))
    world = mujoco.MjData(world_model)

    inertia = np.zeros((6, 6))
    mujoco.mj_forward(model, device)
    mujoco.mj_fullM(model, inertia, device.qM)
    root = np.linalg.cholesky(inertia)
    readings = ly.Readings(servo.PERIOD, axes=6)
    numbers = {"limit": ly.damping_limit(1.0, servo.PERIOD, cap=share)} if name != "none" else {}
    stabilizer = ly.Stabilizer(name, axes=6, **numbers)
    position, moved, applied = np.zeros(6), np.zeros(6), np.zeros(6)
    poses = [device.qpos.copy()]

    def tick():
        nonlocal applied, position
        mujoco.mj_differentiatePos(model, moved, 1.0, poses[-1], device.qpos)
        poses.append(device.qpos.copy())
        position = position + root.T @ moved
        world.qpos[:] = device.qpos
        mujoco.mj_forward(world_model, world)
        floor = np.linalg.solve(root, -world.qfrc_constraint)
        applied = stabilizer.stabilize(readings.read(position, applied), floor).effort
        return -root @ applied

    return servo.run(model, device, tick, seconds), np.array(poses[1:])


def main(path):
    from pictures import energies, plt, strip_of_boxes

    runs = {"none": run("none"), "POPC": run("popc")}
    figure = plt.figure(figsize=(7.2, 4.2), layout="constrained")
    rows = figure.subfigures(2, 1, height_ratios=[1, 1.2])
    strip_of_boxes(rows[0], runs["POPC"][1], EDGES, ticks=[0, 80, 114, 160, 344, 1900], floor=-EDGES[2] - 0.004)
    energies(rows[1].subplots(), {name: told for name, (told, _) in runs.items()})
    figure.savefig(path, dpi=120)
    for name, (told, _) in runs.items():
        print(f"{name:>5}: starts with {1e3 * told[0]:.3f} mJ, at most {1e3 * told.max():.3f}, ends with {1e3 * told[-1]:.2g}")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "haptic_six_axes.png")
