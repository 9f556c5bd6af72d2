//! Tests of `lyapunov effects`, the costs of the effects.

use std::collections::BTreeSet;

use serde_json::Value;

use crate::cli::place::Place;

#[test]
fn the_prices_are_printed_as_json() {
    let said = Place::new().run(["effects", "--json"]);
    said.ended(0, &[]);
    let told: Value = serde_json::from_str(&said.out).unwrap();
    let scalars = told["scalars"].as_array().unwrap();
    let names: Vec<_> = scalars.iter().map(|it| it["scalar"].as_str().unwrap()).collect();
    assert_eq!(names, ["f64", "f64x8"]);
    for scalar in scalars {
        assert!(scalar["bare_ns_per_step"].as_f64().unwrap() > 0.0);
        let effects = scalar["effects"].as_array().unwrap();
        let names: BTreeSet<_> = effects.iter().map(|it| it["effect"].as_str().unwrap()).collect();
        assert_eq!(names.len(), effects.len());
        for effect in effects {
            for company in ["alone", "composed"] {
                assert!(effect[company]["ratio"].as_f64().unwrap() > 0.0, "{effect}");
                assert!(effect[company]["spread_ns"].as_f64().unwrap() >= 0.0, "{effect}");
            }
        }
        // A matrix exponential for every tick is not cheap on any machine.
        let jitter = effects.iter().find(|it| it["effect"] == "jitter").unwrap();
        assert!(jitter["alone"]["ratio"].as_f64().unwrap() > 2.0, "{jitter}");
    }
}
