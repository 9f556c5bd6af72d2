//! A force that never acts: by whom it is held back.

use lyapunov_lab::Sign;

use crate::sanity::{of_run, press, shows};

#[test]
fn a_stabilizer_that_gives_nothing_is_told_beside_a_delay_that_is_short() {
    let under = |damping: &str| {
        let device = format!("{{ mass = 0.2, damping = {damping} }}");
        of_run(&press(&[
            ("device", &device),
            ("stabilizer", "{ force-bounding = { damping = 0.0 } }"),
            ("effects", "{ delay = { ticks = 1 } }"),
        ]))
    };
    let bare = under("0.0");
    shows(&bare, Sign::Idle, &["none of it through; device.damping is 0, and force-bound"]);
    let damped = under("2.0");
    shows(&damped, Sign::Idle, &["the stabilizer lets none of it through"]);
    assert!(!damped[0].text.contains("device.damping") && !damped[0].text.contains("delay"));
}

#[test]
fn a_delay_that_lasts_to_the_end_is_told_with_its_ticks() {
    let late = |ticks: u64| {
        let effects = format!("{{ delay = {{ ticks = {ticks} }} }}");
        let duration = format!("{:?}", 1e-3 * (ticks as f64 - 0.9));
        let start = ("initial", "{ position = 1e-3 }");
        of_run(&press(&[("duration", &duration), start, ("effects", &effects)]))
    };
    shows(&late(2), Sign::Idle, &["on all 2 ticks: the delay is 2 ticks"]);
    shows(&late(1), Sign::Idle, &["on its only tick: the delay is 1 tick"]);
}
