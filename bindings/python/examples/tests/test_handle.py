"""A handle at a virtual wall, both moved by MuJoCo alone: what the example shows, by the energy that MuJoCo counts."""

import pathlib
import sys

import lyapunov as ly
import pytest

mujoco = pytest.importorskip("mujoco", reason="SKIPPED: the handle: there is no wheel of MuJoCo")
sys.path.insert(0, str(pathlib.Path(__file__).parents[1]))

import haptic_one_axis  # noqa: E402


def test_the_wall_of_the_virtual_world_is_as_stiff_as_said():
    """Else the claims would be about another wall."""
    model = mujoco.MjModel.from_xml_string(haptic_one_axis.WORLD.format(-100e3))
    data = mujoco.MjData(model)
    for depth in (1e-5, 1e-4, 1e-3):
        data.qpos[0] = depth
        mujoco.mj_forward(model, data)
        assert -data.qfrc_constraint[0] == pytest.approx(100e3 * depth, rel=1e-6)


@pytest.mark.parametrize("stiffness, start", [(100e3, -4.5e-3), (50e3, -4.5e-3), (100e3, -3.7e-3), (130e3, -4.1e-3)])
def test_a_handle_settles_at_a_wall_that_drives_it_away(stiffness, start):
    told = {
        name: haptic_one_axis.run(it, stiffness, start)[0] for name, it in haptic_one_axis.stabilizers().items()
    }
    assert told["none"][-1] > 8.0 * told["none"][0]
    assert told["POPC"][-1] < 0.2 * told["POPC"][0]
    assert told["POPC"].max() < 2.0 * told["POPC"][0]


def test_a_soft_wall_needs_no_stabilizer():
    """Below twice the damping over the period, the known bound."""
    told = haptic_one_axis.run(ly.Stabilizer("none"), 350.0)[0]
    assert told.max() < 1.001 * told[0] and told[-1] < 0.6 * told[0]
