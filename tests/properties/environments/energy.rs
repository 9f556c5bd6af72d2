//! Stored energy of environments, which comes back, and known dissipation of their dampers.

use std::f64::consts::{FRAC_PI_2, TAU};

use approx::abs_diff_eq;
use lyapunov::{
    OnePort, PortSample, Signal,
    environments::{
        Contact, Cuboid, HuntCrossley, LayeredWall, Plane, Solid, Sphere, Spring, VaryingSpring,
    },
};
use nalgebra::{Vector2, Vector3};

/// The effort at a place, at rest.
fn at<V: Signal<Scalar = f64>>(port: &mut impl OnePort<V>, place: V) -> V {
    port.respond(&PortSample::starting(1e-3, place, V::zero()))
}

/// The work `∫ f dx` along a straight path, by the midpoints of `steps` pieces.
fn work(port: &mut impl OnePort<f64>, from: f64, to: f64, steps: u32) -> f64 {
    let step = (to - from) / f64::from(steps);
    (0..steps).map(|n| at(port, from + (f64::from(n) + 0.5) * step) * step).sum()
}

/// `k₁ p² / 2` within the first layer; beyond it the end of that layer, its force times the rest of the depth, and
/// `k₂ / 2` times the square of the rest.
#[test]
fn a_layered_wall_stores_the_area_under_its_force() {
    for (k1, k2) in [(100.0, 5000.0), (5000.0, 100.0), (0.0, 800.0)] {
        let mut wall = LayeredWall::new(0.02, [k1, k2], 0.0).expect("a wall").at(0.1);
        for to in [0.09, 0.11, 0.12, 0.15] {
            let depth = f64::max(0.0, to - 0.1);
            let (soft, hard) = (depth.min(0.02), f64::max(0.0, depth - 0.02));
            let stored = 0.5 * k1 * soft * soft + k1 * soft * hard + 0.5 * k2 * hard * hard;
            let found = work(&mut wall, 0.0, to, 40_000);
            assert!(
                abs_diff_eq!(found, stored, epsilon = 1e-6 * (1e-3 + stored)),
                "{found} for {stored}"
            );
            let back = work(&mut wall, to, 0.0, 25_000);
            assert!(
                abs_diff_eq!(found, -back, epsilon = 1e-6 * (1e-3 + stored)),
                "{back} of {found}"
            );
        }
    }
}

/// Stored energy `k p^(e+1) / (e+1)`.
#[test]
fn a_hunt_crossley_contact_stores_what_its_power_law_says() {
    for exponent in [0.5, 1.0, 1.5, 3.0] {
        let mut contact = HuntCrossley::new(2000.0, exponent, 0.0).expect("a contact").at(-0.1);
        let stored = 2000.0 * f64::powf(0.05, exponent + 1.0) / (exponent + 1.0);
        let found = work(&mut contact, -0.15, -0.05, 40_000);
        assert!(abs_diff_eq!(found, stored, epsilon = 2e-6 * stored), "{found} for {stored}");
    }
}

