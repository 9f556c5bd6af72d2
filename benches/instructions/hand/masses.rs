//! Masses by hand, moved exactly or by steps.

macro_rules! masses {
    ($real:ident) => {
        /// Mass on a spring, moved exactly.
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
                // The same sums and roundings as for a user of the library.
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

            /// The displacement over a period under `effort`.
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

            /// The displacement over a period under `effort`.
            #[inline(always)]
            fn advance(&mut self, effort: $real) -> $real {
                let (before, start) = (self.position, self.velocity);
                let [k, b, f] = self.rates;
                let acceleration = |x: $real, v: $real| x * k + v * b + effort * f;
                let (step, half) = (self.interval, self.interval * 0.5);
                let sixth = step * (1.0 / 6.0);
                // Summed apart, since each gain of many short steps would be rounded to the size of the state.
                let (mut moved, mut gained) = (0.0, 0.0);
                for _ in 0..self.steps {
                    let (x, v) = (before + moved - self.rest, start + gained);
                    let a1 = acceleration(x, v);
                    let v2 = v + a1 * half;
                    let a2 = acceleration(x + v * half, v2);
                    let v3 = v + a2 * half;
                    let a3 = acceleration(x + v2 * half, v3);
                    let v4 = v + a3 * step;
                    let a4 = acceleration(x + v3 * step, v4);
                    let inner = a2 + a3;
                    moved += (v + (a1 + inner) * sixth) * step;
                    gained += (a1 + inner + inner + a4) * sixth;
                }
                (self.position, self.velocity) = (before + moved, start + gained);
                self.position - before
            }
        }
    };
}

pub(crate) use masses;
