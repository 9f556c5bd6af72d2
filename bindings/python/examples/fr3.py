"""Franka's FR3 without its meshes: kinematics, masses and inertias of the maker's URDF, which comes with the package franka-sim.

The URDF has no rotors and no tool. Each rotor's inertia, the joints' damping and the tool (0.7 kg, a ball at its end) are made up.
"""

import importlib.util
import pathlib
import re

import mujoco
import numpy as np

HOME = [0.0, -0.785, 0.0, -2.356, 0.0, 1.571, 0.785]
ROTOR, FRICTION = 0.1, 0.2  # kg·m², N·m·s/rad
TOOL = 0.147  # m, from the frame of link 7 to the end of the tool
BALL = 0.02  # m, the radius of that end


def spec():
    """Specification of the arm, without gravity: the drives carry the weight. The end of the tool is the site `tool`."""
    package = importlib.util.find_spec("franka_sim")
    text = (pathlib.Path(package.origin).parent / "models" / "fr3.urdf").read_text()
    text = re.sub(r"<(visual|collision).*?</\1>", "", text, flags=re.DOTALL)
    arm = mujoco.MjSpec.from_string(text)
    arm.option.gravity = [0, 0, 0]
    for joint in arm.joints:
        joint.armature, joint.damping, joint.frictionloss = ROTOR, FRICTION, 0.0
    hand = next(body for body in arm.bodies if body.name == "link7")
    tool = hand.add_body(name="tool")
    tool.add_geom(type=mujoco.mjtGeom.mjGEOM_SPHERE, size=[BALL, 0, 0], pos=[0, 0, TOOL], mass=0.7, name="tool")
    tool.add_site(pos=[0, 0, TOOL], name="tool")
    return arm


def jacobian(model, data):
    """Jacobian of the tool's twist along the axes of the world, of shape (6, joints)."""
    told = np.zeros((6, model.nv))
    mujoco.mj_jacSite(model, data, told[:3], told[3:], model.site("tool").id)
    return told


def inertia_root(model, data):
    """Lower triangular matrix `L` with `M = L Lᵀ`: in the coordinates `Lᵀ q` the arm has the mass 1 in every direction."""
    inertia = np.zeros((model.nv, model.nv))
    mujoco.mj_fullM(model, inertia, data.qM)
    return np.linalg.cholesky(inertia)
