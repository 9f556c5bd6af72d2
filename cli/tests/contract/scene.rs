//! Scene of the contract tests as plain numbers.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scalar {
    F64,
    F32,
}

impl Scalar {
    pub(crate) fn epsilon(self) -> f64 {
        match self {
            Self::F64 => f64::EPSILON,
            Self::F32 => f64::from(f32::EPSILON),
        }
    }

    pub(crate) fn tiny(self) -> f64 {
        match self {
            Self::F64 => f64::MIN_POSITIVE,
            Self::F32 => f64::from(f32::MIN_POSITIVE),
        }
    }

    pub(crate) fn largest(self) -> f64 {
        match self {
            Self::F64 => f64::MAX,
            Self::F32 => f64::from(f32::MAX),
        }
    }

    pub(crate) fn round(self, value: f64) -> f64 {
        match self {
            Self::F64 => value,
            Self::F32 => f64::from(value as f32),
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Velocity {
    Exact,
    BackwardDifference,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Work {
    Held,
    Sampled,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Popc,
    MassSpringDamper,
    DeviceDamping,
    Spring,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stabilizer {
    pub(crate) kind: Kind,
    pub(crate) work: Work,
    pub(crate) cap: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Operator {
    pub(crate) mass: f64,
    pub(crate) damping: f64,
    pub(crate) stiffness: f64,
    pub(crate) rest: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Device {
    pub(crate) mass: f64,
    pub(crate) damping: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Initial {
    pub(crate) position: f64,
    pub(crate) velocity: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Wall {
    pub(crate) position: f64,
    pub(crate) stiffness: f64,
    pub(crate) damping: f64,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Scene {
    pub(crate) duration: f64,
    pub(crate) servo_rate: f64,
    /// Servo ticks per environment tick.
    pub(crate) hold: usize,
    pub(crate) velocity: Velocity,
    pub(crate) scalar: Scalar,
    pub(crate) operator: Operator,
    pub(crate) device: Device,
    pub(crate) initial: Initial,
    pub(crate) wall: Wall,
    pub(crate) stabilizer: Option<Stabilizer>,
    pub(crate) encoder: Option<f64>,
    pub(crate) delay: usize,
    pub(crate) saturation: Option<f64>,
    /// The file leaves defaults out and writes whole numbers as integers.
    pub(crate) terse: bool,
}

pub(crate) const SOFT: Wall = Wall { position: 0.0, stiffness: 8e3, damping: 2.0 };
pub(crate) const STIFF: Wall = Wall { position: 0.0, stiffness: 50e3, damping: 20.0 };

impl Scene {
    /// The paper's loop at 100 Hz, without a stabilizer.
    pub(crate) fn paper(wall: Wall) -> Self {
        Self {
            duration: 10.0,
            servo_rate: 100.0,
            hold: 1,
            velocity: Velocity::BackwardDifference,
            scalar: Scalar::F64,
            operator: Operator { mass: 0.1, damping: 0.2, stiffness: 50.0, rest: 0.0 },
            device: Device { mass: 0.2, damping: 0.001 },
            initial: Initial { position: -0.004, velocity: 0.0 },
            wall,
            stabilizer: None,
            encoder: None,
            delay: 0,
            saturation: None,
            terse: false,
        }
    }

    pub(crate) fn with(mut self, kind: Kind, work: Work, cap: f64) -> Self {
        self.stabilizer = Some(Stabilizer { kind, work, cap });
        self
    }

    pub(crate) fn lasting(mut self, duration: f64) -> Self {
        self.duration = duration;
        self
    }

    pub(crate) fn at(mut self, servo_rate: f64, hold: usize) -> Self {
        self.servo_rate = servo_rate;
        self.hold = hold;
        self
    }

    pub(crate) fn ticks(&self) -> usize {
        (self.duration * self.servo_rate).round() as usize
    }

    /// The damping cap where none is written: half of m / T, and less the later the force acts.
    pub(crate) fn default_cap(&self) -> f64 {
        match self.delay {
            0 => 0.5,
            ticks => 0.5 * (std::f64::consts::PI / (4.0 * (ticks as f64 + 1.0))).tan(),
        }
    }

    pub(crate) fn mass(&self) -> f64 {
        self.operator.mass + self.device.mass
    }

    /// The scene with every number as the scalar holds it: a position's last bit decides its side of a surface.
    pub(crate) fn in_scalar(&self) -> Self {
        let mut scene = self.clone();
        let numbers = [
            &mut scene.operator.mass,
            &mut scene.operator.damping,
            &mut scene.operator.stiffness,
            &mut scene.operator.rest,
            &mut scene.device.mass,
            &mut scene.device.damping,
            &mut scene.initial.position,
            &mut scene.initial.velocity,
            &mut scene.wall.position,
            &mut scene.wall.stiffness,
            &mut scene.wall.damping,
        ];
        let effects = [&mut scene.encoder, &mut scene.saturation];
        let cap = scene.stabilizer.iter_mut().map(|s| &mut s.cap);
        for number in numbers.into_iter().chain(effects.into_iter().flatten()).chain(cap) {
            *number = self.scalar.round(*number);
        }
        scene
    }
}
