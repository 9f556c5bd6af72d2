//! Observers over the steps of a log.

use lyapunov::{Held, Ledger, Observer, Sampled, Work, accumulators::Compensated};

use super::Settings;
use super::candidate::Credited;
use super::contact::{Finder, Push};
use super::late::Late;
use super::observed_energy::ObservedEnergy;
use super::replay::Listener;
use super::report::{ConstantDamper, Energy, Report};
use super::step::{Gaps, Step};
use super::tally::Tally;
use super::traces::Traces;
use crate::files::log::{Bad, BadRows, Entry, LogError, Sample, median_period};
use crate::measure::sanity::LogSigns;

/// Number of steps that the median period is estimated from; they wait until it is known.
const WAITING: usize = 1024;

/// An observer with compensated summation, so that a long log loses nothing.
type Observing<W> = Observer<Credited, W, Compensated<f64>>;

/// The observers over the steps of a log, with everything that a report needs.
#[derive(Debug)]
pub(super) struct Watch {
    late: Late,
    rows: u64,
    bad: BadRows,
    first: Option<Sample>,
    last: Option<Sample>,
    /// Whether there are bad rows since the last good one, and the range of their forces.
    spans: bool,
    forces: Option<(f64, f64)>,
    waiting: Vec<Step>,
    period: Option<f64>,
    account: Books,
}

impl Watch {
    pub(super) fn new(
        candidate: Credited,
        settings: &Settings,
        listener: Option<Box<dyn Listener>>,
    ) -> Self {
        Self {
            late: Late::by(settings.late),
            rows: 0,
            bad: BadRows::default(),
            first: None,
            last: None,
            spans: false,
            forces: None,
            waiting: Vec::with_capacity(WAITING),
            period: None,
            account: Books::new(candidate, settings.contact, listener),
        }
    }

    pub(super) fn add(&mut self, entry: &Entry<'_>) {
        let Some(acting) = self.late.acting(entry) else { return };
        match entry {
            Entry::Good(reading) => {
                // What no row tells is taken as held.
                let f = acting.or(self.last.map(|last| last.f)).unwrap_or(reading.f);
                self.good(&Sample { f, ..*reading });
            }
            Entry::Bad(bad) => self.bad(&Bad { force: acting, ..*bad }),
        }
    }

    fn good(&mut self, reading: &Sample) {
        if let Some(last) = self.last {
            if let Some(reason) = last.disorder(reading) {
                return self.bad(&Bad { line: reading.line, reason, time: None, force: None });
            }
            let (least, most) = self.forces.take().unwrap_or((last.f, last.f));
            let forces = (least.min(last.f), most.max(last.f));
            let spans = std::mem::take(&mut self.spans);
            if spans {
                self.account.traces.bad_rows(last.t, reading.t);
            }
            self.step(Step { from: last, to: *reading, forces, spans });
        } else {
            if std::mem::take(&mut self.spans) {
                self.account.traces.bad_rows(reading.t, reading.t);
            }
            self.forces = None;
            self.first = Some(*reading);
            self.account.start(reading);
        }
        self.rows += 1;
        self.last = Some(*reading);
    }

    fn bad(&mut self, bad: &Bad<'_>) {
        self.bad.add(bad.line, &bad.reason);
        self.spans = true;
        // The force of a bad row counts if its time is after the last good row.
        if let (Some(time), Some(force), Some(last)) = (bad.time, bad.force, self.last)
            && time > last.t
        {
            let (least, most) = self.forces.unwrap_or((force, force));
            self.forces = Some((least.min(force), most.max(force)));
        }
    }

    fn step(&mut self, step: Step) {
        if let Some(period) = self.period {
            return self.account.book(&step, period);
        }
        self.waiting.push(step);
        if self.waiting.len() == WAITING {
            self.settle();
        }
    }

    /// Books the steps that waited for the median period, and returns that period.
    fn settle(&mut self) -> f64 {
        let waiting = std::mem::take(&mut self.waiting);
        let period =
            *self.period.get_or_insert_with(|| median_period(waiting.iter().map(Step::time)));
        waiting.iter().for_each(|step| self.account.book(step, period));
        period
    }

