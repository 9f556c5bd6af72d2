//! Maps and sweeps that are refused: what the errors propose helps.

use lyapunov_lab::family::StabilizerName;
use lyapunov_lab::map::{Axis, BasicName, Grid, Outcome, Run, SweepPlan};

use crate::map::{STIFFNESS, scene};

/// The error of a sweep over rates that the environment's does not divide proposes one that runs.
#[test]
fn the_proposed_rates_of_a_sweep_run() {
    let planned = |x: &str| -> Result<SweepPlan, String> {
        let plan = SweepPlan::new("test", scene(""), x.parse().unwrap(), BasicName::ALL);
        plan.map_err(|error| error.to_string())
    };
    for range in ["500..4000:6:log", "350..2050:4", "150..250:3"] {
        let error = planned(&format!("servo_rate={range}")).unwrap_err();
        assert!(error.contains("is no multiple of `environment_rate` = 100.0"), "{error}");
        let proposed = error.split_once("as in ").and_then(|(_, rest)| rest.split_once(','));
        let Some((axis, _)) = proposed else {
            assert!(range.starts_with("150"), "{error}");
            continue;
        };
        assert!(axis.parse::<Axis>().unwrap().count > 1);
        assert!(planned(axis).is_ok(), "{axis}");
    }
}

/// No range of the axis helps where the scene itself lacks what a stabilizer needs.
#[test]
fn a_stabilizer_that_cannot_run_is_named_with_what_it_needs() {
    let undamped = scene("device = { mass = 0.2, damping = 0.0 }");
    let member: StabilizerName = "slope-bound".parse().unwrap();
    let x: Axis = format!("{STIFFNESS}=100..1000:3").parse().unwrap();
    let y: Axis = "environment.wall.damping=0..1:2".parse().unwrap();
    let grid = Grid::new(undamped.clone(), x.clone(), y, [member]).unwrap();
    let put = &mut |_: u64, _: &[Vec<Outcome>]| Ok(());
    let of_map = Run::of(&grid, Some(1)).unwrap().cells(0..grid.cells(), &|| true, put);
    let plan = SweepPlan::new("test", undamped, x, [member]).unwrap();
    let of_sweep = plan.run(Some(1), &|_| std::ops::ControlFlow::Continue(()));
    for error in [of_map.unwrap_err().to_string(), of_sweep.unwrap_err().to_string()] {
        for words in
            ["slope-bound cannot run at", "leave slope-bound out", "or give device.damping"]
        {
            assert!(error.contains(words), "{error}");
        }
    }
}

/// From 2⁵³ on an axis steps over whole numbers: two seeds would be one, or another than the one asked for.
#[test]
fn a_seed_that_an_axis_cannot_hold_is_refused() {
    let noisy = scene("effects.noise = { deviation = 1e-6, seed = 1 }");
    let planned = |range: &str| {
        let axis = format!("effects.noise.seed={range}").parse().unwrap();
        let plan = SweepPlan::new("test", noisy.clone(), axis, BasicName::ALL);
        plan.map(|_| ()).map_err(|error| error.to_string())
    };
    assert_eq!(planned("9007199254740989..9007199254740991:3"), Ok(()));
    for range in
        ["9007199254740991..9007199254740993:3", "0..9223372036854775807:3", "1e19..3e19:3"]
    {
        let error = planned(range).unwrap_err();
        assert!(
            error.contains("is too large for an axis") && error.contains("below 2^53"),
            "{error}"
        );
    }
}
