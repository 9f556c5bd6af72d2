//! Lyapunov observer/controller by hand, which credits the device's own damper.

macro_rules! lolc {
    ($real:ident) => {
        /// A wall behind a controller that credits a damper.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Credited {
            mass: Mass,
            wall: Wall,
            damping: $real,
            passivity: Passivity,
        }

        impl Credited {
            pub(crate) fn new() -> Self {
                let damping = DEVICE_DAMPING as $real;
                Self { mass: Mass::new(), wall: Wall::new(), damping, passivity: Passivity::new() }
            }

            #[inline(never)]
            pub(crate) fn run(&mut self, positions: &mut [$real]) {
                let Self { mass, wall, damping, passivity } = self;
                let (mut applied, mut moved) = (0.0, 0.0);
                for position in positions {
                    let velocity = moved / mass.period;
                    let burnt = *damping * (velocity * velocity * mass.period);
                    let decrease = applied * moved + if burnt.is_finite() { burnt } else { 0.0 };
                    let force = wall.force(mass.position, velocity);
                    applied = passivity.effort(mass.period, velocity, decrease, force);
                    moved = mass.advance(applied);
                    *position = mass.position;
                }
            }
        }
    };
}

pub(crate) use lolc;
