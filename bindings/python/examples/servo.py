"""Servo at 1 kHz in MuJoCo's control callback.

MuJoCo moves the plant and counts its energy; the servo reads joints and holds generalized forces, as the computer of a robot does.
"""

import mujoco
import numpy as np

PERIOD = 1e-3  # s


def run(model, data, tick, seconds):
    """Energy of the plant in joules at every tick, as MuJoCo counts it: kinetic, gravity and springs.

    `tick()` returns the generalized forces, N and N·m, that the motors hold until the next one. The run ends early where the energy
    has grown past a hundred joules.
    """
    model.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY
    steps = round(PERIOD / model.opt.timestep)
    energies, calls, inside = [], 0, False

    def callback(_model, _data):
        nonlocal calls, inside
        if inside:  # A tick may ask another model, and MuJoCo has one callback for all.
            return
        if calls % steps == 0:
            inside = True
            energies.append(float(data.energy.sum()))
            data.qfrc_applied[:] = tick()
            inside = False
        calls += 1

    mujoco.set_mjcb_control(callback)
    try:
        for _ in range(round(seconds / PERIOD)):
            mujoco.mj_step(model, data, nstep=steps)
            if not energies[-1] < 100.0:
                break
    finally:
        mujoco.set_mjcb_control(None)
    return np.array(energies)
