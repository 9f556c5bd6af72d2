"""Two arms as master and slave over a lossy channel, in MuJoCo, without and with LOLC at each end.

    python two_arms.py [picture.png]

Two FR3 (`fr3.py`), joint by joint coupled by a spring to where the other one was said to be. Messages take 8 to 12 ms each way, and
each third is lost. The master is knocked, and the slave meets MuJoCo's own table.

Each end may give what the other has taken. It sends, with its position, the sum of the energy that its spring took, so that a lost
message loses no energy; LOLC's candidate, written here, adds what arrived and subtracts what was given.

What it shows: the energy that MuJoCo counts in both arms grows without stabilizers; with them it dies, and the arms end in the same
posture. What it does not show: a hand that holds the master, or an end that lies.
"""

import sys

import fr3
import lyapunov as ly
import mujoco
import numpy as np
import servo

DAMPING = 0.5  # N·m·s/rad, of the coupling at each joint


class Arrived:
    """Candidate of an end: what arrived from the other end, less what this end gave, plus what its correction burnt."""

    def __init__(self):
        self.taken, self.heard, self.asked, self.arrived = 0.0, 0.0, np.zeros(7), 0.0

    def decrease(self, sample):
        work = float(self.asked @ sample.displacement)
        burnt = float(sample.work.sum()) - work
        self.taken += max(0.0, work)
        arrived, self.heard = self.arrived - self.heard, self.arrived
        return min(0.0, work) + burnt + arrived


class End:
    """One arm with its stabilizer."""

    def __init__(self, joints, root, name):
        self.joints, self.root, self.told, self.applied = joints, root, np.array(fr3.HOME), np.zeros(7)
        self.candidate = Arrived()
        limit = ly.damping_limit(1.0, servo.PERIOD, cap=0.1)
        chosen = {"lolc": {"limit": limit, "candidate": self.candidate}}.get(name, {})
        self.stabilizer, self.readings = ly.Stabilizer(name, axes=7, **chosen), ly.Readings(servo.PERIOD, axes=7)

    def tick(self, data, stiffness):
        angles, speeds = data.qpos[self.joints], data.qvel[self.joints]
        sample = self.readings.read(self.root.T @ angles, self.applied)
        asked = np.linalg.solve(self.root, stiffness * (angles - self.told) + DAMPING * speeds)
        self.applied = self.stabilizer.stabilize(sample, asked).effort
        self.candidate.asked = asked
        return -self.root @ self.applied


def run(name, stiffness=300.0, delay=8, loss=0.33, seed=1, seconds=1.5, knock=(0.5, 0.3, -0.5)):
    """Energies in joules, and joint angles of both arms, at every tick."""
    both, slave = fr3.spec(), fr3.spec()
    both.worldbody.add_frame(pos=[0, 1, 0]).attach_body(slave.bodies[1], "slave_", "")
    both.worldbody.add_geom(type=mujoco.mjtGeom.mjGEOM_PLANE, size=[9, 9, 1], pos=[0, 0, 0.528], solref=[0.004, 1])
    both.option.timestep = 2e-4
    model = both.compile()
    for geom in range(model.ngeom):  # The table is under the slave only.
        if model.geom(geom).name == "tool":
            model.geom_contype[geom] = model.geom_conaffinity[geom] = 0
    data = mujoco.MjData(model)
    data.qpos[:] = fr3.HOME * 2
    mujoco.mj_forward(model, data)
    root = fr3.inertia_root(model, data)
    data.qvel[:7] = np.linalg.solve(root @ root.T, fr3.jacobian(model, data)[:3].T @ np.array(knock))[:7]
    ends = [End(slice(0, 7), root[:7, :7], name), End(slice(7, 14), root[7:, 7:], name)]
    chance, letters, now, rows = np.random.default_rng(seed), [], 0, []

    def tick():
        nonlocal now, letters
        rows.append(data.qpos.copy())
        for due, to, angles, taken in letters:
            if due == now:  # Late letters never take energy back.
                to.told, to.candidate.arrived = angles, max(to.candidate.arrived, taken)
        letters = [letter for letter in letters if letter[0] > now]
        torques = np.concatenate([end.tick(data, stiffness) for end in ends])
        for end, other in (ends, ends[::-1]):
            if chance.random() >= loss:
                due = now + delay + int(chance.integers(5))
                letters.append((due, other, data.qpos[end.joints].copy(), end.candidate.taken))
        now += 1
        return torques

    return servo.run(model, data, tick, seconds), np.array(rows)


def main(path):
    from pictures import energies, plt

    runs = {"none": run("none"), "LOLC at each end": run("lolc")}
    figure, axes = plt.subplots(1, 3, figsize=(7.2, 2.5), layout="constrained")
    for panel, (name, (told, angles)) in zip(axes, runs.items()):
        for joint, color in ((0, "C2"), (3, "C3")):
            for arm, style in ((0, "-"), (7, ":")):
                panel.plot(np.degrees(angles[:, arm + joint] - fr3.HOME[joint]), style, color=color, lw=0.9)
        panel.set(title=name, xlabel="time, ms", ylabel="joints 1 and 4, ° (slave dotted)", ylim=(-5, 5))
    energies(axes[2], {name: told for name, (told, _) in runs.items()})
    figure.savefig(path, dpi=120)
    for name, (told, _) in runs.items():
        print(f"{name:>16}: starts with {1e3 * told[0]:.1f} mJ, has at most {1e3 * told.max():.3g}, ends with {1e3 * told[-1]:.2g}")


if __name__ == "__main__":
    main(sys.argv[1] if len(sys.argv) > 1 else "two_arms.png")
