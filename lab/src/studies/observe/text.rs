//! Text of a report for the terminal.

use std::fmt;

use super::candidate::Candidate;
use super::contact::{Contact, SHARE};
use super::observed_energy::ObservedEnergy;
use super::report::Report;
use crate::files::log::{GAP, described};
use crate::show::table::{Cell, Heading, Table};
use crate::text::{counted, folded, found, legible, prefix};

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.lines())?;
        let indented = |table: Table| textwrap::indent(table.to_string().trim_end(), "  ");
        if let Some(table) = self.worst_contacts() {
            write!(f, "\n{}", indented(table))?;
        }
        match &self.replay {
            None => Ok(()),
            Some(replay) => {
                write!(f, "\n\n{}\n{}", replay.lines(), replay.table())?;
                write!(f, "{}", folded("  note        ", replay.note))
            }
        }
    }
}

/// Lines of a report, without the table of its contacts.
struct Lines<'a>(&'a Report);

impl fmt::Display for Lines<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let report = self.0;
        let units = Units::of(report);
        let name = legible(&report.log);
        write!(f, "{name}: {} rows over {} s", report.rows, found(report.duration))?;
        report.write_columns(f)?;
        report.write_rows(f, &units)?;
        report.write_sums(f, &units)?;
        report.notes.iter().try_for_each(|it| line(f, "note", it))?;
        report.look_at.iter().try_for_each(|it| line(f, "look at", &it.text))?;
        report.write_contacts(f)
    }
}

/// Writes a new line with its label and its text, folded.
fn line(f: &mut fmt::Formatter<'_>, label: &str, text: &str) -> fmt::Result {
    write!(f, "\n{}", folded(&format!("  {label:<12}"), text))
}

/// Units and decimals that suit a report.
struct Units {
    /// Decimals of a time stamp, so that neighbouring rows differ.
    decimals: usize,
    joule: f64,
    joules: String,
}

impl Units {
    fn of(report: &Report) -> Self {
        // One digit more than the period needs, but no more than the time stamps have.
        let period = (-report.median_period.log10().floor()).clamp(0.0, 9.0) + 1.0;
        let latest = report.start.abs().max(report.end.abs()).max(1.0);
        let decimals = period.min((14.0 - latest.log10().floor()).max(0.0)) as usize;
        let sums =
            [report.observed_energy.lowest, report.observed_energy.last, report.printed.last];
        let energies = [report.energy.absorbed, report.energy.released].into_iter().chain(sums);
        let (joule, prefix) = prefix(energies.fold(0.0, |most, energy| most.max(energy.abs())));
        Self { decimals, joule, joules: format!("{prefix}J") }
    }

    fn time(&self, time: f64) -> String {
        if time.abs() >= 1e15 {
            return found(time).to_string();
        }
        let text = format!("{time:.*}", self.decimals);
        match text.strip_prefix('-') {
            Some(size) if size.chars().all(|it| "0.".contains(it)) => size.to_owned(),
            _ => text,
        }
    }

    fn energy(&self, joules: f64) -> String {
        format!("{} {}", found(self.joule * joules), self.joules)
    }
}

impl Report {
    /// Writes what was read from the headings and not asked for, and by how many rows the force was told to be late.
    fn write_columns(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let told = described(&self.columns, self.decimal_commas);
        told.map_or(Ok(()), |told| line(f, "columns", &told))?;
        let told = format!("f acts {} after its own, as told", counted(self.late as usize, "row"));
        if self.late > 0 { line(f, "late", &told) } else { Ok(()) }
    }

    fn write_rows(&self, f: &mut fmt::Formatter<'_>, units: &Units) -> fmt::Result {
        let (start, end) = (units.time(self.start), units.time(self.end));
        let period = found(1e3 * self.median_period);
        line(f, "time", &format!("from {start} s to {end} s, median period {period} ms"))?;
        let limit = found(1e3 * GAP * self.median_period);
        let gaps = match self.gaps.longest {
            None => format!("none: no step is longer than {limit} ms"),
            Some(gap) => format!(
                "{} longer than {limit} ms, {} of them over bad rows, {} s in all; the longest \
                 {} s after line {}, t = {} s",
                self.gaps.count,
                self.gaps.over_bad_rows,
                found(self.gaps.time),
                found(gap.length),
                gap.line,
                units.time(gap.start)
            ),
        };
        line(f, "gaps", &gaps)?;
        self.write_bad_rows(f)
    }

    fn write_bad_rows(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let lines = self.bad_rows_told();
        let Some((first, more)) = lines.split_first() else {
            return line(f, "bad rows", "none");
        };
        line(f, "bad rows", first)?;
        more.iter().try_for_each(|it| line(f, "", it))
    }

