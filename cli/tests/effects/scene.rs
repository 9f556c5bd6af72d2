//! Scene of the effect tests as plain numbers.

pub(crate) type Axes = [f64; 3];

#[derive(Clone, Debug)]
pub(crate) enum Motion {
    Step { at: f64, to: f64 },
    Ramp { at: f64, to: f64, rate: f64 },
    Sine { amplitude: f64, frequency: f64 },
    File { rows: Vec<(f64, f64)> },
}

/// Environment; the position comes first where there is one, then stiffness and damping.
#[derive(Clone, Debug)]
pub(crate) enum Environment {
    Wall { position: f64, stiffness: f64, damping: f64 },
    Spring { position: f64, stiffness: f64 },
    MassSpringDamper { position: f64, mass: f64, damping: f64, stiffness: f64 },
    LayeredWall { position: f64, depth: f64, stiffness: [f64; 2], damping: f64 },
    HuntCrossley { position: f64, stiffness: f64, exponent: f64, damping: f64 },
    MovingWall { position: f64, stiffness: f64, damping: f64, amplitude: f64, frequency: f64 },
    VaryingSpring { position: f64, stiffness: f64, amplitude: f64, frequency: f64 },
    CubicSpring { position: f64, stiffness: f64, cubic: f64 },
    Plane { point: Axes, normal: Axes, stiffness: f64, damping: f64 },
    Sphere { center: Axes, radius: f64, stiffness: f64, damping: f64 },
    Cuboid { center: Axes, half: Axes, stiffness: f64, damping: f64 },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Popc,
    MassSpringDamper,
    DeviceDamping,
    Spring,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Stabilizer {
    pub(crate) kind: Kind,
    pub(crate) sampled: bool,
    pub(crate) cap: f64,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum Filter {
    Cutoff(f64),
    Window(usize),
}

/// Size and seed of a random effect.
pub(crate) type Chance = (f64, u64);

#[derive(Clone, Copy, Debug)]
pub(crate) struct Dropout {
    pub(crate) probability: f64,
    pub(crate) seed: u64,
    pub(crate) zero: bool,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Friction {
    pub(crate) coulomb: f64,
    pub(crate) breakaway: f64,
    pub(crate) stribeck_velocity: f64,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Pulse {
    pub(crate) start: f64,
    pub(crate) duration: f64,
    pub(crate) force: f64,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Operator {
    pub(crate) mass: f64,
    pub(crate) damping: f64,
    pub(crate) stiffness: f64,
    pub(crate) rest: Axes,
}

#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub(crate) duration: f64,
    pub(crate) servo_rate: f64,
    /// Servo ticks per environment tick.
    pub(crate) hold: usize,
    pub(crate) exact: bool,
    pub(crate) single: bool,
    pub(crate) dimensions: usize,
    pub(crate) operator: Operator,
    pub(crate) motion: Option<Motion>,
    /// Time, stiffness and damping of each change.
    pub(crate) grip: Option<Vec<[f64; 3]>>,
    /// Mass and damping.
    pub(crate) device: [f64; 2],
    /// Stiffness and damping.
    pub(crate) link: Option<[f64; 2]>,
    pub(crate) position: Axes,
    pub(crate) velocity: Axes,
    pub(crate) environment: Environment,
    pub(crate) stabilizer: Option<Stabilizer>,
    pub(crate) encoder: Option<f64>,
    pub(crate) delay: usize,
    pub(crate) saturation: Option<f64>,
    pub(crate) filter: Option<Filter>,
    pub(crate) noise: Option<Chance>,
    pub(crate) jitter: Option<Chance>,
    pub(crate) dropout: Option<Dropout>,
    pub(crate) friction: Option<Friction>,
    pub(crate) load: Option<f64>,
    pub(crate) pulse: Option<Pulse>,
}

impl Scene {
    /// A hand on a wall that is soft enough for a sampled loop.
    pub(crate) fn calm() -> Self {
        Self {
            duration: 1.0,
            servo_rate: 500.0,
            hold: 1,
            exact: false,
            single: false,
            dimensions: 1,
            operator: Operator {
                mass: 0.1,
                damping: 2.0,
                stiffness: 80.0,
                rest: [0.002, 0.0, 0.0],
            },
            motion: None,
            grip: None,
            device: [0.2, 0.3],
            link: None,
            position: [-0.004, 0.0, 0.0],
            velocity: [0.05, 0.0, 0.0],
            environment: Environment::Wall { position: 0.001, stiffness: 300.0, damping: 1.0 },
            stabilizer: None,
            encoder: None,
            delay: 0,
            saturation: None,
            filter: None,
            noise: None,
            jitter: None,
            dropout: None,
            friction: None,
            load: None,
            pulse: None,
        }
    }

    pub(crate) fn with(mut self, kind: Kind, sampled: bool, cap: f64) -> Self {
        self.stabilizer = Some(Stabilizer { kind, sampled, cap });
        self
    }

    pub(crate) fn touching(mut self, environment: Environment) -> Self {
        self.environment = environment;
        self
    }

    pub(crate) fn ticks(&self) -> usize {
        (self.duration * self.servo_rate).round() as usize
    }

    pub(crate) fn period(&self) -> f64 {
        1.0 / self.servo_rate
    }

    /// The first tick at or after an instant, up to a billionth of a tick.
    pub(crate) fn tick_of(&self, instant: f64) -> usize {
        (instant * self.servo_rate - 1e-9).ceil().max(0.0) as usize
    }

    pub(crate) fn columns(&self) -> Vec<String> {
        let first = "t,x,x_measured,v,f_env,f_ctl,f_out,f_act,observer,alpha,shortfall,accepted";
        let mut columns: Vec<String> = first.split(',').map(str::to_owned).collect();
        let axes = &["x", "y", "z"][..self.dimensions];
        for axis in &axes[1..] {
            columns.push((*axis).to_owned());
            for name in ["measured", "v", "f_env", "f_ctl", "f_out", "f_act"] {
                columns.push(format!("{axis}_{name}"));
            }
        }
        if self.link.is_some() {
            for axis in axes {
                columns.extend([format!("{axis}_operator"), format!("{axis}_v_operator")]);
            }
        }
        columns
    }
}
