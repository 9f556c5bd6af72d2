//! Stabilizers by hand, each with its last correction.

macro_rules! stabilizers {
    ($real:ident) => {
        /// The passivity observer/controller, and its last correction.
        #[derive(Clone, Copy, Debug)]
        struct Passivity {
            sum: $real,
            most: $real,
            told: Told,
        }

        #[derive(Clone, Copy, Debug)]
        #[expect(dead_code, reason = "part of a correction, unused here")]
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
                let least = $real::MIN_POSITIVE;
                let most = if square > least { self.most } else { 0.0 };
                let divisor = square * (1.0 - 4.0 * $real::EPSILON);
                let inverse = -1.0 / if divisor > least { divisor } else { least };
                self.sum += work;
                let sum = self.sum;
                let alpha = sum * inverse;
                let alpha = if alpha < most { alpha } else { most };
                let alpha = if alpha > 0.0 { alpha } else { 0.0 };
                let served = sum + alpha * square;
                let effort = force + velocity * alpha;
                let accepted = (served + effort).is_finite();
                let shortfall = 0.0 - if served < 0.0 { served } else { 0.0 };
                self.told = Told { effort, sum, alpha, shortfall, accepted };
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
                self.told.accepted &= period > 0.0;
                if !self.told.accepted {
                    let fits = (before + work).is_finite();
                    self.sum = before;
                    self.correct(if fits { work } else { 0.0 }, 0.0, 0.0, 0.0);
                    self.told.accepted = false;
                }
                self.told.effort
            }
        }

        /// A force bound, and its last correction.
        #[derive(Clone, Copy, Debug)]
        struct Bound {
            damping: $real,
            energy: $real,
            told: Told,
        }

        impl Bound {
            #[inline(always)]
            fn effort(&mut self, period: $real, moved: $real, work: $real, force: $real) -> $real {
                let change = work + self.damping * (moved * moved / period);
                let timed = period > 0.0 && period.is_finite();
                let change = if timed { change } else { $real::NAN };
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

        /// An energy tank, and its last correction.
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
                let booked = (self.energy + work).is_finite();
                let filled = self.energy + if booked { work } else { 0.0 };
                self.energy = if filled < self.room { filled } else { self.room };
                let sum = self.energy;
                let kept = 1.0 - 4.0 * <$real>::EPSILON;
                let available = if sum > 0.0 { sum } else { 0.0 } * kept / period;
                let most = if available < self.power { available } else { self.power };
                let given = -(force * velocity);
                let factor = if given > most { most / given } else { 1.0 };
                let timed = period > 0.0;
                let sound = (given + period + work).is_finite() && force.is_finite();
                let accepted = booked && sound && timed;
                let effort = if accepted { force * factor } else { 0.0 };
                let shortfall = if -sum > 0.0 { -sum } else { 0.0 };
                self.told = Told { effort, sum, alpha: 0.0, shortfall, accepted };
                effort
            }
        }

        const NOTHING: Told =
            Told { effort: 0.0, sum: 0.0, alpha: 0.0, shortfall: 0.0, accepted: true };
    };
}

pub(crate) use stabilizers;
