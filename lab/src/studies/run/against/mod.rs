//! Log laid over the run of a scene, on the same clock: `lyapunov run SCENE --against LOG`.
//!
//! Log and run are read side by side, a tick and a few rows at a time, in memory that does not grow.

mod difference;
mod laid;
mod picture;

use std::collections::VecDeque;
use std::io::Read;

use serde::Serialize;

use crate::files::Scene;
use crate::files::log::{
    BadRows, Columns, Entry, Log, LogError, Role, Sample, Scale, TimeStep, median_period,
};
use crate::files::scene::{Conflict, Draft, Finite};
use crate::measure::sanity::LogSigns;
use crate::simulate::Row;
use difference::Meter;
pub use difference::{Difference, Differences};
pub use laid::Laid;
use picture::Overlay;

/// Share of a period within which a row belongs to a tick: time stamps are rounded, and before a tick another force acts.
const SAME: f64 = 1e-2;

/// The number of steps that the median period is estimated from.
const STEPS: usize = 1024;

/// Start of a run that a log is laid over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Start {
    /// The scene's own; the log's times are those of the scene.
    #[default]
    Scene,
    /// The log's first row: its time is the scene's start, its position, and its velocity if there is one, the device's.
    Log,
}

/// A log, and the differences of a run from it so far.
#[derive(Debug)]
pub struct Against<R> {
    log: Log<R>,
    name: String,
    start: Start,
    /// Rows by which the log's force acts late, and the forces that do not act yet.
    late: usize,
    under_way: VecDeque<f64>,
    first: Sample,
    pending: Option<Sample>,
    bad: BadRows,
    /// The last row that was compared, and the run there.
    last: Option<Pair>,
    before: Option<Row>,
    from: Option<f64>,
    rows: u64,
    has_velocity: bool,
    meters: [Meter; 3],
    signs: LogSigns,
    /// The first steps, of which the median is the log's period.
    steps: Vec<TimeStep>,
    overlay: Overlay,
}

/// Position, velocity and force of one side.
#[derive(Clone, Copy, Debug)]
struct Place {
    position: f64,
    velocity: f64,
    force: f64,
}

/// A row of the log in the scene's time, and the run there.
#[derive(Clone, Copy, Debug)]
struct Pair {
    time: f64,
    log: Place,
    scene: Place,
}

impl<R: Read> Against<R> {
    /// Reads the log called `name` up to its first good row.
    ///
    /// # Errors
    /// A log without the requested columns or without a good row, or a stream that fails.
    pub fn open(
        reader: R,
        name: &str,
        columns: &Columns,
        scales: &[Scale],
        start: Start,
    ) -> Result<Self, LogError> {
        let mut log = Log::open(reader, name, columns, scales)?;
        let mut bad = BadRows::default();
        let Some(first) = next(&mut log, name, &mut bad, None)? else {
            return Err(LogError::too_few(name, &bad));
        };
        let has_velocity = columns.has(Role::V);
        Ok(Self {
            log,
            name: name.to_owned(),
            start,
            late: 0,
            under_way: VecDeque::new(),
            first,
            pending: Some(first),
            bad,
            last: None,
            before: None,
            from: None,
            rows: 0,
            has_velocity,
            meters: [Meter::new(), Meter::new(), Meter::new()],
            signs: LogSigns::new(None),
            steps: Vec::new(),
            overlay: Overlay::new(),
        })
    }

    /// The same for a log whose force acts as many `rows` late, as that of a command does: it is laid over the force that
    /// acts then.
    #[must_use]
    pub fn late(self, rows: u32) -> Self {
        Self { late: rows as usize, ..self }
    }

    /// `scene` with the start of this comparison.
    ///
    /// # Errors
    /// A log that does not begin within the scene; a start from the log in a space, or that the scene does not allow.
    pub fn started(&self, scene: &Scene) -> Result<Scene, LogError> {
        let (begins, ends) = (self.time(&self.first), scene.end());
        if begins < -SAME * scene.period() || begins > ends {
            let told =
                format!("the log begins at {begins:?} s, and the scene lasts from 0 to {ends:?} s");
            return Err(LogError::about(&self.name, told).with_help(
                "both have one clock: --start log takes the log's first row for the scene's start",
            ));
        }
        if self.start == Start::Scene {
            return Ok(scene.clone());
        }
        if scene.dimensions() > 1 {
            let axes = scene.dimensions();
            let told = format!("a log has one axis to start from, and the scene {axes}");
            return Err(LogError::about(&self.name, told)
                .with_help("leave --start log out, and give the scene its start"));
        }
        let mut draft: Draft = scene.to_draft();
        let refused = |error: &dyn std::fmt::Display| {
            LogError::about(&self.name, format!("its first row is no start: {error}"))
        };
        draft.initial.position = Finite::new(self.first.x).map_err(|error| refused(&error))?.into();
        if let Some(velocity) = self.first.v {
            draft.initial.velocity = Finite::new(velocity).map_err(|error| refused(&error))?.into();
        }
        draft.check().map_err(|conflict: Conflict| refused(&conflict))
    }

    /// Adds the next tick of the run, along the first axis.
    ///
    /// # Errors
    /// A stream that fails.
    pub fn add(&mut self, tick: &Row, period: f64) -> Result<(), LogError> {
        while let Some(row) = self.pending {
            let time = self.time(&row);
            if time > tick.t + SAME * period {
                break;
            }
            let scene = match &self.before {
                Some(before) if time < tick.t - SAME * period => between(before, tick, time),
                _ => Place { position: tick.x, velocity: tick.v, force: tick.f_act },
            };
            self.compare(&row, time, scene);
            self.pending = next(&mut self.log, &self.name, &mut self.bad, Some(&row))?;
        }
        self.before = Some(*tick);
        Ok(())
    }

