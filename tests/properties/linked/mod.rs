//! Two masses and a link, against references of many digits and against one mass.

mod references;

use approx::assert_abs_diff_eq;
use nalgebra::SMatrix;

use lyapunov::{
    ParameterError, Plant, PortSample, Requirement,
    bodies::{
        Body, DampedMass, ElasticJoint, Impedance, OperatedBody, TwoMassBody, TwoMassParts,
        held_input,
    },
};

use crate::support::Real;
use references::{REFERENCES, Reference};

fn parts<T: Real>([mo, bo, kh, md, bd, kl, bl, _]: [f64; 8]) -> TwoMassParts<T> {
    TwoMassParts {
        operator: Impedance { mass: T::of(mo), damping: T::of(bo), stiffness: T::of(kh) },
        device: DampedMass { mass: T::of(md), damping: T::of(bd) },
        link: ElasticJoint { stiffness: T::of(kl), damping: T::of(bl) },
    }
}

fn linked(of: [f64; 8]) -> TwoMassBody<f64> {
    TwoMassBody::new(parts(of), 1.0 / of[7]).expect("two masses")
}

/// Effort of the references.
fn effort(tick: usize) -> f64 {
    0.5 * ((tick * 7 % 5) as f64 - 1.5)
}

/// Positions and velocities of operator and device.
fn state(plant: &TwoMassBody<f64>, sample: &PortSample<f64>) -> [f64; 4] {
    let (position, velocity) = plant.operator();
    [position, sample.position, velocity, sample.velocity]
}

/// The matrix of a reference, of `f64` made in the same order.
fn matrix([mo, bo, kh, md, bd, kl, bl, rate]: [f64; 8]) -> SMatrix<f64, 5, 5> {
    let (both, t) = (mo + md, 1.0 / rate);
    let (so, sd) = (md / both, mo / both);
    let centre =
        [-kh / both, -kh * so / both, -(bo + bd) / both, (bd * sd - bo * so) / both, -1.0 / both];
    let stretch = [
        -kh / mo,
        -(kh * so / mo + kl / mo + kl / md),
        bd / md - bo / mo,
        -(bo * so / mo + bd * sd / md + bl / mo + bl / md),
        1.0 / md,
    ];
    let rows = [[0.0, 0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0, 0.0], centre, stretch, [0.0; 5]];
    SMatrix::from_row_slice(rows.as_flattened()) * t
}

/// Stiff, undamped, overdamped, and with masses a million apart: within 1e-12 of each entry, or a few roundings of the
/// entry that the link's own oscillation at `Ω` would have, `(1, 1, Ω, Ω)` per `(1, 1, Ω, Ω, k_l)`.
#[test]
fn held_input_of_stiff_links() {
    for Reference { parts, increments, .. } in REFERENCES {
        let found = held_input(matrix(parts));
        let omega = (parts[5] / parts[0] + parts[5] / parts[3]).sqrt();
        let units = [1.0, 1.0, omega, omega, parts[5]];
        for (row, exact) in increments.iter().enumerate() {
            for (column, exact) in exact.iter().enumerate() {
                let off = (found[(row, column)] - exact).abs();
                let natural = units[row] / units[column];
                let allowed = 1e-12 * exact.abs() + 4.0 * f64::EPSILON * natural;
                assert!(off <= allowed, "{parts:?}: {row} {column} is off by {off:e} of {exact:e}");
            }
        }
    }
}

/// Rounding of every tick included: within 1e-12 of the largest value of each on the way.
#[test]
fn linked_equals_its_references() {
    for Reference { parts, third, end, most, .. } in REFERENCES {
        let mut plant = linked(parts).resting_at(0.001).starting(-0.004, 0.1);
        for tick in 0..300 {
            let sample = plant.advance(effort(tick));
            let exact = match tick {
                99 => third,
                299 => end,
                _ => continue,
            };
            for ((found, exact), most) in state(&plant, &sample).into_iter().zip(exact).zip(most) {
                let off = (found - exact).abs();
                assert!(off <= 1e-12 * most, "{parts:?}: {found} is off by {off:e} of {most:e}");
            }
        }
    }
}

/// A kilometre away a position has 1.2e-13 m of rounding, which the operator's spring may feel and the link must not:
/// each tick may change a velocity by `k_h T / m_o` times that. A link known only by the difference of two positions
/// would change it by `√(k_l / μ)` times that, a hundred times as much.
#[test]
fn far_from_the_origin_only_the_position_is_rounded() {
    for Reference { parts, end, .. } in REFERENCES.into_iter().skip(1).take(3) {
        let away = 1000.0;
        let mut plant = linked(parts).resting_at(away + 0.001).starting(away - 0.004, 0.1);
        let mut last = plant.start();
        for tick in 0..300 {
            last = plant.advance(effort(tick));
        }
        let rounding = 2.0 * f64::EPSILON * away / 2.0;
        let off = (last.velocity - end[3]).abs();
        let bound = 300.0 * rounding * parts[2] / parts[0] / parts[7];
        assert!(off <= bound, "{parts:?}: {off:e}, {bound:e} allowed");
    }
}

/// The start: both masses in one place, and a displacement equal to the change of position.
#[test]
fn both_masses_start_together() {
    let plant = linked(REFERENCES[0].parts).resting_at(0.5).starting(-0.004, 0.3);
    assert_eq!(plant.start(), PortSample::starting(1e-3, -0.004, 0.3));
    assert_eq!(plant.operator(), (-0.004, 0.3));
    let mut moved = plant;
    let mut last = moved.start();
    for tick in 0..100 {
        let sample = moved.advance(effort(tick));
        assert_eq!(sample.displacement, sample.position - last.position);
        assert_eq!(sample.work, effort(tick) * sample.displacement);
        assert_eq!(moved.start().position, sample.position);
        last = sample;
    }
    assert_ne!(moved.operator().0, last.position);
}

