//! Explanation in words.

use std::fmt;

use super::goal::Goal;
use super::hint::{LEFT, broken};
use super::{Change, DimensionlessGroups, Explanation, Remedy};
use crate::files::scene::Integrator;
use crate::measure::summary::MILLI;
use crate::measure::{Balance, LinearPart};
use crate::show::described;
use crate::show::table::{Cell, Heading, Table};
use crate::show::verdict::by_speed;
use crate::text::{counted, folded, found, given, near_one};

impl fmt::Display for Explanation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", Heads(self))?;
        writeln!(f)?;
        self.write_balances(f)?;
        if let Some(lack) = self.lack() {
            return writeln!(f, "\n{}", folded("  ", &lack));
        }
        writeln!(f, "\n  what helps, each {}", self.tried())?;
        for remedy in &self.remedies {
            writeln!(f, "  - {}", Told(remedy))?;
        }
        let is_cap = |(key, _): &(String, Change)| key.ends_with(".damping_cap");
        if self.remedies.iter().any(|remedy| remedy.changes.iter().any(is_cap)) {
            writeln!(
                f,
                "  a damping_cap here is the first that holds, not the best: see `lyapunov tune`"
            )?;
        }
        Ok(())
    }
}

/// What formulas about one axis tell of a scene in a space.
const IN_SPACE: &str = "radius, limits and groups are along the normal of the surface, as if it were flat; what its curvature \
    or an edge does is in the energies and the runs only";

/// Lines above the balance: the verdict, what is broken, and the groups.
pub(super) struct Heads<'a>(pub(super) &'a Explanation);

impl fmt::Display for Heads<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.write_verdict(f)?;
        self.0.write_groups(f)
    }
}

impl Explanation {
    fn write_verdict(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let by = by_speed(&self.scene).map_or_else(String::new, |by| format!(", {by}"));
        writeln!(f, "  verdict      {}{by}", self.verdict)?;
        if self.peak_force != 0.0 && self.verdict.is_bounded() {
            writeln!(f, "  this run     {}", Felt(self.peak_force, self.force_error))?;
        }
        if let Some(radius) = self.limits.spectral_radius {
            let is_stable = radius < 1.0;
            let what = if is_stable { "stable" } else { "not stable" };
            let alone =
                if self.scene.stabilizer.is_some() { " without its stabilizer" } else { "" };
            let radius = near_one(radius, 8);
            writeln!(f, "  linear loop  {what} in contact{alone}: spectral radius {radius}")?;
            let part = LinearPart::of(&self.scene).ok().filter(|_| is_stable);
            if let Some((place, radius)) = part.and_then(|it| it.unstable_elsewhere(&self.scene)) {
                writeln!(f, "               not{place}: {}", near_one(radius, 8))?;
            }
        }
        if self.scene.dimensions() > 1 {
            writeln!(f, "{}", folded("  in space     ", IN_SPACE))?;
        }
        let over = broken(&self.limits);
        for (_, name, most, times) in &over {
            match times {
                Some(times) => writeln!(
                    f,
                    "  broken       {name}: at most {} N/m, the scene has {} times that",
                    found(*most),
                    found(*times)
                )?,
                None => writeln!(f, "  broken       {name}: no stiffness passes")?,
            }
        }
        if over.is_empty() {
            writeln!(f, "  broken       no limit that applies")?;
        }
        if let Some(sentence) = described::exceeded_cap(&self.scene) {
            writeln!(f, "  cap          {sentence}")?;
        }
        let mut signs = self.look_at.iter();
        signs.try_for_each(|it| writeln!(f, "{}", folded("  look at      ", &it.text)))
    }

    fn write_groups(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let DimensionlessGroups { krt_over_b, kr2t2_over_m, brt_over_m, delay_ticks } = self.groups;
        let told = |value: Option<f64>| value.map_or("-".to_owned(), |it| found(it).to_string());
        write!(
            f,
            "  groups       K r T / b = {}, K (r T)^2 / m = {}, B r T / m = {}, delay {}",
            told(krt_over_b),
            told(kr2t2_over_m),
            told(brt_over_m),
            counted(delay_ticks.into(), "tick")
        )?;
        if krt_over_b.is_some() && delay_ticks == 0 {
            let rule = "K r T / b below 2 is passive, of a plain spring without delay";
            write!(f, ";\n{:15}{rule}", "")?;
        }
        writeln!(f)
    }

    /// The way in which the remedies were tried, and the outcome of all of them.
    pub(super) fn tried(&self) -> String {
        let alone = self.scene.stabilizer.is_none();
        let without = if alone { "" } else { " and without the scene's stabilizer" };
        let outcome = self.goal().map_or("", Goal::words);
        format!("by itself{without}; all were run, and {outcome}")
    }

