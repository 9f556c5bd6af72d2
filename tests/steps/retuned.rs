//! Changes between ticks: those of `tests/retuning`, but for what is stored in bytes.

#[path = "../retuning/changes.rs"]
mod changes;
#[path = "../retuning/refused.rs"]
mod refused;

use approx::assert_relative_eq;
use lyapunov::{
    Correction, OnePort, ParameterError, PortSample, Snapshot,
    environments::Spring,
    stabilizers::{CoupledPort, VirtualCoupling},
};

use crate::support::{Dice, PERIOD, held_tick};

/// The forces of a coupling that is shaken for a while.
fn shaken(port: &mut CoupledPort<Spring<f64>, f64>, seed: u64) -> Vec<f64> {
    let (mut dice, mut position, mut applied) = (Dice::of(seed), 0.0, 0.0);
    let mut forces = Vec::new();
    for _ in 0..20 {
        let displacement = dice.within(1e-3);
        position += displacement;
        applied = port.respond(&held_tick(position, displacement, applied));
        forces.push(applied);
    }
    forces
}

/// From the same state one that was changed, and one that was stored, acts as one that is made so.
#[test]
fn a_coupling_is_changed_and_stored() {
    let soft = VirtualCoupling { stiffness: 800.0, damping: 0.2, drag: 10.0 };
    let stiff = VirtualCoupling { stiffness: 1600.0, damping: 0.1, drag: 5.0 };
    let spring = || Spring::new(5000.0).expect("a spring");
    let mut port = CoupledPort::new(spring(), soft).expect("a coupling");
    shaken(&mut port, 3);
    let fresh = |coupling| CoupledPort::new(spring(), coupling).expect("a coupling");
    let [mut as_it_was, mut made] =
        [soft, stiff].map(|it| fresh(it).restored(port.state()).expect("a memory"));
    let mut unchanged = port;
    port.set_coupling(stiff).expect("a coupling");
    assert!(port.set_coupling(VirtualCoupling { stiffness: -1.0, ..soft }).is_err());
    assert_eq!((port.coupling().stiffness, port.coupling().drag), (1600.0, 5.0));
    let [changed, made, unchanged, stored] =
        [&mut port, &mut made, &mut unchanged, &mut as_it_was].map(|it| shaken(it, 4));
    assert_eq!(changed, made);
    assert_eq!(unchanged, stored);
    assert_ne!(changed, unchanged);
}

/// Gives 2 N for each metre per second that it is told, plus what it keeps.
#[derive(Clone, Debug)]
struct Viscous {
    kept: f64,
}

impl OnePort<f64> for Viscous {
    fn respond(&mut self, sample: &PortSample<f64>) -> f64 {
        self.kept += sample.displacement;
        2.0 * sample.velocity + self.kept
    }

    fn correction(&self) -> Correction<f64> {
        Correction { alpha: 2.0, ..Correction::none(self.kept) }
    }
}

impl Snapshot for Viscous {
    type State = f64;

    fn state(&self) -> f64 {
        self.kept
    }

    fn restored(self, kept: f64) -> Result<Self, ParameterError> {
        Ok(Self { kept })
    }
}

/// A port behind a coupling is told the velocity of its displacement; its memory and its correction are those of the whole.
#[test]
fn what_stands_behind_a_coupling_is_reached() {
    let coupling = VirtualCoupling { stiffness: 1600.0, damping: 0.2, drag: 10.0 };
    let mut port = CoupledPort::new(Viscous { kept: 0.0 }, coupling).expect("a coupling");
    // So the answer of each tick, which is in the state, is that of the displacement that the port was told.
    let mut before = 0.0;
    for displacement in [1e-3, 2e-3, -1e-3] {
        port.respond(&held_tick(0.0, displacement, 0.0));
        let (kept, _, answer) = port.state();
        assert_relative_eq!(answer, 2.0 * (kept - before) / PERIOD + kept, max_relative = 1e-9);
        before = kept;
    }
    assert_ne!(before, 0.0);
    assert_eq!((port.correction().effort, port.correction().alpha), (before, 2.0));
    let fresh = CoupledPort::<_, f64>::new(Viscous { kept: 0.0 }, coupling).expect("a coupling");
    assert_eq!(fresh.restored(port.state()).expect("a memory").state(), port.state());
}