    /// The report and the curves of the log called `name`.
    ///
    /// # Errors
    /// Fewer than two good rows; ticks that are not those of the scene of a replay.
    pub(super) fn finish(mut self, name: &str) -> Result<(Report, Traces), LogError> {
        let period = self.settle();
        let (Some(first), Some(last), 2..) = (self.first, self.last, self.rows) else {
            return Err(LogError::too_few(name, &self.bad));
        };
        let mut account = self.account;
        account.traces.push(last.t, account.pushed);
        if self.spans {
            account.traces.bad_rows(last.t, last.t);
        }
        let is_touching = account.contacts.is_open();
        let contacts = account.contacts.finish();
        let look_at = account.signs.finish(period, self.bad.count);
        let report = Report {
            log: name.to_owned(),
            rows: self.rows,
            bad_rows: self.bad,
            start: first.t,
            end: last.t,
            duration: last.since - first.since,
            median_period: period,
            gaps: account.gaps,
            starts_in_contact: first.f.abs() > contacts.threshold,
            ends_in_contact: is_touching && last.f.abs() > contacts.threshold,
            energy: Energy {
                absorbed: account.port.absorbed(),
                released: account.port.released(),
                generated: account.port.generated(),
                credited: account.credited.absorbed(),
            },
            observed_energy: account.held_course.finish(),
            damper: account.damper,
            printed: account.sampled_course.finish(),
            contacts,
            look_at,
            replay: account.listener.map(|it| it.finish(name, period)).transpose()?,
            ..Report::default()
        };
        Ok((report, account.traces))
    }
}

/// Sums over the steps.
#[derive(Debug)]
struct Books {
    held: Observing<Held>,
    sampled: Observing<Sampled>,
    held_course: ObservedEnergy,
    sampled_course: ObservedEnergy,
    port: Tally,
    credited: Tally,
    damper: ConstantDamper,
    gaps: Gaps,
    contacts: Finder,
    traces: Traces,
    signs: LogSigns,
    listener: Option<Box<dyn Listener>>,
    /// Force of the last step, N.
    pushed: f64,
}

fn observing<W: Work>(candidate: Credited) -> Observing<W> {
    Observer { candidate, ledger: Ledger::new() }
}

impl Books {
    fn new(candidate: Credited, contact: Option<f64>, listener: Option<Box<dyn Listener>>) -> Self {
        Self {
            held: observing(candidate),
            sampled: observing(candidate),
            held_course: ObservedEnergy::default(),
            sampled_course: ObservedEnergy::default(),
            port: Tally::new(),
            credited: Tally::new(),
            damper: ConstantDamper::default(),
            gaps: Gaps::default(),
            contacts: Finder::new(contact),
            traces: Traces::new(),
            signs: LogSigns::new(contact),
            listener,
            pushed: 0.0,
        }
    }

    fn start(&mut self, reading: &Sample) {
        (self.held_course, self.sampled_course) =
            (ObservedEnergy::starting(reading.t), ObservedEnergy::starting(reading.t));
        self.traces.add(reading, 0.0, 0.0);
        self.signs.add(reading);
    }

    fn book(&mut self, step: &Step, median: f64) {
        if step.time().is_gap(median) {
            self.gaps.add(step);
            self.traces.gap(step.from.t, step.to.t);
        }
        let sample = step.sample(median);
        let motion = sample.velocity * sample.velocity * sample.period;
        if let Some(listener) = &mut self.listener {
            listener.book(step, &sample, median);
        }
        self.port.add(sample.work, motion);
        self.credited.add(self.held.candidate.credit(&sample), 0.0);
        let held = self.held.observe(&sample, step.to.f);
        let sampled = self.sampled.observe(&sample, step.to.f);
        self.held_course.add(step.to.t, held);
        self.sampled_course.add(step.to.t, sampled);
        self.signs.add(&step.to);
        self.damper.add(step.to.t, self.port.damper(-held));
        self.contacts.add(&Push {
            from: step.from.t,
            to: step.to.t,
            force: step.from.f,
            work: sample.work,
            motion,
        });
        self.traces.push(step.from.t, step.from.f);
        self.traces.add(&step.to, held, sampled);
        self.pushed = step.from.f;
    }
}
