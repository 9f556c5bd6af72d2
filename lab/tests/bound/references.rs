//! The exact limit to all its digits: references with 60 digits, from `scripts/bounds_references.py`.

// The digits stay as the script prints them.
#![allow(clippy::excessive_precision)]

use approx::abs_diff_eq;
use lyapunov_lab::bound::Limits;

use crate::bound::systems::scene;

/// Loop without its stiffness, largest stable stiffness, a tested stiffness, and 1 − spectral radius there.
const REFERENCES: [(&str, f64, f64, f64); 12] = [
    (
        "servo_rate = 1000\ndevice = { mass = 1.0, damping = 1e-5 }",
        0.020000000033333335,
        1e-2,
        1.0 - 0.99999999750000000521,
    ),
    (
        "servo_rate = 1000\ndevice = { mass = 1.0, damping = 1e-8 }",
        2.0000000000033334e-5,
        1e-5,
        2.5e-12,
    ),
    (
        "servo_rate = 100\ndevice = { mass = 0.25, damping = 2.5e-7 }\n\
         operator = { mass = 0.05, stiffness = 50.0 }",
        5.0069502422690838e-5,
        3e-5,
        1.67013695836e-9,
    ),
    (
        "servo_rate = 1000\ndevice = { mass = 1.0, damping = 1e-5 }\neffects.delay.ticks = 2",
        0.0040000000173333336,
        3e-3,
        1.24999999953e-9,
    ),
    (
        "servo_rate = 1000\nenvironment_rate = 100\ndevice = { mass = 0.2, damping = 2e-6 }\n\
         operator.stiffness = 20.0\neffects.delay.ticks = 13",
        0.0001117599512661202,
        1e-4,
        5.26125405209e-9,
    ),
    (
        "servo_rate = 1000\ndevice = { mass = 0.2, damping = 0.1 }\n\
         operator = { mass = 0.1, damping = 0.2, stiffness = 50.0 }\n\
         environment.mass-spring-damper.damping = 2.0",
        4569.888812440622,
        2000.0,
        1.0 - 0.99783605178647374062,
    ),
    (
        "servo_rate = 1000\nvelocity = \"exact\"\ndevice = { mass = 0.2, damping = 0.1 }\n\
         operator = { mass = 0.1, damping = 0.2, stiffness = 50.0 }\neffects.delay.ticks = 1\n\
         environment.mass-spring-damper.damping = 2.0",
        1529.0512229257208,
        500.0,
        1.0 - 0.99740480736333048489,
    ),
    (
        "servo_rate = 1000\nenvironment_rate = 200\ndevice = { mass = 0.2, damping = 0.1 }\n\
         operator.damping = 0.5\neffects.delay.ticks = 3\neffects.filter.cutoff = 80.0\n\
         environment.mass-spring-damper.damping = 1.0",
        284.14313481329351,
        50.0,
        1.0 - 0.98306480290121419567,
    ),
    (
        "servo_rate = 1000\nenvironment_rate = 500\ndevice = { mass = 0.2, damping = 1e-6 }\n\
         operator = { mass = 0.1, damping = 1e-6, stiffness = 50.0 }\n\
         link = { stiffness = 900.0, damping = 1e-6 }\neffects.delay.ticks = 1",
        0.00096530281260377491,
        1e-4,
        5.90764159998e-9,
    ),
    (
        "servo_rate = 1000\nenvironment_rate = 500\ndevice = { mass = 0.2, damping = 0.3 }\n\
         operator = { mass = 0.1, damping = 0.2, stiffness = 50.0 }\n\
         environment.mass-spring-damper = { damping = 1.0, mass = 0.02 }",
        1779.9499731521417,
        300.0,
        1.0 - 0.99607521443348591214,
    ),
    (
        "servo_rate = 1000\nenvironment_rate = 20\ndevice = { mass = 0.0288, damping = 0.0021 }\n\
         operator = { mass = 0.1052, damping = 2375.5, stiffness = 0.0968 }\n\
         link = { stiffness = 3.55e-7, damping = 52.0 }\neffects.delay.ticks = 8\n\
         environment.mass-spring-damper = { damping = 0.0019, mass = 4.84e-5 }",
        3096.4544327846159,
        1000.0,
        1.99382604258394e-6,
    ),
    (
        "servo_rate = 1000\nenvironment_rate = 20\ndevice = { mass = 0.0077, damping = 1.006 }\n\
         operator = { mass = 0.00096, damping = 1.54e-5, stiffness = 54.6 }\n\
         link = { stiffness = 5645.0, damping = 1.124 }\neffects.delay.ticks = 6\n\
         environment.mass-spring-damper = { damping = 0.0, mass = 8.54e-6 }",
        54.946241290497616,
        50.0,
        1.0 - 0.90854554110040080978,
    ),
];

#[test]
fn the_exact_limit_has_all_its_digits() {
    for (text, most, stiffness, decay) in REFERENCES {
        let text = match text.split_once("environment.mass-spring-damper = { ") {
            Some((before, after)) => format!(
                "{before}environment.mass-spring-damper = {{ stiffness = {stiffness}, {after}"
            ),
            None => format!("{text}\nenvironment.mass-spring-damper.stiffness = {stiffness}"),
        };
        let limits = Limits::of(&scene(&format!("duration = 1\n{text}")));
        let found = limits.exact.unwrap();
        assert!(abs_diff_eq!(found / most, 1.0, epsilon = 1e-14), "{found:e} {most:e}\n{text}");
        let found = 1.0 - limits.spectral_radius.unwrap();
        // The digits that 1 − radius keeps in f64, and at most 10.
        let digits = 1e-10_f64.max(2.0 * f64::EPSILON / decay);
        assert!(abs_diff_eq!(found / decay, 1.0, epsilon = digits), "{found:e} {decay:e}\n{text}");
    }
}