/// A free mass that strikes at `u` leaves at `w` with `d u − ln(1 + d u) = −d w − ln(1 − d w)`: both sides are the
/// integral of `v dv / (1 + d v)` to standstill, the energy that the spring takes and gives. To first order this is the
/// `1 − 2/3 d u` of Hunt and Crossley.
#[test]
fn a_hunt_crossley_contact_restores_what_was_published() {
    let (mass, stiffness, exponent, damping) = (0.4, 3000.0, 1.5, 0.3);
    let contact = HuntCrossley::new(stiffness, exponent, damping).expect("a contact");
    for speed in [0.05, 0.5, 2.0] {
        let slope = |[x, v]: [f64; 2]| {
            let force: f64 = { contact }.respond(&PortSample::starting(1e-3, x, v));
            [v, -force / mass]
        };
        let ahead = |[x, v]: [f64; 2], [dx, dv]: [f64; 2], dt: f64| [x + dt * dx, v + dt * dv];
        let (mut now, dt) = ([0.0, speed], 2e-6);
        while now[0] > 0.0 || now[1] > 0.0 {
            let a = slope(now);
            let b = slope(ahead(now, a, dt / 2.0));
            let c = slope(ahead(now, b, dt / 2.0));
            let d = slope(ahead(now, c, dt));
            let mean = std::array::from_fn(|i| (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0);
            now = ahead(now, mean, dt);
        }
        let (into, out) = (damping * speed, damping * -now[1]);
        let taken = into - into.ln_1p();
        let given = -out - (-out).ln_1p();
        assert!(
            abs_diff_eq!(taken, given, epsilon = 1e-6 * taken),
            "{taken} in, {given} out at {speed} m/s"
        );
        let restitution = out / into;
        assert!(
            abs_diff_eq!(restitution, 1.0 - 2.0 / 3.0 * into, epsilon = into * into),
            "{restitution}"
        );
    }
}

/// Moved by `x = X sin(ω t + ψ)` while its stiffness oscillates by `a sin 2ω t`, a varying spring takes
/// `∮ a sin 2ω t d(x² / 2) = π/2 a X² cos 2ψ` a turn, and gives it where that is below 0.
#[test]
fn a_varying_spring_is_active() {
    const CALLS: u32 = 20_000;
    let (stiffness, amplitude, size) = (200.0, 80.0, 0.03);
    for shift in [0.0, 0.4, 1.0, 1.5] {
        let steady = Spring::new(stiffness).expect("a spring");
        let spring = VaryingSpring::new(steady, amplitude, 2.0, f64::from(CALLS));
        let mut spring = spring.expect("a varying spring");
        let place = |call: f64| size * (TAU * call / f64::from(CALLS) + shift).sin();
        let taken: f64 = (0..CALLS)
            .map(f64::from)
            .map(|call| at(&mut spring, place(call)) * (place(call + 0.5) - place(call - 0.5)))
            .sum();
        let exact = FRAC_PI_2 * amplitude * size * size * f64::cos(2.0 * shift);
        assert!(
            abs_diff_eq!(taken, exact, epsilon = 1e-7 * amplitude * size * size),
            "{taken} for {exact}"
        );
    }
}

/// The work along a closed path through a solid, by midpoints, relative to its magnitude; `bends` is how often the
/// effort may jump or bend on the path, and each costs a step's worth of the largest effort at most.
fn closed<V, S>(solid: S, place: impl Fn(f64) -> V, bends: f64)
where
    V: Signal<Scalar = f64>,
    S: Solid<V>,
{
    const STEPS: u32 = 100_000;
    let mut port = Contact::with(solid, 3000.0, 0.0).expect("a contact");
    let (mut net, mut gross, mut worst) = (0.0, 0.0, 0.0);
    for n in 0..STEPS {
        let [from, middle, to] =
            [0.0, 0.5, 1.0].map(|part| place((f64::from(n) + part) / f64::from(STEPS)));
        let effort = at(&mut port, middle);
        let step = to - from;
        net += effort.inner(step);
        gross += effort.inner(step).abs();
        worst = f64::max(worst, effort.inner(effort).sqrt() * step.inner(step).sqrt());
    }
    assert!(gross > 1.0, "{gross} J: the way does not enter the solid");
    assert!(net.abs() <= 1e-8 * gross + bends * worst, "{net:e} of {gross} J");
}

#[test]
fn solids_store_what_they_take() {
    let turn = |at: f64| (TAU * at).sin_cos();
    let round = |at: f64| {
        let (sine, cosine) = turn(at);
        Vector2::new(0.1 + 0.2 * cosine, 0.05 + 0.25 * sine)
    };
    let knot = |at: f64| {
        let ((sine, cosine), (double, _)) = (turn(at), turn(2.0 * at));
        Vector3::new(0.05 + 0.2 * cosine, 0.25 * sine, 0.03 + 0.1 * double)
    };
    closed(Plane::new(Vector2::new(0.0, 0.1), Vector2::new(0.3, 1.0)).expect("one"), round, 0.0);
    closed(Sphere::new(Vector2::new(0.3, 0.1), 0.2).expect("one"), round, 0.0);
    closed(Cuboid::new(Vector2::zeros(), Vector2::new(0.2, 0.3)).expect("one"), round, 12.0);
    closed(Plane::new(Vector3::zeros(), Vector3::new(1.0, 2.0, 0.5)).expect("one"), knot, 0.0);
    closed(Sphere::new(Vector3::new(0.1, 0.1, 0.0), 0.25).expect("one"), knot, 0.0);
    closed(Cuboid::new(Vector3::zeros(), Vector3::repeat(0.2)).expect("one"), knot, 24.0);
}