/// A stiff link stretches by its force over its stiffness, `O(1 / k_l)`, and no more: the two move as one.
#[test]
fn a_stiff_link_makes_one_mass() {
    let apart = |stiffness: f64| {
        let of = [0.1, 0.2, 50.0, 0.2, 0.001, stiffness, 2.0 * (stiffness / 15.0).sqrt(), 1000.0];
        let mut two = linked(of).resting_at(0.001).starting(-0.004, 0.1);
        let joined = Impedance { mass: 0.1 + 0.2, damping: 0.2 + 0.001, stiffness: 50.0 };
        let body = Body::new(joined, 1e-3).expect("a body");
        let mut one = body.resting_at(0.001).starting(-0.004, 0.1);
        (0..1000).fold(0f64, |most, tick| {
            let effort = effort(tick / 10);
            most.max((two.advance(effort).position - one.advance(effort).position).abs())
        })
    };
    for stiffness in [1e5, 1e7, 1e9] {
        // 1.5 N of effort and spring at most, amplified a few times by the operator's undamped spring.
        assert!(apart(stiffness) < 15.0 / stiffness, "{:e} at {stiffness:e}", apart(stiffness));
    }
    assert!(apart(1e5) > 1e-6);
}

/// The energy of an undamped pair in `f32` over a million ticks, as the amplitude of one mass: loss or gain stays
/// within the rounding of the increments for one mass, `3 u (ω T)² / 2` a tick.
#[test]
fn undamped_f32_keeps_its_amplitude() {
    for (stiffness, rate) in [(50.0, 1000.0), (2000.0, 4000.0), (50.0, 100.0)] {
        let of = [0.1, 0.0, stiffness, 0.2, 0.0, 1e5, 0.0, rate];
        let plant = TwoMassBody::new(parts::<f32>(of), 1.0 / rate as f32).expect("two masses");
        let mut plant = plant.starting(0.004, 0.0);
        let energy = |(xo, vo): (f32, f32), (xd, vd): (f32, f32)| {
            let [xo, vo, xd, vd] = [xo, vo, xd, vd].map(f64::from);
            (0.1 * vo * vo + stiffness * xo * xo + 0.2 * vd * vd) / 2.0
                + 1e5 * (xo - xd).powi(2) / 2.0
        };
        let first = energy((0.004, 0.0), (0.004, 0.0));
        let mut most = 0f64;
        for _ in 0..1_000_000 {
            let sample = plant.advance(0.0);
            let now = energy(plant.operator(), (sample.position, sample.velocity));
            most = most.max(((now / first).sqrt() - 1.0).abs());
        }
        let turn = stiffness / 0.3 / (rate * rate);
        // The positions that give the energy are rounded to 2e-10 m, against a stretch of a micrometre.
        let bound = 3e-4 + 1e6 * 1.5 * f32::unit() * turn;
        assert!(most < bound, "{most:e} at {stiffness} N/m and {rate} Hz, {bound:e} allowed");
    }
}

/// Other masses have another centre; positions and velocities stay.
#[test]
fn other_masses_stay_where_they_are() {
    let mut plant = linked(REFERENCES[0].parts).starting(0.01, 0.2);
    let mut sample = plant.start();
    for tick in 0..20 {
        sample = plant.advance(effort(tick));
    }
    let before = state(&plant, &sample);
    let [_, bo, kh, _, bd, kl, bl, rate] = REFERENCES[0].parts;
    plant.reshape(parts([2.0, bo, kh, 0.01, bd, kl, bl, rate]), 0.0).expect("other parts");
    let sample = plant.advance(3.0);
    assert_eq!((sample.displacement, sample.period), (0.0, 0.0));
    for (before, after) in before.into_iter().zip(state(&plant, &sample)) {
        assert_abs_diff_eq!(before, after, epsilon = 4.0 * f64::EPSILON * before.abs());
    }
}

fn refused(of: [f64; 8]) -> (&'static str, Requirement) {
    let ParameterError { parameter, requirement, .. } =
        TwoMassBody::<f64>::new(parts(of), 1.0 / of[7]).expect_err("no plant");
    (parameter, requirement)
}

#[test]
fn invalid_links_are_refused() {
    use Requirement::{InRange, NonNegative, Positive};
    let good = REFERENCES[0].parts;
    let names = [
        ("operator mass", Positive),
        ("operator damping", NonNegative),
        ("operator stiffness", NonNegative),
        ("device mass", Positive),
        ("device damping", NonNegative),
        ("link stiffness", Positive),
        ("link damping", NonNegative),
        ("period", Positive),
    ];
    for (at, (name, requirement)) in names.into_iter().enumerate() {
        for bad in [-1.0, f64::NAN, f64::INFINITY, 0.0] {
            let with =
                |value| std::array::from_fn(|part| if part == at { value } else { good[part] });
            if bad == 0.0 && requirement == NonNegative {
                TwoMassBody::<f64>::new(parts(with(bad)), 1e-3).expect("without it");
            } else {
                assert_eq!(refused(with(bad)), (name, requirement), "{bad}");
            }
        }
    }
    let [mo, bo, kh, _, bd, kl, bl, rate] = good;
    assert_eq!(refused([mo, bo, kh, 1e-310, bd, kl, bl, rate]), ("device mass", InRange));
    let mut plant = linked(good);
    let before = plant;
    assert!(plant.reshape(parts([mo, bo, kh, 0.2, bd, 0.0, bl, rate]), 1e-3).is_err());
    assert!(plant.reshape(parts(good), -1e-3).is_err());
    assert_eq!(plant.advance(1.0), { before }.advance(1.0));
}
