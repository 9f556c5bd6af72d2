//! Random logs: jitter, gaps, bad rows of every kind, units, and every candidate.

use approx::abs_diff_eq;
use lyapunov_lab::observe::{Candidate, Observed, Settings, observe};
use proptest::prelude::*;

use crate::observe::naive::{self, Row, Sample, Step};

/// Fault of a row.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    None,
    Gap,
    Force(&'static str),
    Position(&'static str),
    /// A bad position with an old force.
    Stale,
    Time(&'static str),
    Back,
    Short,
    Long,
    Blank,
}

#[derive(Clone, Copy, Debug)]
struct Drawn {
    jitter: f64,
    x: f64,
    f: f64,
    v: f64,
    fault: Fault,
}

#[derive(Clone, Debug)]
struct Log {
    drawn: Vec<Drawn>,
    factors: [f64; 4],
    has_velocity: bool,
    candidate: Candidate,
    threshold: f64,
}

fn fault() -> impl Strategy<Value = Fault> {
    prop_oneof![
        24 => Just(Fault::None),
        1 => Just(Fault::Gap),
        1 => prop_oneof![Just("NaN"), Just("-inf"), Just(""), Just("1,5"), Just("1e99")]
            .prop_map(Fault::Force),
        1 => prop_oneof![Just("nan"), Just("x"), Just("1.2.3")].prop_map(Fault::Position),
        1 => prop_oneof![Just("inf"), Just("12:30"), Just(" ")].prop_map(Fault::Time),
        1 => Just(Fault::Stale),
        1 => Just(Fault::Back),
        1 => Just(Fault::Short),
        1 => Just(Fault::Long),
        1 => Just(Fault::Blank),
    ]
}

fn log() -> impl Strategy<Value = Log> {
    let force = prop_oneof![2 => Just(0.0), 3 => -20.0..20.0_f64];
    let drawn = (0.0..0.4_f64, -0.01..0.01_f64, force, -1.0..1.0_f64, fault())
        .prop_map(|(jitter, x, f, v, fault)| Drawn { jitter, x, f, v, fault })
        .boxed();
    let candidate = prop_oneof![
        Just(Candidate::Spring),
        (0.0..5.0_f64).prop_map(|damping| Candidate::DeviceDamping { damping }),
        (0.0..5.0_f64, -0.01..0.01_f64)
            .prop_map(|(damping, surface)| Candidate::MassSpringDamper { damping, surface }),
    ];
    let factors = [
        prop_oneof![Just(1.0), Just(1e-3), Just(1e-6)].boxed(),
        prop_oneof![Just(1.0), Just(1e-3), Just(-0.0254)].boxed(),
        prop_oneof![Just(1.0), Just(-1.0), Just(4.448)].boxed(),
        prop_oneof![Just(1.0), Just(-1e-3)].boxed(),
    ];
    let rows = prop_oneof![
        proptest::collection::vec(drawn.clone(), 2..60),
        proptest::collection::vec(drawn, 900..1300)
    ];
    (rows, factors, any::<bool>(), candidate, 0.0..10.0_f64).prop_map(
        |(drawn, factors, has_velocity, candidate, threshold)| Log {
            drawn,
            factors,
            has_velocity,
            candidate,
            threshold,
        },
    )
}

impl Log {
    /// The log as text, and its rows in SI units.
    fn build(&self) -> (String, Vec<Row>) {
        let mut text =
            String::from(if self.has_velocity { "x,note,t,f,v\n" } else { "x,note,t,f\n" });
        let mut rows = Vec::new();
        let mut tick = 0.0;
        let mut time = -1.0;
        for drawn in &self.drawn {
            if drawn.fault == Fault::Blank {
                text += "\n";
            }
            tick += if drawn.fault == Fault::Gap { 7.0 } else { 1.0 };
            let back = matches!(drawn.fault, Fault::Back | Fault::Stale);
            time = if back { time - 0.5 } else { tick + drawn.jitter };
            let raw = [time * 1e-3 / self.factors[0], drawn.x / self.factors[1], drawn.f, drawn.v];
            rows.push(self.row(drawn, raw, &mut text));
            if back {
                time = tick;
            }
        }
        (text, rows)
    }

    fn row(&self, drawn: &Drawn, raw: [f64; 4], text: &mut String) -> Row {
        let [t, x, f, v] = raw.map(|number| format!("{number:?}"));
        let si = |index: usize| raw[index] * self.factors[index];
        let velocity = |v: String| if self.has_velocity { format!(",{v}") } else { String::new() };
        let (line, row) = match drawn.fault {
            Fault::Force(bad) if bad.contains(',') => {
                (format!("{x},a,{t},{bad}{}", velocity(v)), Row::Bad { t: None, f: None })
            }
            Fault::Force(bad) => {
                (format!("{x},a,{t},{bad}{}", velocity(v)), Row::Bad { t: Some(si(0)), f: None })
            }
            Fault::Position(bad) => (
                format!("{bad},a,{t},{f}{}", velocity(v)),
                Row::Bad { t: Some(si(0)), f: Some(si(2)) },
            ),
            Fault::Stale => {
                (format!("?,a,{t},{f}{}", velocity(v)), Row::Bad { t: Some(si(0)), f: Some(si(2)) })
            }
            Fault::Time(bad) => {
                (format!("{x},a,{bad},{f}{}", velocity(v)), Row::Bad { t: None, f: Some(si(2)) })
            }
            Fault::Short => (format!("{x},a,{t}"), Row::Bad { t: None, f: None }),
            Fault::Long => {
                (format!("{x},a,{t},{f}{},0", velocity(v)), Row::Bad { t: None, f: None })
            }
            Fault::None | Fault::Gap | Fault::Back | Fault::Blank => {
                let sample =
                    Sample { t: si(0), x: si(1), f: si(2), v: self.has_velocity.then(|| si(3)) };
                (format!("{x},\"a,b\", {t} ,{f}{}", velocity(v)), Row::Good(sample))
            }
        };
        *text += &line;
        text.push('\n');
        row
    }

    fn settings(&self) -> Settings {
        let columns = if self.has_velocity { "t,x,f,v" } else { "t,x,f" };
        let letters =
            ["t", "x", "f", "v"].into_iter().zip(self.factors).take(columns.len().div_ceil(2));
        Settings {
            columns: columns.parse().unwrap(),
            scales: letters
                .map(|(letter, factor)| format!("{letter}={factor:?}").parse().unwrap())
                .collect(),
            candidate: self.candidate,
            contact: Some(self.threshold),
            late: 0,
        }
    }

    fn credit(&self, step: &Step) -> f64 {
        match self.candidate {
            Candidate::Spring => 0.0,
            Candidate::DeviceDamping { damping } => damping * step.motion,
            Candidate::MassSpringDamper { damping, surface } if step.to.x > surface => {
                damping * step.motion
            }
            Candidate::MassSpringDamper { .. } => 0.0,
        }
    }
}

/// Asserts that values agree within the rounding of sums of this size.
fn near(name: &str, found: f64, expected: f64, size: f64) -> Result<(), TestCaseError> {
    prop_assert!(
        abs_diff_eq!(found, expected, epsilon = 1e-11 * size),
        "{name}: {found} is not {expected}"
    );
    Ok(())
}

/// Lowest and last value of a running sum, the first step below zero, and whether no value is too near zero to judge.
fn course(terms: impl Iterator<Item = f64>) -> (f64, f64, Option<usize>, bool) {
    let (mut sum, mut lowest, mut first, mut clear) = (0.0_f64, 0.0_f64, None, true);
    for (index, term) in terms.enumerate() {
        sum += term;
        lowest = lowest.min(sum);
        clear &= sum == 0.0 || sum.abs() > 1e-10;
        if sum < 0.0 && first.is_none() {
            first = Some(index);
        }
    }
    (lowest, sum, first, clear)
}

fn agrees(log: &Log) -> Result<(), TestCaseError> {
    let (text, rows) = log.build();
    let (steps, bad) = naive::steps(&rows);
    let observed = observe(text.as_bytes(), "random.csv", &log.settings());
    if steps.is_empty() {
        prop_assert!(observed.is_err());
        return Ok(());
    }
    let observed = observed.map_err(|error| TestCaseError::fail(error.to_string()))?;
    let report = &observed.report;
    prop_assert_eq!(report.bad_rows.count, bad);
    prop_assert_eq!(report.bad_rows.first.len() as u64, bad.min(10));
    prop_assert_eq!(report.rows, steps.len() as u64 + 1);
    prop_assert_eq!(report.gaps.count, steps.iter().filter(|step| step.gap).count() as u64);
    sums(log, &observed, &steps)?;
    damper(log, &observed, &steps)?;
    contacts(log, &observed, &steps)
}

fn sums(log: &Log, observed: &Observed, steps: &[Step]) -> Result<(), TestCaseError> {
    let report = &observed.report;
    let size = |term: &dyn Fn(&Step) -> f64| steps.iter().map(|step| term(step).abs()).sum::<f64>();
    let all = size(&|step| step.work) + size(&|step| step.sampled) + size(&|step| log.credit(step));
    let into: f64 = steps.iter().map(|step| step.work.max(0.0)).sum();
    let out: f64 = steps.iter().map(|step| -step.work.min(0.0)).sum();
    near("absorbed", report.energy.absorbed, into, all)?;
    near("released", report.energy.released, out, all)?;
    near("credited", report.energy.credited, size(&|step| log.credit(step)), all)?;
    let held = course(steps.iter().map(|step| step.work + log.credit(step)));
    let sampled = course(steps.iter().map(|step| step.sampled + log.credit(step)));
    for (sum, (lowest, last, first, clear)) in
        [(&report.observed_energy, held), (&report.printed, sampled)]
    {
        near("lowest", sum.lowest, lowest, all)?;
        near("last", sum.last, last, all)?;
        if clear {
            prop_assert_eq!(sum.negative_at, first.map(|index| steps[index].to.t));
        }
    }
    Ok(())
}

fn damper(log: &Log, observed: &Observed, steps: &[Step]) -> Result<(), TestCaseError> {
    let Some(damping) = observed.report.damper.damping else { return Ok(()) };
    // With that damping the sum never falls below zero, and with less it does.
    let (mut sum, mut size) = (0.0, 0.0);
    let mut lowest = f64::INFINITY;
    for step in steps {
        sum += step.work + log.credit(step) + damping * step.motion;
        size += step.work.abs() + log.credit(step) + damping * step.motion;
        lowest = lowest.min(sum);
    }
    prop_assert!(lowest >= -1e-11 * size, "{damping} N.s/m leave {lowest} J");
    prop_assert!(damping == 0.0 || lowest <= 1e-11 * size, "{damping} N.s/m are too much");
    Ok(())
}

fn contacts(log: &Log, observed: &Observed, steps: &[Step]) -> Result<(), TestCaseError> {
    let found = &observed.report.contacts;
    let all = naive::contacts(steps, log.threshold);
    prop_assert_eq!(found.count, all.len() as u64);
    let work = |step: &Step| step.work;
    let mut expected: Vec<(f64, f64, f64)> = all
        .iter()
        .map(|contact| {
            let part = &steps[contact.first..=contact.last];
            let generated = -part.iter().map(work).sum::<f64>();
            (generated, part[0].from.t, part[part.len() - 1].to.t)
        })
        .collect();
    expected.sort_by(|one, other| other.0.total_cmp(&one.0));
    let size = steps.iter().map(|step| step.work.abs()).sum::<f64>();
    prop_assert_eq!(found.worst.len(), expected.len().min(10));
    for (contact, (generated, ..)) in found.worst.iter().zip(&expected) {
        near("generated", contact.generated, *generated, size)?;
        let known =
            expected.iter().any(|(_, start, end)| (contact.start, contact.end) == (*start, *end));
        prop_assert!(known, "{contact:?}");
    }
    Ok(())
}

/// Asserts that the text fits the terminal and holds no NaN and no infinity.
fn fits(text: &str) -> Result<(), TestCaseError> {
    prop_assert!(text.lines().all(|line| line.chars().count() <= 100), "{text}");
    let quotes = |line: &&str| !line.trim().starts_with("line ") && !line.trim().starts_with("= ");
    for word in text.lines().filter(quotes).flat_map(str::split_whitespace) {
        prop_assert!(!["NaN", "inf", "-inf"].contains(&word), "{text}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn random_logs_agree_with_the_definitions(log in log()) {
        agrees(&log)?;
    }

    /// Any bytes give a report or an error, and either fits the terminal.
    #[test]
    fn any_bytes_give_a_report_or_an_error(rest in proptest::collection::vec(any::<u8>(), 0..400), fields in "[0-9eE.,+\\-\n\" naif;#]{0,400}") {
        for bytes in [rest.clone(), [b"t,x,f\n", &rest[..]].concat(), [b"t,x,f\n", fields.as_bytes()].concat()] {
            if let Ok(observed) = observe(&bytes[..], "bytes.csv", &Settings::default()) {
                fits(&observed.report.to_string())?;
                prop_assert!(observed.figure().to_svg().starts_with("<svg"));
            }
        }
    }

    /// With numbers of any size the results stay finite, and the report stays in its columns.
    #[test]
    fn numbers_of_any_size_fit(rows in proptest::collection::vec((1e-30..1e30_f64, -200..60_i32, -200..60_i32), 3..40)) {
        let mut text = String::from("t,x,f\n");
        let mut time = -1e9;
        for (number, x, f) in rows {
            time += number;
            text += &format!("{time:?},{:?},{:?}\n", number * 10_f64.powi(x), -number * 10_f64.powi(f));
        }
        if let Ok(observed) = observe(text.as_bytes(), "large.csv", &Settings::default()) {
            fits(&observed.report.to_string())?;
        }
    }
}
