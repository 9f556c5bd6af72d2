//! The loops composed by type.

use lyapunov::{
    Adapt, Body, DampingLimit, Difference, ForceBound, Hold, Impedance, OnePort, ParameterError,
    Plant, Popc, PortEnergy, Scalar, Stabilized, Store, Tank, Wall,
};

use super::numbers::{
    BOUND_DAMPING, BUDGET, DAMPING, DEVICE_DAMPING, DEVICE_MASS, HOLD, MOST, OPERATOR_DAMPING,
    OPERATOR_MASS, OPERATOR_STIFFNESS, PERIOD, POWER, ROOM, START, STIFFNESS,
};

/// A held wall behind the stabilizer.
pub(crate) type Corrected<T> = Difference<Stabilized<Hold<Wall<T>, T>, Popc<T>, T>>;

/// A wall alone.
pub(crate) type Plain<T> = Difference<Wall<T>>;

/// What moves, and what answers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Loop<T: Scalar, P> {
    pub(crate) plant: Body<T>,
    pub(crate) port: P,
}

impl<T: Scalar, P: OnePort<T>> Loop<T, P> {
    #[inline(never)]
    pub(crate) fn run(&mut self, positions: &mut [T]) {
        let mut drive = self.plant.start();
        for position in positions {
            drive = self.plant.advance(self.port.respond(&drive));
            *position = drive.position;
        }
    }
}

impl<T: Scalar, P: OnePort<T> + Copy> Loop<T, P> {
    /// The same on copies that end with it.
    #[inline(never)]
    pub(crate) fn roll(&self, positions: &mut [T]) {
        let Self { mut plant, mut port } = *self;
        let mut drive = plant.start();
        for position in positions {
            drive = plant.advance(port.respond(&drive));
            *position = drive.position;
        }
    }
}

fn plant<T: Scalar>() -> Result<Body<T>, ParameterError> {
    let of = T::of;
    let operator = Impedance {
        mass: of(OPERATOR_MASS),
        damping: of(OPERATOR_DAMPING),
        stiffness: of(OPERATOR_STIFFNESS),
    };
    let device =
        Impedance { mass: of(DEVICE_MASS), damping: of(DEVICE_DAMPING), stiffness: of(0.0) };
    Ok(Body::new(operator + device, of(PERIOD))?.starting(of(START), of(0.0)))
}

pub(crate) fn stabilized<T: Scalar>() -> Result<Loop<T, Corrected<T>>, ParameterError> {
    let wall = Wall::new(T::of(STIFFNESS), T::of(DAMPING))?;
    let popc = Popc::new(PortEnergy, DampingLimit::at(T::of(MOST))?);
    Ok(Loop { plant: plant()?, port: wall.held(HOLD)?.stabilized(popc).differenced() })
}

pub(crate) fn plain<T: Scalar>() -> Result<Loop<T, Plain<T>>, ParameterError> {
    let wall = Wall::new(T::of(STIFFNESS), T::of(DAMPING))?;
    Ok(Loop { plant: plant()?, port: wall.differenced() })
}

/// A wall behind a force bound.
pub(crate) type Limited<T> = Difference<Stabilized<Wall<T>, ForceBound<T>, T>>;

pub(crate) fn limited<T: Scalar>() -> Result<Loop<T, Limited<T>>, ParameterError> {
    let wall = Wall::new(T::of(STIFFNESS), T::of(DAMPING))?;
    let bound = ForceBound::new(T::of(BOUND_DAMPING))?.budgeted(T::of(BUDGET))?;
    Ok(Loop { plant: plant()?, port: wall.stabilized(bound).differenced() })
}

/// A wall behind a tank.
pub(crate) type Tanked<T> = Difference<Stabilized<Wall<T>, Tank<T, PortEnergy>, T>>;

pub(crate) fn tanked<T: Scalar>() -> Result<Loop<T, Tanked<T>>, ParameterError> {
    let wall = Wall::new(T::of(STIFFNESS), T::of(DAMPING))?;
    let [start, floor, ceiling, power] = [BUDGET, 0.0, ROOM, POWER].map(T::of);
    let tank = Tank::new(PortEnergy, Store { start, floor, ceiling, power })?;
    Ok(Loop { plant: plant()?, port: wall.stabilized(tank).differenced() })
}
