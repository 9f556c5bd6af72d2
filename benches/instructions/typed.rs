//! The loops composed by type.

use lyapunov::{
    DampingLimit, Dissipation, Lolc, OnePort, ParameterError, Plant, Popc, PortEnergy, Reading,
    Readings, Scalar, Stabilized,
    bodies::{Body, Impedance, IntegratedPlant},
    effects::{BackwardDifference, OnePortExt, ZeroOrderHold},
    environments::Wall,
    integrators::{Oscillator, RungeKuttaNystrom4},
    stabilizers::{ForceBound, Tank, TankLimits},
};

use super::numbers::{
    BOUND_DAMPING, BUDGET, DAMPING, DEVICE_DAMPING, DEVICE_MASS, FASTEST, HOLD, MOST,
    OPERATOR_DAMPING, OPERATOR_MASS, OPERATOR_STIFFNESS, PERIOD, POWER, ROOM, START, STEPS,
    STIFFNESS,
};

/// A held wall behind the stabilizer.
pub(crate) type Corrected<T> =
    BackwardDifference<Stabilized<ZeroOrderHold<Wall<T>, T>, Popc<T>, T>>;

/// A wall alone.
pub(crate) type Plain<T> = BackwardDifference<Wall<T>>;

/// A mass moved by the classical Runge-Kutta method.
pub(crate) type Integrated<T> = IntegratedPlant<T, Oscillator<T>, RungeKuttaNystrom4>;

/// Loop of a plant and a port.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Loop<B, P> {
    pub(crate) plant: B,
    pub(crate) port: P,
}

impl<B, P> Loop<B, P> {
    #[inline(never)]
    pub(crate) fn run<T: Scalar>(&mut self, positions: &mut [T])
    where
        B: Plant<T>,
        P: OnePort<T>,
    {
        let mut sample = self.plant.start();
        for position in positions {
            sample = self.plant.advance(self.port.respond(&sample));
            *position = sample.position;
        }
    }

    /// The same run on copies that are dropped with it.
    #[inline(never)]
    pub(crate) fn roll<T: Scalar>(&self, positions: &mut [T])
    where
        B: Plant<T> + Copy,
        P: OnePort<T> + Copy,
    {
        let Self { mut plant, mut port } = *self;
        let mut sample = plant.start();
        for position in positions {
            sample = plant.advance(port.respond(&sample));
            *position = sample.position;
        }
    }
}

fn hand<T: Scalar>() -> Impedance<T> {
    let of = T::of;
    let operator = Impedance {
        mass: of(OPERATOR_MASS),
        damping: of(OPERATOR_DAMPING),
        stiffness: of(OPERATOR_STIFFNESS),
    };
    let device =
        Impedance { mass: of(DEVICE_MASS), damping: of(DEVICE_DAMPING), stiffness: of(0.0) };
    operator + device
}

fn exact<T: Scalar>() -> Result<Body<T>, ParameterError> {
    Ok(Body::new(hand(), T::of(PERIOD))?.starting(T::of(START), T::of(0.0)))
}

fn wall<T: Scalar>() -> Result<Wall<T>, ParameterError> {
    Wall::new(T::of(STIFFNESS), T::of(DAMPING))
}

pub(crate) fn stabilized<T: Scalar>() -> Result<Loop<Body<T>, Corrected<T>>, ParameterError> {
    let popc = Popc::new(PortEnergy, DampingLimit::at(T::of(MOST))?);
    Ok(Loop { plant: exact()?, port: wall()?.held(HOLD)?.stabilized(popc).differenced() })
}

pub(crate) fn plain<T: Scalar>() -> Result<Loop<Body<T>, Plain<T>>, ParameterError> {
    Ok(Loop { plant: exact()?, port: wall()?.differenced() })
}

/// The plain loop with a body that is integrated.
pub(crate) fn integrated<T: Scalar>() -> Result<Loop<Integrated<T>, Plain<T>>, ParameterError> {
    let plant =
        IntegratedPlant::new(Oscillator::new(hand())?, RungeKuttaNystrom4, T::of(PERIOD), STEPS)?;
    Ok(Loop { plant: plant.starting(T::of(START), T::of(0.0)), port: wall()?.differenced() })
}

/// A wall behind a controller that credits a damper.
pub(crate) type Credited<T> =
    BackwardDifference<Stabilized<Wall<T>, Lolc<T, (PortEnergy, Dissipation<T>)>, T>>;

pub(crate) fn credited<T: Scalar>() -> Result<Loop<Body<T>, Credited<T>>, ParameterError> {
    let candidate = (PortEnergy, Dissipation::of(T::of(DEVICE_DAMPING))?);
    let lolc = Lolc::new(candidate, DampingLimit::at(T::of(MOST))?);
    Ok(Loop { plant: exact()?, port: wall()?.stabilized(lolc).differenced() })
}

/// A wall behind a force bound.
pub(crate) type Limited<T> = BackwardDifference<Stabilized<Wall<T>, ForceBound<T>, T>>;

pub(crate) fn limited<T: Scalar>() -> Result<Loop<Body<T>, Limited<T>>, ParameterError> {
    let bound = ForceBound::new(T::of(BOUND_DAMPING))?.budgeted(T::of(BUDGET))?;
    Ok(Loop { plant: exact()?, port: wall()?.stabilized(bound).differenced() })
}

/// A wall behind a tank.
pub(crate) type Tanked<T> = BackwardDifference<Stabilized<Wall<T>, Tank<T, PortEnergy>, T>>;

pub(crate) fn tanked<T: Scalar>() -> Result<Loop<Body<T>, Tanked<T>>, ParameterError> {
    let [start, floor, ceiling, power] = [BUDGET, 0.0, ROOM, POWER].map(T::of);
    let tank = Tank::new(PortEnergy, TankLimits { start, floor, ceiling, power })?;
    Ok(Loop { plant: exact()?, port: wall()?.stabilized(tank).differenced() })
}

/// A loop of one's own: a wall behind the stabilizer, which is told readings.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Own<T: Scalar> {
    plant: Body<T>,
    readings: Readings<T>,
    port: Stabilized<Wall<T>, Popc<T>, T>,
}

impl<T: Scalar> Own<T> {
    #[inline(never)]
    pub(crate) fn run(&mut self, positions: &mut [T]) {
        let mut at = self.plant.start();
        let mut applied = T::of(0.0);
        for position in positions {
            let reading = Reading { position: at.position, applied };
            applied = self.port.respond(&self.readings.read(reading).sample);
            at = self.plant.advance(applied);
            *position = at.position;
        }
    }
}

pub(crate) fn own<T: Scalar>() -> Result<Own<T>, ParameterError> {
    let popc = Popc::new(PortEnergy, DampingLimit::at(T::of(MOST))?);
    let readings = Readings::every(T::of(PERIOD))?.no_faster_than(T::of(FASTEST))?;
    Ok(Own { plant: exact()?, readings, port: wall()?.stabilized(popc) })
}
