//! Observers alone, and the summary of a run.

use lyapunov::telemetry::EnergyMeter;
use lyapunov::{Dissipation, Observer, PortEnergy};

use crate::export::blocks;
use crate::watched::{Meter, Observing};

blocks! {
    /// Observer alone (Observer): sums the port's energy and what the device's own damper burns, and changes no effort.
    observer on every = {
        "observer";
        Observing<T, (PortEnergy, Dissipation<T>)>, whole 2 + 0;
        {
            /// Damping that the device surely has, N.s/m; 0 for the port's energy alone.
            device_damping: T,
        };
        |given| Ok(Observer::of((PortEnergy, Dissipation::of(given.device_damping)?)));
        [life observer]
    }
    /// Run-time summary (EnergyMeter): energies and counts of all ticks so far, in sums that keep their digits for a year.
    energy_meter on every = {
        "energy_meter";
        Meter<T>, words;
        {
            /// Nothing to choose: 0. It is not looked at, since that would be done on every tick.
            reserved: u32,
        };
        |_given| Ok(Meter(EnergyMeter::new()));
        [life meter]
    }
}
