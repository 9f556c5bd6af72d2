//! Loops by hand: a mass, a wall, and the stabilizer between them.

macro_rules! loops {
    ($real:ident) => {
        /// A held wall behind the stabilizer.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Stabilized {
            mass: Mass,
            wall: Slow,
            passivity: Passivity,
        }

        impl Stabilized {
            pub(crate) fn new() -> Self {
                Self { mass: Mass::new(), wall: Slow::new(), passivity: Passivity::new() }
            }

            #[inline(never)]
            pub(crate) fn run(&mut self, positions: &mut [$real]) {
                let Self { mass, wall, passivity } = self;
                let (mut applied, mut moved) = (0.0, 0.0);
                for position in positions {
                    let velocity = moved / mass.period;
                    let work = applied * moved;
                    wall.book(mass.period, moved, work);
                    let force = wall.force(mass.position, velocity);
                    applied = passivity.effort(mass.period, velocity, work, force);
                    moved = mass.advance(applied);
                    *position = mass.position;
                }
            }

            /// The same run on copies that are dropped with it, so that unused results need not be computed.
            #[inline(never)]
            pub(crate) fn roll(&self, positions: &mut [$real]) {
                let Self { mut mass, mut wall, mut passivity } = *self;
                let (mut applied, mut moved) = (0.0, 0.0);
                for position in positions {
                    let velocity = moved / mass.period;
                    let force = wall.force(mass.position, velocity);
                    applied = passivity.effort(mass.period, velocity, applied * moved, force);
                    moved = mass.advance(applied);
                    *position = mass.position;
                }
            }
        }

        /// A wall behind a force bound.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Limited {
            mass: Mass,
            wall: Wall,
            bound: Bound,
        }

        impl Limited {
            pub(crate) fn new() -> Self {
                let (damping, energy) = (BOUND_DAMPING as $real, BUDGET as $real);
                let bound = Bound { damping, energy, told: NOTHING };
                Self { mass: Mass::new(), wall: Wall::new(), bound }
            }

            #[inline(never)]
            pub(crate) fn run(&mut self, positions: &mut [$real]) {
                let Self { mass, wall, bound } = self;
                let (mut applied, mut moved) = (0.0, 0.0);
                for position in positions {
                    let force = wall.force(mass.position, moved / mass.period);
                    applied = bound.effort(mass.period, moved, applied * moved, force);
                    moved = mass.advance(applied);
                    *position = mass.position;
                }
            }
        }

        /// A wall behind a tank.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Tanked {
            mass: Mass,
            wall: Wall,
            tank: Tank,
        }

        impl Tanked {
            pub(crate) fn new() -> Self {
                let (energy, room) = (BUDGET as $real, ROOM as $real);
                let tank = Tank { energy, room, power: POWER as $real, told: NOTHING };
                Self { mass: Mass::new(), wall: Wall::new(), tank }
            }

            #[inline(never)]
            pub(crate) fn run(&mut self, positions: &mut [$real]) {
                let Self { mass, wall, tank } = self;
                let (mut applied, mut moved) = (0.0, 0.0);
                for position in positions {
                    let velocity = moved / mass.period;
                    let force = wall.force(mass.position, velocity);
                    applied = tank.effort(mass.period, velocity, applied * moved, force);
                    moved = mass.advance(applied);
                    *position = mass.position;
                }
            }
        }

        /// A wall alone.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Plain {
            mass: Mass,
            wall: Wall,
        }

        impl Plain {
            pub(crate) fn new() -> Self {
                Self { mass: Mass::new(), wall: Wall::new() }
            }

            #[inline(never)]
            pub(crate) fn run(&mut self, positions: &mut [$real]) {
                let Self { mass, wall } = self;
                let mut moved = 0.0;
                for position in positions {
                    moved = mass.advance(wall.force(mass.position, moved / mass.period));
                    *position = mass.position;
                }
            }
        }

        /// A wall alone, against a mass that is integrated.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Integrated {
            mass: Numeric,
            wall: Wall,
        }

        impl Integrated {
            pub(crate) fn new() -> Self {
                Self { mass: Numeric::new(), wall: Wall::new() }
            }

            #[inline(never)]
            pub(crate) fn run(&mut self, positions: &mut [$real]) {
                let Self { mass, wall } = self;
                let mut moved = 0.0;
                for position in positions {
                    moved = mass.advance(wall.force(mass.position, moved / mass.period));
                    *position = mass.position;
                }
            }
        }
    };
}

pub(crate) use loops;
