//! Writer of queries: the step of every member, run on symbols, as files for solvers.

mod exact;
mod fresh;
mod gappa;
mod ledger;
mod loose;
mod members;
mod paths;
mod properties;
#[cfg(test)]
mod real;
mod seen;
mod smt;
mod symbolic;
mod tape;

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;

use members::Member;
use properties::{Kind, PROPERTIES, Property};
use seen::Seen;
use smt::{F16, F32, F64, Format, Query};
use symbolic::{Symbolic, Truth};

fn main() -> io::Result<()> {
    let folder: PathBuf = std::env::args().nth(1).unwrap_or_else(|| "queries".to_owned()).into();
    fs::create_dir_all(&folder)?;
    let mut writer =
        Writer { index: fs::File::create(folder.join("index.tsv"))?, folder, mutant: "" };
    for (axes, members) in [(1, members::on_one_axis()), (3, members::on_three_axes())] {
        for member in members {
            tape::clear();
            writer.member(&member, axes, &(member.seen)())?;
        }
    }
    for claim in exact::CLAIMS {
        tape::clear();
        writer.query(claim.name, "holds", Format::Reals, 1, "unsat", &claim.query())?;
        writer.query(claim.name, "possible", Format::Reals, 1, "sat", &claim.possible())?;
    }
    for format in [F16, F32, F64] {
        tape::clear();
        let about = ["ledger-plain", "rounding", format.name(), "gappa"];
        writer.file(about, 1, "proved", &ledger::plain(format))?;
    }
    tape::clear();
    // No solver at hand decides it; docs/proofs.md derives it.
    let about = ["ledger-compensated", "rounding", "f16", "smt2"];
    writer.file(about, 1, "open", &ledger::compensated())?;
    for (name, mutant) in tape::Mutant::ALL {
        tape::mutate(Some(mutant));
        writer.mutant = name;
        tape::clear();
        let popc = &members::on_one_axis()[1];
        let seen = (popc.seen)();
        // What is asked is not mutated.
        tape::mutate(None);
        writer.member(popc, 1, &seen)?;
    }
    Ok(())
}

/// Writer of queries and of the index that lists them.
struct Writer {
    folder: PathBuf,
    index: fs::File,
    /// The mutant whose arithmetic was recorded; of a mutant one of the queries must fail.
    mutant: &'static str,
}

impl Writer {
    fn file(
        &mut self,
        [member, property, format, kind]: [&str; 4],
        axes: u32,
        expected: &str,
        text: &str,
    ) -> io::Result<()> {
        let mutant = self.mutant;
        let marked = if mutant.is_empty() { String::new() } else { format!("-{mutant}") };
        let file = format!("{member}-{property}-{format}-{axes}{marked}.{kind}");
        fs::write(self.folder.join(&file), text)?;
        writeln!(self.index, "{file}\t{member}\t{property}\t{format}\t{axes}\t{expected}\t{mutant}")
    }

    fn query(
        &mut self,
        member: &str,
        property: &str,
        format: Format,
        axes: u32,
        expected: &str,
        query: &Query,
    ) -> io::Result<()> {
        self.file([member, property, format.name(), "smt2"], axes, expected, &query.text(format))
    }

    /// The queries of one member: over every format at once, bit by bit where that is needed, and about paths.
    fn member(&mut self, member: &Member, axes: u32, seen: &[Seen]) -> io::Result<()> {
        for property in PROPERTIES.iter().filter(|it| asked_of(it, member, axes)) {
            if property.name != "served-least" {
                let query = query(property, seen, vec![]);
                self.query(member.name, property.name, Format::Every, axes, "unsat", &query)?;
            }
            for format in bit_by_bit(property, member, axes) {
                let cuts = seen.iter().flat_map(property.cuts).collect();
                let query = query(property, seen, cuts);
                self.query(member.name, property.name, *format, axes, "unsat", &query)?;
            }
        }
        for (number, path) in seen.iter().enumerate() {
            let query = Query { cases: vec![path.given.clone()], cuts: vec![] };
            self.query(member.name, &format!("path-{}", number + 1), F16, axes, "sat", &query)?;
        }
        if member.kind == Kind::Serves {
            for format in [F16, F32, F64] {
                for (range, script) in gappa::scripts(&seen[0], format) {
                    let property = format!("served-{range}");
                    self.file(
                        [member.name, &property, format.name(), "gappa"],
                        axes,
                        "proved",
                        &script,
                    )?;
                }
            }
        }
        Ok(())
    }
}

/// The formats in which `property` is also asked bit by bit: where the axioms of rounding do not decide, and of one member to
/// hold the axioms against the bits.
fn bit_by_bit(property: &Property, member: &Member, axes: u32) -> &'static [Format] {
    match (member.name, property.name) {
        ("popc", "within" | "line") => &[],
        ("popc", _) if axes == 1 => &[F16, F32, F64],
        (_, "served-least") if axes == 1 => &[F16, F32, F64],
        _ => &[],
    }
}

/// Whether `property` is one of `member`.
fn asked_of(property: &Property, member: &Member, axes: u32) -> bool {
    match property.of {
        // Without a stabilizer everything passes. Where a sample is rejected a watchdog holds a force, and of several
        // stabilizers those whose axes are sound give theirs.
        Kind::Any => !matches!(
            (member.name, property.name),
            ("none", "untimed" | "finite") | ("popc-watched" | "per-axis", "rejected")
        ),
        // Along a slanted direction a correction opposes the motion as a whole.
        Kind::Shapes if (member.name, property.name, axes) == ("popc-directed", "opposes", 3) => {
            false
        }
        Kind::Shapes => matches!(member.kind, Kind::Shapes | Kind::Damps | Kind::Serves),
        Kind::Damps => matches!(member.kind, Kind::Damps | Kind::Serves),
        kind => kind == member.kind,
    }
}

/// A path on which `property` does not hold.
fn query(property: &Property, seen: &[Seen], cuts: Vec<Symbolic>) -> Query {
    let case = |path: &Seen| -> Vec<Truth> {
        path.given.iter().copied().chain([!(property.goal)(path)]).collect()
    };
    let cases = seen.iter().map(case).collect();
    Query { cases, cuts }
}
