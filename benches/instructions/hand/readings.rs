//! A loop of one's own by hand, with the memory of a port: first tick, gaps, jumps.

macro_rules! readings {
    ($real:ident) => {
        /// What is remembered from reading to reading.
        #[derive(Clone, Copy, Debug)]
        struct Memory {
            period: $real,
            fastest: $real,
            known: bool,
            position: $real,
            gap: $real,
            least: $real,
            most: $real,
        }

        /// A sample of the port: period, position, velocity, work.
        struct Sample([$real; 4]);

        impl Memory {
            #[inline(always)]
            fn hear(&mut self, position: $real, effort: $real) -> Sample {
                let applied = if effort.is_finite() { effort } else { self.least };
                let open = self.gap > 0.0;
                let lower = if self.least < applied { self.least } else { applied };
                let upper = if self.most > applied { self.most } else { applied };
                let least = if open { lower } else { applied };
                let most = if open { upper } else { applied };
                let span = self.gap + self.period;
                let late = span > 1.5 * self.period;
                let moved = if self.known { position - self.position } else { 0.0 };
                let reach = self.fastest * if span > self.period { span } else { self.period };
                let far = moved * moved > reach * reach;
                let (one, other) = (least * moved, most * moved);
                let work = if one < other { one } else { other };
                let near = moved.is_finite() && !far;
                let sound = position.is_finite() & effort.is_finite() & near & work.is_finite();
                self.known |= sound;
                self.gap = if sound | !self.known { 0.0 } else { span };
                self.least = if sound { applied } else { least };
                self.most = if sound { applied } else { most };
                self.position = if sound { position } else { self.position };
                let mean = moved / span;
                let mean = if late | mean.is_finite() { mean } else { 0.0 };
                let velocity = if sound { mean } else { 0.0 };
                let period = if sound { span } else { self.period };
                let work = if sound { work } else { $real::NAN };
                Sample([period, self.position, velocity, work])
            }
        }

        /// A wall behind the stabilizer, which is told readings.
        #[derive(Clone, Copy, Debug)]
        pub(crate) struct Own {
            mass: Mass,
            memory: Memory,
            wall: Wall,
            passivity: Passivity,
        }

        impl Own {
            pub(crate) fn new() -> Self {
                let memory = Memory {
                    period: PERIOD as $real,
                    fastest: FASTEST as $real,
                    known: false,
                    position: 0.0,
                    gap: 0.0,
                    least: 0.0,
                    most: 0.0,
                };
                Self { mass: Mass::new(), memory, wall: Wall::new(), passivity: Passivity::new() }
            }

            #[inline(never)]
            pub(crate) fn run(&mut self, positions: &mut [$real]) {
                let Self { mass, memory, wall, passivity } = self;
                let mut applied = 0.0;
                for position in positions {
                    let Sample([period, place, velocity, work]) =
                        memory.hear(mass.position, applied);
                    let force = wall.force(place, velocity);
                    applied = passivity.effort(period, velocity, work, force);
                    mass.advance(applied);
                    *position = mass.position;
                }
            }
        }
    };
}

pub(crate) use readings;
