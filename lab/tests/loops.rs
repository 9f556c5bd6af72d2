//! Closed loops whose numbers are arrays, against the library's own parts in one `f64` after the other, to the bit.

use lyapunov::bodies::{Body, Impedance};
use lyapunov::effects::OnePortExt;
use lyapunov::environments::Wall;
use lyapunov::stabilizers::{Member, NoStabilizer, StabilizerExt};
use lyapunov::{
    DampingLimit, Dissipation, Lolc, OnePort, ParameterError, Plant, Popc, PortEnergy, Scalar,
};
use lyapunov_lab::map::{Ends, Loops, Numbers, Recipe};

const PERIOD: f64 = 1e-3;

type Made<T> = Member<T, (PortEnergy, Dissipation<T>)>;

/// A stabilizer of this name.
struct Named(&'static str);

impl Recipe for Named {
    fn make<T: Scalar>(&self) -> Result<Made<T>, ParameterError> {
        let limit = DampingLimit::at(T::of(90.0))?;
        let popc = Popc::new(PortEnergy, limit);
        Ok(match self.0 {
            "popc" => Member::Popc(popc),
            "lolc" => Member::Lolc(Lolc::new((PortEnergy, Dissipation::of(T::of(0.1))?), limit)),
            "popc-bounded" => Member::Bounded(popc.bounded(T::of(1e-4))?),
            _ => Member::NoStabilizer(NoStabilizer),
        })
    }
}

/// Numbers that differ from loop to loop.
fn spread(count: usize, from: f64, to: f64) -> Vec<f64> {
    let at = |index: usize| from + (to - from) * (index * 7 % count) as f64 / count as f64;
    (0..count).map(at).collect()
}

/// Position, velocity, observed energy and largest |position| of a loop alone.
fn alone(loops: &Loops<'_>, name: &'static str, at: usize) -> [f64; 4] {
    let of = |numbers: Numbers<'_>| match numbers {
        Numbers::All(number) => number,
        Numbers::Each(numbers) => numbers[at],
    };
    let Impedance { mass, damping, stiffness } = loops.impedance;
    let impedance = Impedance { mass: of(mass), damping: of(damping), stiffness: of(stiffness) };
    let body = Body::new(impedance, PERIOD).unwrap();
    let mut plant = body.starting(of(loops.position), of(loops.velocity));
    let wall = Wall::new(of(loops.wall_stiffness), of(loops.wall_damping)).unwrap();
    let wall = wall.at(of(loops.wall_position));
    let mut port = wall.stabilized(Named(name).make::<f64>().unwrap()).differenced();
    let (mut sample, mut largest) = (plant.start(), 0.0_f64);
    for tick in 0..=loops.ticks {
        if 2 * tick >= loops.ticks {
            largest = largest.max(sample.position.abs());
        }
        if tick < loops.ticks {
            sample = plant.advance(port.respond(&sample));
        }
    }
    [sample.position, sample.velocity, port.correction().observed_energy, largest]
}

/// Asserts that every loop from `starts` on has the bits of the library's parts.
fn have_the_bits(ticks: u64, start: &[f64]) {
    let count = start.len();
    let (mass, stiffness) = (spread(count, 0.1, 0.4), spread(count, 500.0, 60_000.0));
    let loops = Loops {
        count,
        ticks,
        period: PERIOD,
        impedance: Impedance {
            mass: Numbers::Each(&mass),
            damping: Numbers::All(0.2),
            stiffness: Numbers::All(50.0),
        },
        position: Numbers::Each(start),
        velocity: Numbers::All(0.1),
        wall_stiffness: Numbers::Each(&stiffness),
        wall_damping: Numbers::All(2.0),
        wall_position: Numbers::All(5e-4),
    };
    let room = || Ends::room(count).unwrap();
    for name in ["none", "popc", "lolc", "popc-bounded"] {
        let ends = loops.ends(room(), &Named(name), &|| true).unwrap().unwrap();
        assert_eq!(ends.position.len(), count);
        for at in 0..count {
            let told = [&ends.position, &ends.velocity, &ends.observed_energy, &ends.largest];
            let told = told.map(|numbers| numbers[at].to_bits());
            let expected = alone(&loops, name, at).map(f64::to_bits);
            assert_eq!(told, expected, "{name}, loop {at}, {ticks} ticks");
        }
    }
    // What a body cannot have is said as by the body.
    let heavy =
        Loops { impedance: Impedance { mass: Numbers::All(0.0), ..loops.impedance }, ..loops };
    let fault =
        |loops: &Loops<'_>| loops.ends(room(), &Named("popc"), &|| true).unwrap_err().parameter;
    assert_eq!(fault(&heavy), "mass");
    // Numbers of the wall have names of their own here, and no part checks where a loop starts.
    let nowhere = Numbers::All(f64::NAN);
    assert_eq!(fault(&Loops { wall_stiffness: Numbers::All(-1.0), ..loops }), "wall_stiffness");
    assert_eq!(fault(&Loops { wall_damping: nowhere, ..loops }), "wall_damping");
    assert_eq!(fault(&Loops { position: nowhere, ..loops }), "position");
    assert_eq!(fault(&Loops { wall_position: nowhere, ..loops }), "wall_position");
    // One that is stopped ends nowhere.
    assert!(ticks == 0 || loops.ends(room(), &Named("popc"), &|| false).unwrap().is_none());
}

/// Groups of any lanes and some lanes more; halves of even, odd and no ticks.
#[test]
fn every_loop_has_the_bits_of_the_librarys_parts() {
    let start = spread(69, -5e-3, 2e-3);
    for ticks in [0, 1, 2, 3, 64, 301] {
        have_the_bits(ticks, &start);
    }
}

/// Numbers too large or too small for ticks without checks, in all lanes of a group and in some of them.
#[test]
fn every_loop_has_them_at_the_ends_of_the_range() {
    let far = [1e-170, 1e7, -1e30, 0.0].into_iter().cycle().take(37).collect::<Vec<_>>();
    let one_of_many = (0..69).map(|at| if at == 40 { 3e6 } else { -1e-3 }).collect::<Vec<_>>();
    for start in [far, one_of_many] {
        have_the_bits(301, &start);
    }
}
