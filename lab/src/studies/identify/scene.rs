//! Scene of a fit, as TOML.

use std::fmt::Write as _;

use super::alone::Alone;
use super::estimate::Estimate;
use super::report::Report;
use crate::text::{legible, to_digits};

/// Share of a tick by which a log may end after the last one.
const ROUNDING: f64 = 1e-6;

/// The scene that `report` tells, every fitted number with its interval, of a device that is known `alone`; `origin` is the log's
/// position nearest to 0.
pub(super) fn toml(report: &Report, alone: Alone, origin: f64) -> String {
    let mut text = String::new();
    // Writing to a string never fails.
    let _ = write(&mut text, report, alone, origin);
    text
}

fn write(out: &mut String, report: &Report, alone: Alone, origin: f64) -> std::fmt::Result {
    // The sum has digits of its rounding behind the fifteenth.
    let place = |it: f64| to_digits(origin + tidy(it - origin), 15);
    write_times(out, report)?;
    writeln!(out, "\n[operator]\nstiffness = {}", told(&report.stiffness, "N/m", tidy))?;
    match &report.rest {
        Some(rest) => writeln!(out, "rest = {}", told(rest, "m", place))?,
        // The load is the force there.
        None if origin != 0.0 => writeln!(out, "rest = {origin:?}")?,
        None => {}
    }
    write_body(out, report, alone)?;
    let (position, velocity) = (place(report.start[0]), tidy(report.start[1]));
    writeln!(out, "\n[initial]\nposition = {position:?}\nvelocity = {velocity:?}")?;
    match &report.wall {
        Some(wall) => {
            writeln!(out, "\n[environment.wall]\nposition = {}", told(&wall.position, "m", place))?;
            writeln!(out, "stiffness = {}", told(&wall.stiffness, "N/m", tidy))?;
            writeln!(out, "damping = {}", told(&wall.damping, "N.s/m", tidy))?;
        }
        None => {
            let place = place(report.furthest);
            writeln!(
                out,
                "\n# The log tells no wall.\n[environment.wall]\nposition = {place:?}\nstiffness = 0.0"
            )?;
        }
    }
    write_effects(out, report)
}

/// The head, the duration and the rate.
fn write_times(out: &mut String, report: &Report) -> std::fmt::Result {
    let name = legible(&report.log);
    let intervals = if report.residual.is_pushed { "" } else { "95 % " };
    writeln!(
        out,
        "# Fitted to {name}: mass, damping, spring and wall with their {intervals}intervals."
    )?;
    let rate = tidy(tidy(report.mean_period).recip());
    // Whole ticks, up to the log's last row or beyond it.
    let ticks = (report.duration * rate - ROUNDING).ceil();
    let duration = tidy(ticks / rate);
    writeln!(
        out,
        "# Look at x: it should follow the log.\nduration = {duration:?}\nservo_rate = {rate:?}"
    )
}

/// The mass and the damping, those of a device that is known alone apart from the hand's.
fn write_body(out: &mut String, report: &Report, alone: Alone) -> std::fmt::Result {
    let parts = [
        ("mass", &report.mass, "kg", alone.mass),
        ("damping", &report.damping, "N.s/m", alone.damping),
    ];
    for (key, sum, unit, own) in parts {
        if let Some(own) = own {
            let [both, low, high] = sum.words();
            let rest = tidy(sum.value - own);
            writeln!(out, "{key} = {rest:?} # {unit}; with the device's {both}, {low} to {high}")?;
        }
    }
    writeln!(out, "\n[device]")?;
    for (key, sum, unit, own) in parts {
        match own {
            Some(own) => writeln!(out, "{key} = {own:?} # {unit}, as told")?,
            None => writeln!(out, "{key} = {}; of the hand too", told(sum, unit, tidy))?,
        }
    }
    Ok(())
}

fn write_effects(out: &mut String, report: &Report) -> std::fmt::Result {
    if let Some(resolution) = report.resolution {
        writeln!(out, "\n[effects.encoder]\nresolution = {:?}", tidy(resolution))?;
    }
    if let Some(wall) = report.wall.filter(|wall| wall.is_clipped) {
        writeln!(out, "\n[effects.saturation]\nforce = {:?}", tidy(wall.peak))?;
    }
    if report.delay() > 0 {
        writeln!(out, "\n[effects.delay]\nticks = {}", report.delay())?;
    }
    if report.rest.is_none() && report.load.value != 0.0 {
        writeln!(out, "\n[effects.load]\nforce = {}", told(&report.load, "N", tidy))?;
    }
    Ok(())
}

fn told(it: &Estimate, unit: &str, digits: impl Fn(f64) -> f64) -> String {
    let [_, low, high] = it.words();
    format!("{:?} # {unit}, {low} to {high}", digits(it.value))
}

/// A number with ten digits, since no log tells more, and 0 where a number of a scene is as good as that.
fn tidy(value: f64) -> f64 {
    const NOTHING: f64 = 1e-12;
    if value.abs() < NOTHING { 0.0 } else { to_digits(value, 10) }
}