    /// The differences, once all ticks of `scene` are told.
    ///
    /// # Errors
    /// A log that goes on after the scene, or of which fewer than two rows were compared; a stream that fails.
    pub fn finish(mut self, scene: &Scene) -> Result<Laid, LogError> {
        let ends = scene.end();
        let (mut left, mut last) = (0, None);
        while let Some(row) = self.pending {
            (left, last) = (left + 1, Some(self.time(&row)));
            self.pending = next(&mut self.log, &self.name, &mut self.bad, Some(&row))?;
        }
        if let Some(last) = last.filter(|last| *last > ends + SAME * scene.period()) {
            let told =
                format!("the log goes on until {last:?} s, and the scene ends at {ends:?} s");
            let remedy = format!(
                "give the scene a duration of {last:?} or more, or cut the log{}",
                self.own_clock(scene)
            );
            return Err(LogError::about(&self.name, told).with_help(remedy));
        }
        let (Some(from), Some(to), 2..) = (self.from, self.last, self.rows) else {
            return Err(LogError::too_few(&self.name, &self.bad));
        };
        let [position, velocity, force] = self.meters.map(|meter| meter.finish());
        let look_at =
            force.look_at(self.signs.finish(median_period(self.steps.into_iter()), self.bad.count));
        let differences = Differences {
            position: position.in_units("mm", 1e3),
            velocity: velocity.in_units("mm/s", 1e3),
            force: force.in_units("N", 1.0),
        };
        Ok(Laid {
            log: self.name,
            start: self.start,
            columns: self.log.columns().to_vec(),
            decimal_commas: self.log.has_decimal_commas(),
            rows: self.rows,
            rows_after_the_run: left,
            bad_rows: self.bad,
            from_s: from,
            to_s: to.time,
            scene_s: ends,
            measured_velocity: self.has_velocity,
            differences,
            look_at,
            overlay: self.overlay,
        })
    }

    /// The rest of the remedy for a log that goes on too long, where its clock did not start with the scene's.
    fn own_clock(&self, scene: &Scene) -> String {
        let begins = self.time(&self.first);
        if begins <= SAME * scene.period() {
            return String::new();
        }
        format!(
            "; it begins at {begins:?} s: where the scene starts with that row, \
             give --start log, which counts from there"
        )
    }

    /// The time of a row on the scene's clock, s.
    fn time(&self, row: &Sample) -> f64 {
        match self.start {
            Start::Scene => row.t,
            Start::Log => row.since - self.first.since,
        }
    }

    fn compare(&mut self, row: &Sample, time: f64, mut scene: Place) {
        let mut log = Place { position: row.x, velocity: row.v.unwrap_or(0.0), force: row.f };
        if !self.has_velocity {
            // Both by the same rule, from positions over the steps of the log.
            let over = |from: fn(&Pair) -> f64, to: f64| {
                self.last.map_or(0.0, |last| (to - from(&last)) / (time - last.time))
            };
            log.velocity = over(|last| last.log.position, log.position);
            scene.velocity = over(|last| last.scene.position, scene.position);
        }
        self.under_way.push_back(row.f);
        let acts = if self.under_way.len() > self.late { self.under_way.pop_front() } else { None };
        log.force = acts.unwrap_or(log.force);
        let pair = Pair { time, log, scene };
        self.signs.add(&Sample { t: time, ..*row });
        if let Some(last) = self.last
            && self.steps.len() < STEPS
        {
            self.steps.push(TimeStep { length: time - last.time, spans: false });
        }
        let [position, velocity, force] = &mut self.meters;
        position.add(time, log.position, scene.position);
        // Without a column of its own the first row has no velocity; what acts on the first rows of a late force is not logged.
        let known = [true, self.has_velocity || self.last.is_some(), acts.is_some()];
        if known[1] {
            velocity.add(time, log.velocity, scene.velocity);
        }
        if known[2] {
            force.add(time, log.force, scene.force);
        }
        self.overlay.add(&pair, known);
        self.from.get_or_insert(time);
        self.last = Some(pair);
        self.rows += 1;
    }
}

/// The run between two ticks: the motion by a straight line, the force as it is held.
fn between(before: &Row, after: &Row, time: f64) -> Place {
    let share = ((time - before.t) / (after.t - before.t)).clamp(0.0, 1.0);
    let line = |from: f64, to: f64| from + share * (to - from);
    Place {
        position: line(before.x, after.x),
        velocity: line(before.v, after.v),
        force: before.f_act,
    }
}

/// The next row that is good and later than `last`; the bad ones on the way are counted.
fn next<R: Read>(
    log: &mut Log<R>,
    name: &str,
    bad: &mut BadRows,
    last: Option<&Sample>,
) -> Result<Option<Sample>, LogError> {
    loop {
        match log.read().map_err(|error| LogError::unreadable(name, &error))? {
            None => return Ok(None),
            Some(Entry::Bad(row)) => bad.add(row.line, &row.reason),
            Some(Entry::Good(row)) => match last.and_then(|last| last.disorder(&row)) {
                Some(reason) => bad.add(row.line, &reason),
                None => return Ok(Some(row)),
            },
        }
    }
}
