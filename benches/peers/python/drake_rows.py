"""Drake: the motion as a LinearSystem, and as a MultibodyPlant with a prismatic joint, continuous and discrete."""

from rows import DAMPING, MASS, PERIOD, START, STIFFNESS, rollout, row, serve


def load():
    from importlib.metadata import version

    from pydrake.math import RigidTransform  # noqa: F401  (registers types that the plant needs)
    from pydrake.multibody.plant import MultibodyPlant
    from pydrake.multibody.tree import PrismaticJoint, PrismaticSpring, SpatialInertia, UnitInertia
    from pydrake.systems.analysis import ApplySimulatorConfig, Simulator, SimulatorConfig
    from pydrake.systems.primitives import LinearSystem

    def simulated(simulator, port, sign, read, write):
        context = simulator.get_mutable_context()
        held = port.FixValue(context, [0.0])

        def run():
            context.SetTime(0.0)
            write(context)
            simulator.Initialize()
            ended = 0

            def advance(position, velocity, force):
                nonlocal ended
                ended += 1
                held.GetMutableData().get_mutable_value().SetAtIndex(0, sign * force)
                simulator.AdvanceTo(ended * PERIOD)
                return read(context)

            return rollout(advance)

        return run

    def controlled(simulator, scheme, tolerance):
        config = SimulatorConfig(
            integration_scheme=scheme, accuracy=tolerance, max_step_size=PERIOD, use_error_control=True
        )
        ApplySimulatorConfig(config, simulator)

    def linear(scheme, tolerance):
        system = LinearSystem(
            [[0.0, 1.0], [-STIFFNESS / MASS, -DAMPING / MASS]], [[0.0], [-1.0 / MASS]], [[1.0, 0.0]], [[0.0]], 0.0
        )
        simulator = Simulator(system)
        controlled(simulator, scheme, tolerance)
        return simulated(
            simulator,
            system.get_input_port(),
            1.0,
            lambda context: context.get_continuous_state_vector().CopyToVector().tolist(),
            lambda context: context.SetContinuousState([START, 0.0]),
        )

    def multibody(step, scheme=None, tolerance=None):
        plant = MultibodyPlant(step)
        body = plant.AddRigidBody("body", SpatialInertia(MASS, [0.0] * 3, UnitInertia.SolidSphere(0.01)))
        joint = plant.AddJoint(PrismaticJoint("slide", plant.world_frame(), body.body_frame(), [1.0, 0.0, 0.0], damping=DAMPING))
        plant.AddForceElement(PrismaticSpring(joint, 0.0, STIFFNESS))
        plant.AddJointActuator("wall", joint)
        plant.mutable_gravity_field().set_gravity_vector([0.0] * 3)
        plant.Finalize()
        simulator = Simulator(plant)
        if scheme:
            controlled(simulator, scheme, tolerance)
        return simulated(
            simulator,
            plant.get_actuation_input_port(),
            -1.0,
            lambda context: plant.GetPositionsAndVelocities(context).tolist(),
            lambda context: plant.SetPositionsAndVelocities(context, [START, 0.0]),
        )

    rows = []
    for scheme, name in (("runge_kutta5", "RK5"), ("runge_kutta3", "RK3")):
        for tolerance in (1e-3, 1e-6, 1e-9, 1e-12):
            rows.append(row(f"Drake LinearSystem {name}", linear(scheme, tolerance), tolerance=tolerance))
    for tolerance in (1e-3, 1e-6, 1e-9):
        run = multibody(0.0, "runge_kutta3", tolerance)
        rows.append(row("Drake MultibodyPlant RK3", run, tolerance=tolerance))
    for steps in (1, 10, 100):
        rows.append(row("Drake MultibodyPlant discrete", multibody(PERIOD / steps), steps=steps))
    return version("drake"), rows


serve("drake", load)
