//! Walls by hand, called on every tick or on some.

macro_rules! walls {
    ($real:ident) => {
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

        /// A wall that is called on every `ticks`-th tick, with the motion and the work of the ticks between, which
        /// any port in its place needs.
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

            /// Sums the samples between two calls of the wall.
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
    };
}

pub(crate) use walls;
