//! Hardening spring, against Duffing's closed forms.

use core::f64::consts::PI;

use lyapunov::{
    OnePort, PortSample, Scalar,
    environments::{CubicSpring, ForceLaw, Kinematics, Spring},
};
use nalgebra::Vector2;

use super::closure::{closes, slopes, swing};

/// The complete elliptic integral of the first kind, by Gauss's arithmetic-geometric mean.
fn elliptic(parameter: f64) -> f64 {
    let (mut one, mut other) = (1.0, (1.0 - parameter).sqrt());
    for _ in 0..8 {
        (one, other) = (0.5 * (one + other), (one * other).sqrt());
    }
    PI / (2.0 * one)
}

/// The time from one standstill, at `from`, to the next, of `mass` kg on `spring`, by the fourth-order Runge-Kutta
/// method.
fn half_swing(spring: &CubicSpring<f64>, mass: f64, from: f64) -> f64 {
    let slope = |[x, v]: [f64; 2]| [v, -spring.force(&Kinematics::at(x, v)) / mass];
    let ahead = |[x, v]: [f64; 2], [dx, dv]: [f64; 2], dt: f64| [x + dt * dx, v + dt * dv];
    let (mut now, mut time, dt) = ([from, 0.0], 0.0, 1e-5);
    loop {
        let a = slope(now);
        let b = slope(ahead(now, a, dt / 2.0));
        let c = slope(ahead(now, b, dt / 2.0));
        let d = slope(ahead(now, c, dt));
        let mean = std::array::from_fn(|i| (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0);
        let next = ahead(now, mean, dt);
        if time > 0.0 && now[1] < 0.0 && next[1] >= 0.0 {
            return time + dt * now[1] / (now[1] - next[1]);
        }
        (now, time) = (next, time + dt);
    }
}

/// `4 K(m) / √((k + c A²) / mass)` with `m = c A² / (2 (k + c A²))`: the exact period of Duffing's equation without a
/// damper.
#[test]
fn a_mass_on_it_has_duffings_period() {
    let mass = 0.3;
    for (stiffness, cubic, size) in
        [(200.0, 1e6, 0.001), (200.0, 1e6, 0.025), (50.0, 3e6, 0.04), (0.0, 1e6, 0.02)]
    {
        let spring = CubicSpring::new(stiffness, cubic).expect("a spring");
        let hard = cubic * size * size;
        let parameter = hard / (2.0 * (stiffness + hard));
        let period = 4.0 * elliptic(parameter) / ((stiffness + hard) / mass).sqrt();
        let found = 2.0 * half_swing(&spring, mass, size);
        assert!((found / period - 1.0).abs() < 1e-7, "{found} for {period}");
    }
}

#[test]
fn it_stores_what_it_takes() {
    let spring = CubicSpring::new(300.0, 2e6).expect("a spring").at(0.012);
    closes(&spring, swing, |_| 0.0);
    slopes(&spring);
    // On two axes it pulls to its rest, and a circle about the rest takes no work.
    let spring = CubicSpring::new(300.0, 2e6).expect("a spring").at(Vector2::new(0.01, 0.0));
    closes(
        &spring,
        |t| {
            let (sine, cosine) = (7.0 * t).sin_cos();
            let position = Vector2::new(0.03 * sine, 0.01 - 0.02 * cosine);
            Kinematics::at(position, Vector2::new(0.21 * cosine, 0.14 * sine))
        },
        |_| 0.0,
    );
}

fn is_a_spring_without_the_cube<T: Scalar>() {
    let (stiffness, position) = (T::of(410.7), T::of(0.0003));
    let mut cubic = CubicSpring::<T>::new(stiffness, T::zero()).expect("a spring").at(position);
    let mut spring = Spring::<T>::new(stiffness).expect("a spring").at(position);
    for n in -50..50 {
        let sample = PortSample::starting(T::of(1e-3), T::of(0.7e-3 * f64::from(n)), T::of(0.1));
        assert_eq!(cubic.respond(&sample), spring.respond(&sample));
    }
}

#[test]
fn without_the_cube_it_is_a_spring_to_the_last_bit() {
    is_a_spring_without_the_cube::<f32>();
    is_a_spring_without_the_cube::<f64>();
}
