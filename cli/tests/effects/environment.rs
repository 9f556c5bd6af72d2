//! Environments of the reference.

use std::f64::consts::TAU;

use crate::effects::scene::{Axes, Environment};

pub(crate) fn dot(a: Axes, b: Axes) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| a * b).sum()
}

fn along_x(value: f64) -> Axes {
    [value, 0.0, 0.0]
}

fn minus(a: Axes, b: Axes) -> Axes {
    std::array::from_fn(|axis| a[axis] - b[axis])
}

impl Environment {
    /// The effort at time `t`; `acceleration` is that of the environment's own ticks.
    pub(crate) fn effort(&self, t: f64, x: Axes, v: Axes, acceleration: f64) -> Axes {
        match *self {
            Self::Wall { position, stiffness, damping } => {
                along_x(one_sided(x[0] - position, |p| stiffness * p + damping * v[0]))
            }
            Self::Spring { position, stiffness } => along_x(stiffness * (x[0] - position)),
            Self::MassSpringDamper { position, mass, damping, stiffness } => {
                along_x(mass * acceleration + damping * v[0] + stiffness * (x[0] - position))
            }
            Self::LayeredWall { position, depth, stiffness: [upper, lower], damping } => {
                along_x(one_sided(x[0] - position, |p| {
                    upper * p.min(depth) + lower * (p - depth).max(0.0) + damping * v[0]
                }))
            }
            Self::HuntCrossley { position, stiffness, exponent, damping } => {
                along_x(one_sided(x[0] - position, |p| {
                    stiffness * p.powf(exponent) * (1.0 + damping * v[0])
                }))
            }
            Self::MovingWall { stiffness, damping, .. } => {
                let (surface, speed) = self.surface(t);
                along_x(one_sided(x[0] - surface, |p| stiffness * p + damping * (v[0] - speed)))
            }
            Self::VaryingSpring { position, stiffness, amplitude, frequency } => {
                let now = stiffness + amplitude * (TAU * frequency * t).sin();
                along_x(now * (x[0] - position))
            }
            Self::CubicSpring { position, stiffness, cubic } => {
                let away = x[0] - position;
                along_x(stiffness * away + cubic * away.powi(3))
            }
            Self::Plane { stiffness, damping, .. }
            | Self::Sphere { stiffness, damping, .. }
            | Self::Cuboid { stiffness, damping, .. } => {
                let (depth, normal) = self.nearest(x);
                let push = one_sided(depth, |p| stiffness * p - damping * dot(v, normal));
                normal.map(|axis| -push * axis)
            }
        }
    }

    /// Energy that the environment's own damper dissipates in `period` at `v`.
    pub(crate) fn credit(&self, t: f64, x: Axes, v: Axes, period: f64) -> f64 {
        let touching = |p: f64, power: f64| if p > 0.0 { power * period } else { 0.0 };
        match *self {
            Self::Wall { position, damping, .. } | Self::LayeredWall { position, damping, .. } => {
                touching(x[0] - position, damping * v[0] * v[0])
            }
            Self::Spring { .. } | Self::VaryingSpring { .. } | Self::CubicSpring { .. } => 0.0,
            Self::MassSpringDamper { damping, .. } => damping.max(0.0) * v[0] * v[0] * period,
            Self::HuntCrossley { position, stiffness, exponent, damping } => {
                let p = x[0] - position;
                touching(p, stiffness * p.powf(exponent) * damping * v[0] * v[0])
            }
            Self::MovingWall { damping, .. } => {
                let (surface, speed) = self.surface(t);
                touching(x[0] - surface, damping * (v[0] - speed).powi(2))
            }
            Self::Plane { damping, .. }
            | Self::Sphere { damping, .. }
            | Self::Cuboid { damping, .. } => {
                let (depth, normal) = self.nearest(x);
                touching(depth, damping * dot(v, normal).powi(2))
            }
        }
    }

    /// Position and velocity of a moving wall.
    fn surface(&self, t: f64) -> (f64, f64) {
        let Self::MovingWall { position, amplitude, frequency, .. } = *self else {
            panic!("only one wall moves");
        };
        let (sine, cosine) = (TAU * frequency * t).sin_cos();
        (position + amplitude * sine, TAU * frequency * amplitude * cosine)
    }

    /// Depth and outward normal of a solid.
    fn nearest(&self, x: Axes) -> (f64, Axes) {
        match *self {
            Self::Plane { point, normal, .. } => {
                let length = dot(normal, normal).sqrt();
                let normal = normal.map(|axis| axis / length);
                (dot(minus(point, x), normal), normal)
            }
            Self::Sphere { center, radius, .. } => {
                let from = minus(x, center);
                let distance = dot(from, from).sqrt();
                (radius - distance, from.map(|axis| axis / distance))
            }
            Self::Cuboid { center, half, .. } => {
                let from = minus(x, center);
                let depth = |axis: usize| half[axis] - from[axis].abs();
                let axes = (0..3).filter(|&axis| half[axis].is_finite());
                let least = axes.min_by(|&a, &b| depth(a).total_cmp(&depth(b))).expect("an axis");
                let mut normal = [0.0; 3];
                normal[least] = 1.0_f64.copysign(from[least]);
                (depth(least), normal)
            }
            _ => panic!("no solid"),
        }
    }
}

fn one_sided(depth: f64, force: impl Fn(f64) -> f64) -> f64 {
    if depth > 0.0 { force(depth).max(0.0) } else { 0.0 }
}
