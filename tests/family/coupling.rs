//! Virtual coupling: as passive as it would be alone, whatever stands behind it.

use approx::{abs_diff_eq, assert_abs_diff_eq};
use lyapunov::lanes::WideF64x4;
use lyapunov::{
    DampingLimit, HeldTick, OnePort, Plant, Popc, PortEnergy, PortSample, Scalar, Signal,
    bodies::Body,
    environments::{Spring, Wall},
    laws,
    stabilizers::{CoupledPort, StabilizerExt, VirtualCoupling},
};
use nalgebra::Vector3;

use crate::support::{Dice, HELD, PERIOD, held_tick, swing};

/// For a wall of 20 kN/m: `K T / 2 + B = 1`, and `k T / 2 = 10`.
const COUPLING: VirtualCoupling<f64> =
    VirtualCoupling { stiffness: 1600.0, damping: 0.2, drag: 10.0 };
const STIFF: f64 = 20_000.0;

fn wall() -> Wall<f64> {
    Wall::new(STIFF, 0.0).expect("a wall")
}

/// Ten times what the device renders by itself, `2 b / T`.
#[test]
fn a_wall_ten_times_too_stiff() {
    let limit = 2.0 * HELD.damping / PERIOD;
    assert!(STIFF >= 10.0 * limit * (1.0 - 1e-12));
    assert_abs_diff_eq!(COUPLING.device_damping(PERIOD), HELD.damping, epsilon = 1e-12);
    let (alone, _) = swing(HELD, Spring::new(STIFF).expect("a spring"), 20_000);
    assert!(alone > 1.0, "{alone} m");
    let spring = Spring::new(STIFF).expect("a spring");
    let coupled = CoupledPort::new(spring, COUPLING).expect("a coupling");
    // Both start with the energy of a spring that is pressed by 1 mm.
    let bound = 1e-3 * (1.0 + STIFF / HELD.stiffness).sqrt();
    let (most, late) = swing(HELD, coupled, 20_000);
    assert!(most <= bound && late < 1e-6, "{most} m, then {late} m");
    let coupled = CoupledPort::new(wall(), COUPLING).expect("a coupling");
    let (most, late) = swing(HELD, coupled, 20_000);
    assert!(most <= bound && late < 1e-6, "{most} m, then {late} m");
}

/// Against a wall at 0, a hand whose spring rests 1 cm beyond it, in series with nothing: `x = r k_h / (k_h + s)`.
#[test]
fn at_rest_it_is_the_series_of_both() {
    for stiffness in [400.0, 1600.0, 20_000.0] {
        let series = 1.0 / (1.0 / COUPLING.stiffness + 1.0 / stiffness);
        let wall = Wall::new(stiffness, 0.0).expect("a wall");
        let mut port = CoupledPort::new(wall, COUPLING).expect("a coupling");
        let body = Body::<f64>::new(HELD, PERIOD).expect("a body");
        let mut body = body.resting_at(0.01).starting(-1e-3, 0.0);
        let mut sample = body.start();
        for _ in 0..60_000 {
            sample = body.advance(port.respond(&sample));
        }
        let rest = 0.01 * HELD.stiffness / (HELD.stiffness + series);
        assert!(
            abs_diff_eq!(sample.position, rest, epsilon = 1e-12),
            "{} m for {rest} m",
            sample.position
        );
        assert_abs_diff_eq!(sample.applied, series * rest, epsilon = 1e-9);
        assert_abs_diff_eq!(
            port.deflection(),
            sample.applied / COUPLING.stiffness,
            epsilon = 1e-12
        );
    }
}

/// `Σ (b |Δx(n+1)|² / T + f(n) · Δx(n+1))` at its least, for a device with `share` of the damping that the coupling needs.
fn least<V: Signal>(
    mut port: impl OnePort<V>,
    share: f64,
    mut motion: impl FnMut(usize, V) -> V,
) -> f64 {
    let of = V::Scalar::of;
    let damping = share * COUPLING.device_damping(PERIOD);
    let mut sample = PortSample::starting(of(PERIOD), V::zero(), V::zero());
    let (mut energy, mut least) = (0.0, 0f64);
    for tick in 0..4000 {
        let force = port.respond(&sample);
        let moved = motion(tick, force);
        energy += damping / PERIOD * moved.inner(moved).lane(0) + force.inner(moved).lane(0);
        least = least.min(energy);
        let velocity = moved.scale(of(1.0 / PERIOD));
        sample = HeldTick {
            period: of(PERIOD),
            position: sample.position + moved,
            velocity,
            displacement: moved,
            applied: force,
        }
        .sample();
    }
    least
}

