//! Operator and device joined by a spring and a damper, made for the tests.

use nalgebra::{Matrix4, Matrix5, SMatrix};

use lyapunov::{
    HeldTick, ParameterError, Plant, PortSample, Scalar,
    bodies::{Impedance, Linear, OperatedBody, held_input},
};

/// Operator, link (without mass) and device.
pub(crate) type Parts = [Impedance<f64>; 3];

#[derive(Clone, Copy, Debug)]
pub(crate) struct TwoMasses {
    pub(crate) parts: Parts,
    pub(crate) period: f64,
    pub(crate) rest: f64,
    pub(crate) state: [f64; 4],
}

impl TwoMasses {
    /// Kinetic and spring energy, J.
    pub(crate) fn energy(&self) -> f64 {
        let [operator, link, device] = self.parts;
        let [x1, v1, x2, v2] = self.state;
        let spring = |k: f64, x: f64| 0.5 * k * x * x;
        spring(operator.stiffness, x1 - self.rest)
            + spring(link.stiffness, x1 - x2)
            + spring(operator.mass, v1)
            + spring(device.mass, v2)
    }
}

impl Plant<f64> for TwoMasses {
    fn start(&self) -> PortSample<f64> {
        PortSample::starting(self.period, self.state[2], self.state[3])
    }

    fn advance(&mut self, effort: f64) -> PortSample<f64> {
        let mut generator = Matrix5::zeros();
        generator.fixed_view_mut::<4, 4>(0, 0).copy_from(&Self::rate(&self.parts, |number| number));
        generator[(3, 4)] = -1.0 / self.parts[2].mass;
        let increment = held_input(generator * self.period);
        let [x1, v1, x2, v2] = self.state;
        let by = [x1 - self.rest, v1, x2 - self.rest, v2, effort];
        for (row, value) in self.state.iter_mut().enumerate() {
            *value += (0..5).map(|column| increment[(row, column)] * by[column]).sum::<f64>();
        }
        HeldTick {
            period: self.period,
            position: self.state[2],
            velocity: self.state[3],
            displacement: self.state[2] - x2,
            applied: effort,
        }
        .sample()
    }
}

impl OperatedBody<f64> for TwoMasses {
    type Parts = Parts;

    fn rest_at(&mut self, rest: f64) {
        self.rest = rest;
    }

    fn reshape(&mut self, parts: Parts, interval: f64) -> Result<(), ParameterError> {
        (self.parts, self.period) = (parts, interval);
        Ok(())
    }
}

impl Linear<f64, 4> for TwoMasses {
    fn rate<R: Scalar>(parts: &Parts, number: impl Fn(f64) -> R) -> SMatrix<R, 4, 4> {
        let [operator, link, device] = parts;
        let (k, b) = (link.stiffness, link.damping);
        let (m1, m2) = (operator.mass, device.mass);
        #[rustfmt::skip]
        let rate = Matrix4::new(
            0.0, 1.0, 0.0, 0.0,
            -(operator.stiffness + k) / m1, -(operator.damping + b) / m1, k / m1, b / m1,
            0.0, 0.0, 0.0, 1.0,
            k / m2, b / m2, -k / m2, -(device.damping + b) / m2,
        );
        rate.map(number)
    }

    fn device_mass(parts: &Parts) -> f64 {
        parts[2].mass
    }

    fn rest(&self) -> f64 {
        self.rest
    }

    fn state(&self) -> [f64; 4] {
        self.state
    }

    fn place(&mut self, of: bool, state: [f64; 4]) {
        if of {
            self.state = state;
        }
    }
}
