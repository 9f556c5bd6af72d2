//! A debt that errors of the measured position made.

use lyapunov_lab::Sign;

use crate::sanity::{press, shows, summary};

/// An encoder of 0.2 mm in a swing of some: POPC brakes to the end, though the port truly took energy.
#[test]
fn a_debt_that_the_encoder_made_is_told() {
    let hand = "{ mass = 0.15, damping = 4.0, stiffness = 400.0, rest = 0.02 }";
    let wall = "{ wall = { position = 0.005, stiffness = 2500.0, damping = 1.0 } }";
    let run = |environment, resolution: f64, delay: u32| {
        let encoder = format!("encoder.resolution = {resolution:?}, delay.ticks = {delay}");
        let effects = format!("{{ {encoder}, saturation.force = 20.0 }}");
        summary::<f64>(&press(&[
            ("duration", "3.0"),
            ("device", "{ mass = 0.12, damping = 0.3 }"),
            ("operator", hand),
            ("initial", "{}"),
            ("environment", environment),
            ("effects", &effects),
        ]))
    };
    let coarse = run(wall, 2e-4, 1);
    // 0.2 mm a tick of 1 ms, at half of tan(pi / 8) times 0.27 kg a tick.
    let count = "less: one count (200 mm/s) at the limit of 55.92 N.s/m is 11.18 N";
    let words = ["22.78 mJ", "0.1888 mJ went into the port", "a smaller damping_cap", count];
    shows(&coarse.look_at(), Sign::Miscounted, &words);
    assert!(coarse.absorbed > 0.0 && coarse.observed_energy_least < -0.02);
    assert_eq!(run(wall, 5e-6, 1).look_at(), []);
    // Half of this debt is the true port's.
    let both = run(wall, 5e-4, 5);
    assert!(both.shortfall > 0.01 && both.absorbed < -0.01, "{both}");
    assert_eq!(both.look_at(), []);
    // Ten ticks late the debt is the true port's: the damper itself drives the loop.
    let late = run(wall, 5e-6, 10);
    assert!(late.shortfall > 1.0 && late.absorbed < -1.0);
    assert_eq!(late.look_at(), []);
}
