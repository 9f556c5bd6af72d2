//! The loops as straight code on concrete types, without a call into the library.

use super::numbers::{
    BOUND_DAMPING, BUDGET, DAMPING, DEVICE_DAMPING, DEVICE_MASS, HOLD, MOST, OPERATOR_DAMPING,
    OPERATOR_MASS, OPERATOR_STIFFNESS, PERIOD, POWER, ROOM, START, STEPS, STIFFNESS,
};

macro_rules! hand {
    ($real:ident) => {
        pub(crate) mod $real {
            use lyapunov::held_input;
            use nalgebra::Matrix3;

            use super::*;

            /// A mass on a spring, moved exactly.
            #[derive(Clone, Copy, Debug)]
            struct Mass {
                period: $real,
                position_gain: [$real; 3],
                velocity_gain: [$real; 3],
                rest: $real,
                position: $real,
                velocity: $real,
            }

            impl Mass {
                fn new() -> Self {
                    // The same sums and roundings that a user of the library meets.
                    let (mass, damping) = (
                        f64::from(OPERATOR_MASS as $real + DEVICE_MASS as $real),
                        f64::from(OPERATOR_DAMPING as $real + DEVICE_DAMPING as $real),
                    );
                    let stiffness = f64::from(OPERATOR_STIFFNESS as $real);
                    let rate = Matrix3::new(
                        0.0,
                        1.0,
                        0.0,
                        -stiffness / mass,
                        -damping / mass,
                        -1.0 / mass,
                        0.0,
                        0.0,
                        0.0,
                    );
                    let gain = held_input(rate * f64::from(PERIOD as $real));
                    let row = |row: usize| [0, 1, 2].map(|column| gain[(row, column)] as $real);
                    Self {
                        period: PERIOD as $real,
                        position_gain: row(0),
                        velocity_gain: row(1),
                        rest: 0.0,
                        position: START as $real,
                        velocity: 0.0,
                    }
                }

                /// How far it moves in a period under `effort`.
                #[inline(always)]
                fn advance(&mut self, effort: $real) -> $real {
                    let gain = |gain: [$real; 3], deflection: $real, velocity: $real| {
                        deflection * gain[0] + velocity * gain[1] + effort * gain[2]
                    };
                    let (before, velocity) = (self.position, self.velocity);
                    let deflection = before - self.rest;
                    self.position = before + gain(self.position_gain, deflection, velocity);
                    self.velocity = velocity + gain(self.velocity_gain, deflection, velocity);
                    self.position - before
                }
            }

            #[derive(Clone, Copy, Debug)]
            struct Wall {
                stiffness: $real,
                damping: $real,
                surface: $real,
            }

            impl Wall {
                fn new() -> Self {
                    Self { stiffness: STIFFNESS as $real, damping: DAMPING as $real, surface: 0.0 }
                }

                #[inline(always)]
                fn force(&self, position: $real, velocity: $real) -> $real {
                    let depth = position - self.surface;
                    let force = self.stiffness * depth + self.damping * velocity;
                    if depth < $real::from_bits(1) || force < 0.0 { 0.0 } else { force }
                }
            }

            /// A wall that is asked on every `ticks`-th tick, with the motion and the work meanwhile, which any
            /// port that may stand there needs.
            #[derive(Clone, Copy, Debug)]
            struct Slow {
                wall: Wall,
                ticks: u32,
                left: u32,
                elapsed: $real,
                moved: $real,
                work: $real,
                force: $real,
            }

            impl Slow {
                fn new() -> Self {
                    let (wall, ticks) = (Wall::new(), HOLD);
                    Self { wall, ticks, left: 0, elapsed: 0.0, moved: 0.0, work: 0.0, force: 0.0 }
                }

                /// Adds up what the wall is not told of.
                #[inline(always)]
                fn book(&mut self, period: $real, moved: $real, work: $real) {
                    self.elapsed += period;
                    self.moved += moved;
                    self.work += work;
                    if self.left == 0 {
                        (self.elapsed, self.moved, self.work) = (-0.0, -0.0, -0.0);
                    }
                }

                #[inline(always)]
                fn force(&mut self, position: $real, velocity: $real) -> $real {
                    if self.left == 0 {
                        self.left = self.ticks;
                        self.force = self.wall.force(position, velocity);
                    }
                    self.left -= 1;
                    self.force
                }
            }

            /// The passivity observer and controller, and what it tells of its last tick.
            #[derive(Clone, Copy, Debug)]
            struct Passivity {
                sum: $real,
                most: $real,
                told: Told,
            }

            #[derive(Clone, Copy, Debug)]
            #[expect(dead_code, reason = "told to whoever looks, and here nobody does")]
            struct Told {
                effort: $real,
                sum: $real,
                alpha: $real,
                shortfall: $real,
                accepted: bool,
            }

            impl Passivity {
                fn new() -> Self {
                    let told =
                        Told { effort: 0.0, sum: 0.0, alpha: 0.0, shortfall: 0.0, accepted: true };
                    Self { sum: 0.0, most: MOST as $real, told }
                }

                #[inline(always)]
                fn correct(&mut self, work: $real, square: $real, velocity: $real, force: $real) {
                    let moving = if square > $real::MIN_POSITIVE { square } else { 0.0 };
                    let most = -self.most * moving;
                    self.sum += work;
                    let sum = self.sum;
                    let debt = if sum < -0.0 { sum } else { -0.0 };
                    let paid = if debt > most { debt } else { most };
                    let divisor = square * -(1.0 - 4.0 * $real::EPSILON);
                    let least = -$real::MIN_POSITIVE;
                    let alpha = paid / if divisor < least { divisor } else { least };
                    let alpha = if alpha < self.most { alpha } else { self.most };
                    let effort = force + velocity * alpha;
                    let accepted = (sum + square + effort).is_finite();
                    self.told = Told { effort, sum, alpha, shortfall: paid - debt, accepted };
                }

                #[inline(always)]
                fn effort(
                    &mut self,
                    period: $real,
                    velocity: $real,
                    work: $real,
                    force: $real,
                ) -> $real {
                    let before = self.sum;
                    self.correct(work, velocity * velocity * period, velocity, force);
                    if !self.told.accepted {
                        let fits = (before + work).is_finite();
                        self.sum = before;
                        self.correct(if fits { work } else { 0.0 }, 0.0, 0.0, 0.0);
                        self.told.accepted = false;
                    }
                    self.told.effort
                }
            }

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
                    let (mut acted, mut moved) = (0.0, 0.0);
                    for position in positions {
                        let velocity = moved / mass.period;
                        let work = acted * moved;
                        wall.book(mass.period, moved, work);
                        let force = wall.force(mass.position, velocity);
                        acted = passivity.effort(mass.period, velocity, work, force);
                        moved = mass.advance(acted);
                        *position = mass.position;
                    }
                }

                /// The same on copies that end with it: what nobody asks for need not be computed.
                #[inline(never)]
                pub(crate) fn roll(&self, positions: &mut [$real]) {
                    let Self { mut mass, mut wall, mut passivity } = *self;
                    let (mut acted, mut moved) = (0.0, 0.0);
                    for position in positions {
                        let velocity = moved / mass.period;
                        let force = wall.force(mass.position, velocity);
                        acted = passivity.effort(mass.period, velocity, acted * moved, force);
                        moved = mass.advance(acted);
                        *position = mass.position;
                    }
                }
            }

            /// A force bound, and what it tells of its last tick.
            #[derive(Clone, Copy, Debug)]
            struct Bound {
                damping: $real,
                energy: $real,
                told: Told,
            }

            impl Bound {
                #[inline(always)]
                fn effort(
                    &mut self,
                    period: $real,
                    moved: $real,
                    work: $real,
                    force: $real,
                ) -> $real {
                    let change = work + self.damping * (moved * moved / period);
                    let booked = (self.energy + change).is_finite();
                    self.energy += if booked { change } else { 0.0 };
                    let sum = self.energy;
                    let share = (4.0 - 64.0 * $real::EPSILON) * self.damping;
                    let most = (share * (if sum > 0.0 { sum } else { 0.0 } / period)).sqrt();
                    let size = (force * force).sqrt();
                    let factor = if size > most { most / size } else { 1.0 };
                    let accepted = booked && (size + most).is_finite() && force.is_finite();
                    let effort = if accepted { force * factor } else { 0.0 };
                    let shortfall = if -sum > 0.0 { -sum } else { 0.0 };
                    self.told = Told { effort, sum, alpha: 0.0, shortfall, accepted };
                    effort
                }
            }

            /// An energy tank, and what it tells of its last tick.
            #[derive(Clone, Copy, Debug)]
            struct Tank {
                energy: $real,
                room: $real,
                power: $real,
                told: Told,
            }

            impl Tank {
                #[inline(always)]
                fn effort(
                    &mut self,
                    period: $real,
                    velocity: $real,
                    work: $real,
                    force: $real,
                ) -> $real {
                    let kept = if self.energy < self.room { self.energy } else { self.room };
                    let booked = (kept + work).is_finite();
                    self.energy = kept + if booked { work } else { 0.0 };
                    let sum = self.energy;
                    let available = if sum > 0.0 { sum } else { 0.0 } / period;
                    let most = if available < self.power { available } else { self.power };
                    let given = -(force * velocity);
                    let factor = if given > most { most / given } else { 1.0 };
                    let accepted = (given + period + work).is_finite() && force.is_finite();
                    let effort = if accepted { force * factor } else { 0.0 };
                    let shortfall = if -sum > 0.0 { -sum } else { 0.0 };
                    self.told = Told { effort, sum, alpha: 0.0, shortfall, accepted };
                    effort
                }
            }

            const NOTHING: Told =
                Told { effort: 0.0, sum: 0.0, alpha: 0.0, shortfall: 0.0, accepted: true };

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
                    let (mut acted, mut moved) = (0.0, 0.0);
                    for position in positions {
                        let force = wall.force(mass.position, moved / mass.period);
                        acted = bound.effort(mass.period, moved, acted * moved, force);
                        moved = mass.advance(acted);
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
                    let (mut acted, mut moved) = (0.0, 0.0);
                    for position in positions {
                        let velocity = moved / mass.period;
                        let force = wall.force(mass.position, velocity);
                        acted = tank.effort(mass.period, velocity, acted * moved, force);
                        moved = mass.advance(acted);
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

            /// The same mass, moved by the classical Runge-Kutta method.
            #[derive(Clone, Copy, Debug)]
            struct Numeric {
                #[expect(dead_code, reason = "what it is made of, for who would change it")]
                parts: [$real; 3],
                rates: [$real; 3],
                period: $real,
                interval: $real,
                steps: u32,
                rest: $real,
                position: $real,
                velocity: $real,
            }

            impl Numeric {
                fn new() -> Self {
                    let mass = OPERATOR_MASS as $real + DEVICE_MASS as $real;
                    let damping = OPERATOR_DAMPING as $real + DEVICE_DAMPING as $real;
                    let stiffness = OPERATOR_STIFFNESS as $real;
                    Self {
                        parts: [mass, damping, stiffness],
                        rates: [-stiffness / mass, -damping / mass, -1.0 / mass],
                        period: PERIOD as $real,
                        interval: PERIOD as $real / STEPS as $real,
                        steps: STEPS,
                        rest: 0.0,
                        position: START as $real,
                        velocity: 0.0,
                    }
                }

                /// How far it moves in a period under `effort`.
                #[inline(always)]
                fn advance(&mut self, effort: $real) -> $real {
                    let before = self.position;
                    let [k, b, f] = self.rates;
                    let acceleration = |x: $real, v: $real| x * k + v * b + effort * f;
                    let (step, half) = (self.interval, self.interval * 0.5);
                    let sixth = step * (1.0 / 6.0);
                    for _ in 0..self.steps {
                        let (x, v) = (self.position - self.rest, self.velocity);
                        let a1 = acceleration(x, v);
                        let v2 = v + a1 * half;
                        let a2 = acceleration(x + v * half, v2);
                        let v3 = v + a2 * half;
                        let a3 = acceleration(x + v2 * half, v3);
                        let v4 = v + a3 * step;
                        let a4 = acceleration(x + v3 * step, v4);
                        let inner = a2 + a3;
                        self.position += (v + (a1 + inner) * sixth) * step;
                        self.velocity += (a1 + inner + inner + a4) * sixth;
                    }
                    self.position - before
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
        }
    };
}

hand!(f32);
hand!(f64);
