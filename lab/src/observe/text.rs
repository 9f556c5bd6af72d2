//! A report for the terminal.

use std::fmt;

use super::candidate::Candidate;
use super::contact::{Contact, SHARE};
use super::report::Report;
use super::step::GAP;
use super::sum::Sum;
use super::traces::prefix;
use crate::scene::printable;
use crate::summary::Number;

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let units = Units::of(self);
        let name: String = self.log.chars().map(printable).collect();
        writeln!(f, "{name}: {} rows over {} s", self.rows, Number(self.duration))?;
        self.write_rows(f, &units)?;
        self.write_sums(f, &units)?;
        self.write_contacts(f, &units)
    }
}

/// The units and decimals that suit a report.
struct Units {
    /// Decimals of a time stamp, so that neighbouring rows differ.
    decimals: usize,
    joule: f64,
    joules: String,
}

impl Units {
    fn of(report: &Report) -> Self {
        let digits = -report.median_period.log10().floor();
        let sums = [report.observer.lowest, report.observer.last, report.printed.last];
        let energies = [report.energy.absorbed, report.energy.released].into_iter().chain(sums);
        let (joule, prefix) = prefix(energies.fold(0.0, |most, energy| most.max(energy.abs())));
        let decimals = if digits.is_finite() { digits.clamp(0.0, 9.0) as usize + 1 } else { 3 };
        Self { decimals, joule, joules: format!("{prefix}J") }
    }

    fn time(&self, time: f64) -> String {
        // Beyond this a decimal is no longer that of the number, but of its conversion.
        if time.abs() < 1e12 {
            format!("{time:.*}", self.decimals)
        } else {
            Number(time).to_string()
        }
    }

    fn energy(&self, joules: f64) -> String {
        format!("{} {}", Number(self.joule * joules), self.joules)
    }
}

impl Report {
    fn write_rows(&self, f: &mut fmt::Formatter<'_>, units: &Units) -> fmt::Result {
        let period = self.median_period;
        writeln!(
            f,
            "  time        from {} s to {} s, median period {} ms",
            units.time(self.start),
            units.time(self.end),
            Number(1e3 * period)
        )?;
        let limit = Number(1e3 * GAP * period);
        write!(f, "  gaps        ")?;
        match self.gaps.longest {
            None => writeln!(f, "none (no step is longer than {limit} ms)")?,
            Some(gap) => writeln!(
                f,
                "{} ({} over bad rows), {} s in all; the longest {} s after line {}, t = {} s",
                self.gaps.count,
                self.gaps.over_bad_rows,
                Number(self.gaps.time),
                Number(gap.length),
                gap.line,
                units.time(gap.start)
            )?,
        }
        let bad = &self.bad_rows;
        match bad.count {
            0 => writeln!(f, "  bad rows    none")?,
            count => {
                writeln!(f, "  bad rows    {count}, left out; the next good row spans the gap")?
            }
        }
        for row in &bad.first {
            writeln!(f, "              line {}: {}", row.line, row.reason)?;
        }
        let more = bad.count.saturating_sub(bad.first.len() as u64);
        if more > 0 {
            writeln!(f, "              and {more} more")?;
        }
        match bad.remedy() {
            Some(remedy) => writeln!(f, "              = {remedy}"),
            None => Ok(()),
        }
    }

    fn write_sums(&self, f: &mut fmt::Formatter<'_>, units: &Units) -> fmt::Result {
        let energy = |joules| units.energy(joules);
        let net = self.energy.generated;
        writeln!(
            f,
            "  port        {} in, {} out: {} {}",
            energy(self.energy.absorbed),
            energy(self.energy.released),
            energy(net.abs()),
            if net > 0.0 { "generated" } else { "absorbed" }
        )?;
        if self.candidate != Candidate::Spring {
            let (name, credit) = (self.candidate.name(), energy(self.energy.credited));
            writeln!(f, "  credit      {credit} by the candidate {name}")?;
        }
        write_sum(f, "observer    held work: ", &self.observer, units)?;
        write_sum(f, "printed     sampled work: ", &self.printed, units)?;
        match (self.repair.damping, self.repair.at) {
            (_, None) => writeln!(f, "  damping     none is needed")?,
            (None, Some(time)) => {
                let time = units.time(time);
                writeln!(
                    f,
                    "  damping     none repairs the debt at t = {time} s: nothing had moved"
                )?;
            }
            (Some(damping), Some(time)) => writeln!(
                f,
                "  damping     {} N.s/m from the start would have repaired it all; most is needed at {} s",
                Number(damping),
                units.time(time)
            )?,
        }
        if self.starts_in_contact {
            writeln!(
                f,
                "  note        the log begins in contact: what was stored before may come out as a debt"
            )?;
        }
        Ok(())
    }

    fn write_contacts(&self, f: &mut fmt::Formatter<'_>, units: &Units) -> fmt::Result {
        let contacts = &self.contacts;
        let threshold = Number(contacts.threshold);
        let share = format!("{} % of the largest", Number(100.0 * SHARE));
        let rule =
            if contacts.threshold_follows { format!(", {share} so far") } else { String::new() };
        write!(
            f,
            "  contacts    {} (above {threshold} N{rule}), {} generated energy",
            contacts.count, contacts.generating
        )?;
        if contacts.worst.is_empty() {
            return Ok(());
        }
        writeln!(f, "; the worst:")?;
        let joules = &units.joules;
        write!(
            f,
            "  {:>12} {:>12} {:>11} {:>11} {:>13} {:>10} {:>14}",
            "from, s",
            "to, s",
            format!("in, {joules}"),
            format!("out, {joules}"),
            format!("generated, {joules}"),
            "peak, N",
            "repair, N.s/m"
        )?;
        contacts.worst.iter().try_for_each(|contact| write_contact(f, contact, units))
    }
}

fn write_sum(f: &mut fmt::Formatter<'_>, name: &str, sum: &Sum, units: &Units) -> fmt::Result {
    write!(f, "  {name}{} at the end", units.energy(sum.last))?;
    let Some(first) = sum.negative_at else {
        return writeln!(f, "; never below zero");
    };
    writeln!(f, ", lowest {} at {} s", units.energy(sum.lowest), units.time(sum.lowest_at))?;
    let count = match sum.debts {
        1 => "once".to_owned(),
        count => format!("{count} times"),
    };
    write!(f, "              below zero {count}, first at {} s", units.time(first))?;
    let later: Vec<String> =
        sum.first_debts.iter().skip(1).take(5).map(|debt| units.time(debt.start)).collect();
    match later.len() {
        0 => writeln!(f),
        told => {
            let more = if sum.debts > told as u64 + 1 { ", ..." } else { "" };
            writeln!(f, ", then {}{more}", later.join(", "))
        }
    }
}

fn write_contact(f: &mut fmt::Formatter<'_>, contact: &Contact, units: &Units) -> fmt::Result {
    let energy = |joules: f64| Number(units.joule * joules).to_string();
    let repair = contact.damping.map_or("none".to_owned(), |damping| Number(damping).to_string());
    write!(
        f,
        "\n  {:>12} {:>12} {:>11} {:>11} {:>13} {:>10} {:>14}",
        units.time(contact.start),
        units.time(contact.end),
        energy(contact.absorbed),
        energy(contact.released),
        energy(contact.generated),
        Number(contact.peak_force).to_string(),
        repair
    )
}
