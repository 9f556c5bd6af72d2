"""Makes scenes/logs/mujoco-wall.csv: a plant of MuJoCo's at a virtual wall that this script computes at 100 Hz.

    python3 -m venv venv && venv/bin/pip install mujoco==4.0.0
    venv/bin/python scripts/mujoco_wall_log.py scenes/logs/mujoco-wall.csv

The plant is that of scenes/paper-8k-none.toml (0.3 kg, 0.201 N.s/m, 50 N/m, from -4 mm) as a slide joint.
MuJoCo integrates it by RK4 in steps of 0.1 ms. The wall (8 kN/m, 2 N.s/m) is not in MuJoCo's model: it is
computed here at 100 Hz from the position and its backward difference, and held. Nothing of lyapunov is used,
so that the log is independent of it.

Columns: t in s, x in m, and f in N, the wall's force on the device from this row until the next, positive
against motion into the wall. MuJoCo is given -f.
"""

import csv
import sys

import mujoco

RATE = 100  # Hz, of the wall and of the log
STEPS = 100  # of MuJoCo per row
ROWS = 201  # 2 s
STIFFNESS, DAMPING = 8000.0, 2.0  # N/m, N.s/m

MODEL = f"""
<mujoco>
  <option timestep="{1 / (RATE * STEPS)}" integrator="RK4" gravity="0 0 0"/>
  <worldbody>
    <body>
      <joint name="wheel" type="slide" axis="1 0 0" damping="0.201" stiffness="50" springref="0"/>
      <geom type="sphere" size="0.01" mass="0.3" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
</mujoco>
"""


def rows():
    model = mujoco.MjModel.from_xml_string(MODEL)
    data = mujoco.MjData(model)
    data.qpos[0] = last = -0.004
    for row in range(ROWS):
        position = float(data.qpos[0])
        velocity = (position - last) * RATE
        force = max(0.0, STIFFNESS * position + DAMPING * velocity) if position > 0.0 else 0.0
        yield row / RATE, position, force
        data.qfrc_applied[0] = -force
        mujoco.mj_step(model, data, nstep=STEPS)
        last = position


def main():
    with open(sys.argv[1], "w", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["t", "x", "f"])
        writer.writerows(rows())


if __name__ == "__main__":
    main()