    fn write_sums(&self, f: &mut fmt::Formatter<'_>, units: &Units) -> fmt::Result {
        let energy = |joules| units.energy(joules);
        let net = self.energy.generated;
        let verdict = if net > 0.0 { "generated" } else { "absorbed" };
        let (absorbed, released) = (energy(self.energy.absorbed), energy(self.energy.released));
        let net = energy(net.abs());
        line(f, "port", &format!("{absorbed} in, {released} out: {net} {verdict}"))?;
        if self.candidate != Candidate::Spring {
            let (name, credit) = (self.candidate.name(), energy(self.energy.credited));
            line(f, "credit", &format!("{credit} by the candidate {name}"))?;
        }
        line(
            f,
            "observed",
            &format!("energy of held work: {}", told(&self.observed_energy, units)),
        )?;
        let blind = match (self.observed_energy.negative_at, self.printed.negative_at) {
            (Some(_), None) => ": it sees no debt",
            _ => "",
        };
        line(f, "sampled", &format!("the paper's own sum: {}{blind}", told(&self.printed, units)))?;
        line(f, "damping", &self.damping(units))?;
        let note = match (self.starts_in_contact, self.ends_in_contact) {
            (true, false) => "the log begins in contact: what was stored before may come out",
            (false, true) => "the log ends in contact: what is stored then may still come out",
            (true, true) => "the log begins and ends in contact: part of the sum is stored energy",
            (false, false) => return Ok(()),
        };
        line(f, "note", note)
    }

    fn damping(&self, units: &Units) -> String {
        match (self.damper.damping, self.damper.at.map(|time| units.time(time))) {
            (_, None) => "no debt asks for any".to_owned(),
            (None, Some(time)) => {
                format!("none makes up for the debt at {time} s: nothing had moved")
            }
            (Some(damping), Some(time)) => format!(
                "over this motion the debts ask for a constant {} N.s/m, at {time} s; damped, the motion would have been \
                 another",
                found(damping)
            ),
        }
    }

    /// The lines about bad rows.
    pub(super) fn bad_rows_told(&self) -> Vec<String> {
        self.bad_rows.lines("; the next good row spans the gap")
    }

    /// All lines but the table of contacts.
    pub(super) fn lines(&self) -> String {
        Lines(self).to_string()
    }

    fn write_contacts(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let contacts = &self.contacts;
        let follows = if contacts.threshold_follows {
            format!(", {} % of the largest force so far", 100.0 * SHARE)
        } else {
            String::new()
        };
        let threshold = found(contacts.threshold);
        let (count, generating) = (contacts.count, contacts.generating);
        let below = match contacts.worst.len() as u64 {
            0 => String::new(),
            told if told < count => format!("; the {told} worst of {count} below"),
            _ => "; below, the worst first".to_owned(),
        };
        let text =
            format!("{count}, {generating} generated energy (|f| > {threshold} N{follows}){below}");
        line(f, "contacts", &text)
    }

    /// The contacts that generated most; none without a contact.
    pub(super) fn worst_contacts(&self) -> Option<Table> {
        let (contacts, units) = (&self.contacts, Units::of(self));
        if contacts.worst.is_empty() {
            return None;
        }
        let joules = &units.joules;
        let headings = [
            "from\ns".to_owned(),
            "to\ns".to_owned(),
            format!("in\n{joules}"),
            format!("out\n{joules}"),
            format!("generated\n{joules}"),
            "peak\nN".to_owned(),
            "damper\nN.s/m".to_owned(),
        ];
        let rows = contacts.worst.iter().map(|contact| cells(contact, &units));
        Some(Table::new(headings.map(Heading::number)).with_rows(rows))
    }
}

/// History of an observed energy in words.
fn told(sum: &ObservedEnergy, units: &Units) -> String {
    let last = units.energy(sum.last);
    let Some(first) = sum.negative_at else {
        return format!("{last} at the end; never below zero");
    };
    let count = if sum.debts == 1 { "once".to_owned() } else { format!("{} times", sum.debts) };
    let mut text = format!(
        "{last} at the end, lowest {} at {} s; below zero {count}, first at {} s",
        units.energy(sum.lowest),
        units.time(sum.lowest_at),
        units.time(first)
    );
    let later = sum.first_debts.iter().skip(1).map(|debt| units.time(debt.start));
    let later: Vec<String> = later.take(5).collect();
    if !later.is_empty() {
        let more = if sum.debts > later.len() as u64 + 1 { ", ..." } else { "" };
        text += &format!(", then {}{more}", later.join(", "));
    }
    text
}

fn cells(contact: &Contact, units: &Units) -> [Cell; 7] {
    let energy = |joules: f64| Cell::from(units.joule * joules);
    [
        units.time(contact.start).into(),
        units.time(contact.end).into(),
        energy(contact.absorbed),
        energy(contact.released),
        energy(contact.generated),
        contact.peak_force.into(),
        contact.damping.map_or_else(|| "none".into(), Cell::from),
    ]
}
