//! Faults in front of a stabilizer, or of a port around the environment.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use lyapunov::{Correction, OnePort, PortSample, Scalar, Signal, Stabilizer};

use super::Plan;
use super::fault::Fault;
use super::witness::Witness;
use crate::simulate::{AnyStabilizer, Fitted, Port, Space};

/// Share of a period by which a late sample is late.
const LATE: f64 = 0.9;

/// Source of samples, some of them spoilt.
#[derive(Debug)]
struct Spoiler<V: Signal> {
    plan: Plan,
    tick: u64,
    /// The last sample that was told.
    last: PortSample<V>,
    /// The sample that the next one has to span as well.
    missed: Option<PortSample<V>>,
}

impl<V: Signal> Spoiler<V> {
    fn new(plan: Plan) -> Self {
        Self { plan, tick: 0, last: PortSample::default(), missed: None }
    }

    /// The fault of the next tick, if it has one.
    fn next(&mut self) -> Option<Fault> {
        self.tick += 1;
        self.plan.at(self.tick - 1)
    }

    /// The sample that is told of a tick; none of one that is dropped.
    fn tell(&mut self, fault: Option<Fault>, sample: &PortSample<V>) -> Option<PortSample<V>> {
        let sample = self.missed.take().map_or(*sample, |missed| sample.spanning(&missed));
        let unmoved = PortSample { displacement: V::zero(), work: V::zero(), ..sample };
        let over = |share: f64| sample.period * V::Scalar::of(share);
        let told = match fault {
            None => sample,
            Some(Fault::Dropped) => {
                self.missed = Some(sample);
                return None;
            }
            Some(Fault::Stale) => {
                self.missed = Some(PortSample { period: over(0.0), ..sample });
                let PortSample { position, velocity, .. } = self.last;
                PortSample { position, velocity, ..unmoved }
            }
            Some(Fault::Repeated) => self.last,
            Some(Fault::Late) => {
                self.missed = Some(PortSample { period: over(-LATE), ..unmoved });
                PortSample { period: over(1.0 + LATE), ..sample }
            }
            Some(fault) => fault.spoilt(sample),
        };
        self.last = if fault.is_none() { told } else { self.last };
        Some(told)
    }
}

/// Stabilizer that some ticks reach spoilt.
struct Spoilt<S, V: Signal> {
    stabilizer: S,
    spoiler: Spoiler<V>,
    held: Correction<V>,
    witness: Rc<RefCell<Witness>>,
}

impl<V: Signal, S: Stabilizer<V>> Stabilizer<V> for Spoilt<S, V> {
    fn stabilize(&mut self, sample: &PortSample<V>, effort: V) -> Correction<V> {
        let fault = self.spoiler.next();
        let effort = fault.map_or(effort, |fault| fault.asked(effort));
        let mut witness = self.witness.borrow_mut();
        let Some(sample) = self.spoiler.tell(fault, sample) else {
            witness.miss();
            return self.held;
        };
        self.held = self.stabilizer.stabilize(&sample, effort);
        witness.see(fault, &sample, effort, &self.held);
        self.held
    }
}

/// Port around the environment that some ticks reach spoilt.
struct SpoiltPort<V: Signal> {
    port: Port<V>,
    spoiler: Spoiler<V>,
    held: V,
    /// The fault of this tick, for the environment inside.
    fault: Rc<Cell<Option<Fault>>>,
    witness: Rc<RefCell<Witness>>,
}

impl<V: Signal> OnePort<V> for SpoiltPort<V> {
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let fault = self.spoiler.next();
        self.fault.set(fault);
        let Some(sample) = self.spoiler.tell(fault, sample) else {
            self.witness.borrow_mut().miss();
            return self.held;
        };
        // An answer that is not finite is a rejection, which has no force.
        let told = Correction::none(self.port.respond(&sample)).checked();
        self.witness.borrow_mut().see(fault, &sample, V::zero(), &told);
        self.held = told.effort;
        self.held
    }

    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

/// Environment whose answers some faults spoil.
struct SpoiltEnvironment<V: Signal> {
    port: Port<V>,
    fault: Rc<Cell<Option<Fault>>>,
}

impl<V: Signal> OnePort<V> for SpoiltEnvironment<V> {
    fn respond(&mut self, sample: &PortSample<V>) -> V {
        let effort = self.port.respond(sample);
        self.fault.get().map_or(effort, |fault| fault.asked(effort))
    }

    fn correction(&self) -> Correction<V> {
        self.port.correction()
    }
}

/// Stabilizer or port of a loop, with the faults of `plan` in front of it and a `witness` in between.
pub(super) fn spoilt<V: Space>(
    fitted: Fitted<V>,
    plan: Plan,
    witness: &Rc<RefCell<Witness>>,
) -> Fitted<V> {
    let witness = Rc::clone(witness);
    match fitted {
        Fitted::Behind(stabilizer) => {
            let (spoiler, held) = (Spoiler::new(plan), Correction::none(V::zero()));
            Fitted::Behind(AnyStabilizer::called(Spoilt { stabilizer, spoiler, held, witness }))
        }
        Fitted::Around(wrapper) => {
            let fault = Rc::new(Cell::new(None));
            let within = Rc::clone(&fault);
            let inside =
                move |port| Port::new(SpoiltEnvironment { port, fault: Rc::clone(&within) });
            let outside = move |port| {
                let (fault, witness) = (Rc::clone(&fault), Rc::clone(&witness));
                let (spoiler, held) = (Spoiler::new(plan), V::zero());
                Port::new(SpoiltPort { port, spoiler, held, fault, witness })
            };
            Fitted::Around(wrapper.between(inside, outside))
        }
    }
}
