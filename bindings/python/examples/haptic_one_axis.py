"""One-axis haptic device that is let go onto a stiff virtual wall, in MuJoCo, without and with POPC.

    python haptic_one_axis.py [picture.png]

Two models of MuJoCo: the device (a handle of 0.3 kg in a hand's spring) and the virtual world, whose contact solver tells the
force of the wall. The servo puts the handle's position into the world at 1 kHz, and holds that force.

What it shows: the energy that MuJoCo counts in the device grows without a stabilizer, at walls of 50 to 130 kN/m, and dies with POPC; at
350 N/m no stabilizer is needed. What it does not show: a hand that moves on purpose, noise, or a force that acts late.
"""

import sys

import lyapunov as ly
import mujoco
import numpy as np
import servo

DEVICE = """
<mujoco><option timestep="1e-4" gravity="0 0 0"/><worldbody><body>
  <joint type="slide" axis="1 0 0" stiffness="50" damping="0.2"/><geom size="0.01" mass="0.3"/>
</body></worldbody></mujoco>"""

# The proxy may not pass x = 0. A contact of this reference pushes with `stiffness` times its depth.
WORLD = """
<mujoco><option gravity="0 0 0"/><default><geom condim="1" solref="{} 0" solimp="0.9 0.9"/></default><worldbody>
  <geom type="plane" zaxis="-1 0 0" pos="0.01 0 0" size="1 1 1"/>
  <body><joint type="slide" axis="1 0 0"/>
    <geom size="0.01" mass="1"/></body>
</worldbody></mujoco>"""


def run(stabilizer, stiffness=100e3, start=-0.0045, seconds=2.0):
    """Energies in joules and positions in metres at every tick, before a wall of `stiffness` N/m."""
    model = mujoco.MjModel.from_xml_string(DEVICE)
    device = mujoco.MjData(model)
    device.qpos[0] = start
    world_model = mujoco.MjModel.from_xml_string(WORLD.format(-stiffness))
    world = mujoco.MjData(world_model)
    readings = ly.Readings(servo.PERIOD, no_faster_than=20.0)
    applied, positions = 0.0, []

    def tick():
        nonlocal applied
        positions.append(float(device.qpos[0]))
        world.qpos[:] = device.qpos
        mujoco.mj_forward(world_model, world)
        wall = -float(world.qfrc_constraint[0])
        applied = stabilizer.stabilize(readings.read(positions[-1], applied), wall).effort
        return -applied

    return servo.run(model, device, tick, seconds), np.array(positions)


def stabilizers():
    """The same loop without a stabilizer, and with POPC."""
    limit = ly.damping_limit(0.3, servo.PERIOD)
    return {"none": ly.Stabilizer("none"), "POPC": ly.Stabilizer("popc", limit=limit)}


def main(path):
    from pictures import energies, plt

    runs = {name: run(it) for name, it in stabilizers().items()}
    figure, (motion, energy) = plt.subplots(1, 2, figsize=(7.2, 2.6), layout="constrained")
    for name, (_, positions) in runs.items():
        motion.plot(np.arange(len(positions)), 1e3 * positions, lw=0.8, label=name)
    motion.axhspan(0, 12, color="0.9", zorder=0)
    motion.set(xlim=(0, 1000), ylim=(-12, 6), xlabel="time, ms", ylabel="position, mm (wall grey)")
    energies(energy, {name: told for name, (told, _) in runs.items()})
    figure.savefig(path, dpi=120)
    for name, (told, _) in runs.items():
        print(f"{name:>5}: starts with {1e3 * told[0]:.3f} mJ, at most {1e3 * told.max():.3f}, ends with {1e3 * told[-1]:.2g}")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "haptic_one_axis.png")
