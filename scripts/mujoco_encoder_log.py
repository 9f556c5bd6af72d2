"""Makes scenes/logs/mujoco-encoder.csv: a plant of MuJoCo's that taps a virtual wall, seen by an encoder, with a late motor.

    python3 -m venv venv && venv/bin/pip install mujoco==4.0.0
    venv/bin/python scripts/mujoco_encoder_log.py scenes/logs/mujoco-encoder.csv

The plant is a slide joint (0.42 kg, 1.3 N.s/m, a spring of 180 N/m relaxed at 9 mm, from -6 mm) that MuJoCo integrates by RK4 in steps
of 0.05 ms. The wall (1.5 kN/m and 4 N.s/m from 3 mm on) is computed here at 1 kHz from the position in steps of 20 um and its
backward difference, and acts two periods later. Nothing of lyapunov is used, so that the log is independent of it.

Columns: t in s, x in m as the encoder tells it, and f in N, the wall's force as computed at this row, positive against
motion into the wall. MuJoCo is given -f of two rows before.
"""

import csv
import sys

import mujoco

RATE = 1000  # Hz, of the wall and of the log
STEPS = 20  # of MuJoCo per row
ROWS = 1201  # 1.2 s
LATE = 2  # rows
RESOLUTION = 20e-6  # m
PLACE, STIFFNESS, DAMPING = 3e-3, 1500.0, 4.0  # m, N/m, N.s/m

MODEL = f"""
<mujoco>
  <option timestep="{1 / (RATE * STEPS)}" integrator="RK4" gravity="0 0 0"/>
  <worldbody>
    <body>
      <joint type="slide" axis="1 0 0" damping="1.3" stiffness="180" springref="0.009"/>
      <geom type="sphere" size="0.01" mass="0.42" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
</mujoco>
"""


def rows():
    model = mujoco.MjModel.from_xml_string(MODEL)
    data = mujoco.MjData(model)
    data.qpos[0] = -6e-3
    last, waiting = None, [0.0] * LATE
    for row in range(ROWS):
        counts = round(float(data.qpos[0]) / RESOLUTION)
        position = counts * RESOLUTION
        velocity = 0.0 if last is None else (position - last) * RATE
        depth = position - PLACE
        force = max(0.0, STIFFNESS * depth + DAMPING * velocity) if depth > 0.0 else 0.0
        yield f"{row / RATE:.3f}", f"{counts * 20e-6:.5f}", repr(round(force, 9))
        waiting.append(force)
        data.qfrc_applied[0] = -waiting.pop(0)
        mujoco.mj_step(model, data, nstep=STEPS)
        last = position


def main():
    with open(sys.argv[1], "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["t", "x", "f"])
        writer.writerows(rows())


if __name__ == "__main__":
    main()
