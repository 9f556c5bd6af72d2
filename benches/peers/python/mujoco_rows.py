"""MuJoCo: one slide joint with spring and damper, the wall's force applied to it and held."""

from rows import DAMPING, MASS, PERIOD, START, STIFFNESS, rollout, row, serve

MODEL = f"""
<mujoco>
  <option timestep="{{step!r}}" gravity="0 0 0" integrator="{{integrator}}"><flag contact="disable"/></option>
  <worldbody>
    <body>
      <joint type="slide" axis="1 0 0" stiffness="{STIFFNESS!r}" damping="{DAMPING!r}"/>
      <geom type="sphere" size="0.01" mass="{MASS!r}" contype="0" conaffinity="0"/>
    </body>
  </worldbody>
</mujoco>
"""

STEPS = {"RK4": (1, 2, 5, 10, 20, 50, 100), "Euler": (1, 10, 100), "implicitfast": (1, 10, 100)}


def load():
    import mujoco

    def stepped(integrator, steps):
        model = mujoco.MjModel.from_xml_string(MODEL.format(step=PERIOD / steps, integrator=integrator))
        data = mujoco.MjData(model)

        def advance(position, velocity, force):
            data.qfrc_applied[0] = -force
            mujoco.mj_step(model, data, steps)
            return data.qpos[0], data.qvel[0]

        def run():
            mujoco.mj_resetData(model, data)
            data.qpos[0] = START
            return rollout(advance)

        return run

    rows = [
        row(f"MuJoCo {integrator}", stepped(integrator, steps), steps=steps)
        for integrator, counts in STEPS.items()
        for steps in counts
    ]
    return mujoco.__version__, rows


serve("mujoco", load)
