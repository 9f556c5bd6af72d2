//! Logs of a device, observed.

use lyapunov_lab::observe::{Settings, observe};

use crate::exchange::answer;
use crate::scene::headed;

/// Observes the log below the first line of the input, which is its name: the output is the report of the command `observe`.
#[unsafe(no_mangle)]
pub extern "C" fn observed() -> u32 {
    answer(|text| {
        let (name, log) = headed(text);
        let observed = observe(log.as_bytes(), name, &Settings::default());
        let observed = observed.map_err(|error| error.to_string())?;
        Ok(observed.report.to_string().into_bytes())
    })
}