#[test]
fn whatever_the_motion_it_absorbs() {
    let coupled = |wall| CoupledPort::new(wall, COUPLING).expect("a coupling");
    // What takes most from a force over the next period.
    let worst = |force: f64| -force * PERIOD / (2.0 * HELD.damping);
    for seed in 0..20 {
        let mut dice = Dice::of(seed);
        let stroke = 1e-4 * f64::from(1 + seed as u32 % 4);
        let mut random =
            |_: usize, force: f64| worst(force) * dice.within(2.0) + dice.within(stroke);
        assert!(least(coupled(wall()), 1.0, &mut random) >= -1e-15);
        let turned = move |tick: usize, force: f64| {
            let inwards = (tick / (1 + seed as usize)).is_multiple_of(2);
            worst(force) + if inwards { stroke } else { -stroke }
        };
        assert!(least(coupled(wall()), 1.0, turned) >= -1e-15);
    }
    let spring = Spring::<Vector3<f64>>::new(STIFF).expect("a spring");
    let mut dice = Dice::of(3);
    let port = CoupledPort::new(spring, COUPLING).expect("a coupling");
    let random = |_: usize, force: Vector3<f64>| {
        dice.signal::<Vector3<f64>>(1e-4) - force * (PERIOD / (2.0 * HELD.damping))
    };
    assert!(least(port, 1.0, random) >= -1e-15);
}

/// The condition is the least: to and fro on every tick, before something that does not yield.
#[test]
fn with_less_damping_it_gives_energy_away() {
    let firm = VirtualCoupling { drag: 1e9, ..COUPLING };
    let shaken = |share| {
        let port = CoupledPort::new(wall(), firm).expect("a coupling");
        least(port, share, |tick, _| if tick % 2 == 0 { 1e-4 } else { -1e-4 })
    };
    assert!(shaken(1.0) >= -1e-12 && shaken(0.95) < -1e-5, "{:e} J", shaken(0.95));
}

#[test]
fn free_motion_feels_the_drag() {
    let mut port = CoupledPort::new(wall(), COUPLING).expect("a coupling");
    let mut force = 0.0;
    for tick in 0..1000 {
        let moved = 0.1 * PERIOD;
        let position = -1.0 + moved * f64::from(tick);
        force = port.respond(
            &HeldTick {
                period: PERIOD,
                position,
                velocity: 0.1,
                displacement: moved,
                applied: force,
            }
            .sample(),
        );
    }
    assert!(abs_diff_eq!(force, COUPLING.drag * 0.1, epsilon = 1e-9), "{force} N");
}

/// A stabilizer behind it sees the proxy's port, and is told of.
#[test]
fn what_stands_behind_is_told_the_truth() {
    let popc = Popc::new(PortEnergy, DampingLimit::at(1.0).expect("a limit"));
    let inner = wall().stabilized(popc.bounded(1e-3).expect("a bound"));
    let coupling = VirtualCoupling { drag: 15.0, ..COUPLING };
    let mut port = CoupledPort::new(inner, coupling).expect("a coupling");
    let (mut dice, mut position, mut force) = (Dice::of(2), 0.0, 0.0);
    let (mut proxy, mut answer, mut work) = (0.0, 0.0, 0.0);
    for _ in 0..1000 {
        let moved = dice.within(1e-4);
        position += moved;
        force = port.respond(&held_tick(position, moved, force));
        let now = position - port.deflection();
        work = f64::min(work, 1e-3) + answer * (now - proxy);
        (proxy, answer) = (now, port.correction().effort);
        assert_abs_diff_eq!(port.correction().observed_energy, work, epsilon = 1e-12);
    }
}

#[test]
fn laws_and_lanes() {
    let port = CoupledPort::new(wall(), COUPLING).expect("a coupling");
    laws::one_port(&port, laws::Samples::<f64>::new(PERIOD)).expect("the laws");
    let of = WideF64x4::of;
    let coupling = VirtualCoupling { stiffness: of(1600.0), damping: of(0.2), drag: of(10.0) };
    let wall = Wall::new(of(STIFF), of(0.0)).expect("a wall");
    let mut lanes = CoupledPort::new(wall, coupling).expect("a coupling");
    let mut alone = [port; 4];
    for (sample, _) in laws::Samples::<WideF64x4>::new(of(PERIOD)) {
        let together = lanes.respond(&sample);
        for (lane, alone) in alone.iter_mut().enumerate() {
            let force = alone.respond(&sample.map(PERIOD, |value| value.lane(lane)));
            assert_eq!(together.lane(lane).to_bits(), force.to_bits());
        }
    }
}

#[test]
fn what_cannot_be_right_is_refused_and_what_is_not_finite_forgotten() {
    let refused = |coupling| CoupledPort::<_, f64>::new(wall(), coupling).is_err();
    assert!(refused(VirtualCoupling { stiffness: 0.0, ..COUPLING }));
    assert!(refused(VirtualCoupling { damping: -1.0, ..COUPLING }));
    assert!(refused(VirtualCoupling { drag: f64::NAN, ..COUPLING }));
    let mut port = CoupledPort::new(wall(), COUPLING).expect("a coupling");
    let sound = HeldTick {
        period: PERIOD,
        position: 1e-3,
        velocity: 0.1,
        displacement: 1e-4,
        applied: 0.0,
    }
    .sample();
    port.respond(&sound);
    assert!(!port.respond(&PortSample { displacement: f64::NAN, ..sound }).is_finite());
    assert!(port.respond(&sound).is_finite());
}