    /// The reason why there is no contact.
    pub(super) fn untouched(&self) -> &'static str {
        if self.is_beyond() { LEFT } else { "the environment was never touched" }
    }

    pub(super) fn idle(&self) -> &'static str {
        if self.is_beyond() { "no force could act" } else { "no force acts in this run" }
    }

    fn is_beyond(&self) -> bool {
        self.left_range && self.peak_force == 0.0
    }

    fn write_balances(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Some(first) = &self.first_contact else {
            return writeln!(f, "  {}", self.untouched());
        };
        f.write_str(&textwrap::indent(&self.balances(first).to_string(), "  "))?;
        let (leak, energy) = first.largest_leak();
        if -first.wall > energy.max(0.0) {
            let why = match self.scene.environment.kind().is_active() {
                true => "which gives energy by its own law",
                false => "where it was stored at the start",
            };
            writeln!(f, "\n  most came from the environment, {why}")?;
        } else if self.approximates() && first.closing.abs() > energy.max(0.0) {
            writeln!(
                f,
                "\n  most came from or went to the integrator's own error: take \"exact\", or more steps"
            )?;
        } else if energy > 0.0 {
            writeln!(f, "\n  largest leak of the first contact: the {leak}")?;
        }
        Ok(())
    }

    /// The energies of the `first` contact and of the whole run, line by line.
    pub(super) fn balances(&self, first: &Balance) -> Table {
        let stretch =
            |balance: &Balance| format!("{} to {} s", given(balance.from_s), given(balance.to_s));
        let headings = [
            Heading::word("energy in mJ"),
            Heading::number(format!("first contact\n{}", stretch(first))),
            Heading::number(format!("whole run\n{}", stretch(&self.whole_run))),
        ];
        let rows = self.energies(first).into_iter().map(|(name, energies)| {
            let [first, whole] = energies.map(|energy| Cell::from(MILLI * energy));
            [name.into(), first, whole]
        });
        Table::new(headings).with_rows(rows)
    }

    /// Each cause's name, and what it moved in the `first` contact and in the whole run, J; without what moved nothing.
    pub fn energies(&self, first: &Balance) -> Vec<(String, [f64; 2])> {
        let lines = lines(first).into_iter().zip(lines(&self.whole_run));
        let moved = lines.filter(|((_, first), (_, whole))| [*first, *whole] != [0.0, 0.0]);
        moved.map(|((name, first), (_, whole))| (self.line(name), [first, whole])).collect()
    }

    /// A line's name: what takes the remainder names all that is in it.
    fn line(&self, name: &str) -> String {
        let effects = &self.scene.effects;
        let mut known = Vec::new();
        for (name, is_there) in [
            ("friction", effects.friction.is_some()),
            ("jitter", effects.jitter.is_some()),
            ("integrator", self.approximates()),
        ] {
            if is_there {
                known.push(name);
            }
        }
        match name {
            FRICTION => format!("out   into {}", known.join(", ")),
            CLOSING if !known.is_empty() => format!("left  to {}", known.join(", ")),
            _ => name.to_owned(),
        }
    }

    /// Whether an integrator moves the plant, with errors of its own.
    pub(super) fn approximates(&self) -> bool {
        self.scene.integrator != Integrator::Exact
    }
}

/// The names of the two lines that take the remainder.
const FRICTION: &str = "out   into friction";
const CLOSING: &str = "left  to rounding";

/// The lines of a balance.
fn lines(of: &Balance) -> [(&'static str, f64); 15] {
    [
        ("in    through the hold", of.hold),
        ("in    through the delay", of.delay),
        ("in    through the filter", of.filter),
        ("in    through the encoder", of.encoder),
        ("in    through the saturation", of.saturation),
        ("in    from the hand (motion, grip)", of.hand),
        ("in    from load and pulse", of.push),
        ("out   into the device's damper", of.device),
        ("out   into the operator's damper", of.operator),
        ("out   into the link's damper", of.link),
        (FRICTION, of.friction),
        ("out   into the wall, by its law", of.wall),
        ("out   into the controller", of.controller),
        ("kept  in masses and springs", of.gained),
        (CLOSING, of.closing),
    ]
}

/// Largest force of a run, and the error of its force, if it has one.
struct Felt(f64, Option<f64>);

impl fmt::Display for Felt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(peak, error) = self;
        write!(f, "peak force {} N", found(*peak))?;
        match error {
            Some(error) => {
                write!(f, ", off the environment's own force by {} N (rms)", found(*error))
            }
            None => Ok(()),
        }
    }
}

/// Remedy in a line.
pub(super) struct Told<'a>(pub(super) &'a Remedy);

impl fmt::Display for Told<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Remedy { changes, verdict, peak_force, force_error, scene } = self.0;
        let told = changes.iter().map(|(key, change)| match change {
            Change::Number(number) => format!("{key} = {}", given(*number)),
            Change::Word(word) => format!("{key} = \"{word}\""),
        });
        write!(f, "{}\n    {verdict}: ", told.collect::<Vec<_>>().join(", "))?;
        if *peak_force == 0.0 {
            return write!(f, "no force acts: the environment is not touched any more");
        }
        write!(f, "{}", Felt(*peak_force, *force_error))?;
        // A delay is a number of ticks, which another rate makes shorter.
        if changes.iter().any(|(key, _)| key == "servo_rate") && scene.delay_ticks() > 0 {
            let late = scene.period() * f64::from(scene.delay_ticks());
            write!(f, "\n    its delay is then {} ms, as many ticks as before", found(1e3 * late))?;
        }
        Ok(())
    }
}
