//! Signs of a mistake in a log.

use lyapunov::accumulators::{Accumulator, Compensated};

use super::fit::Fit;
use super::hold::Hold;
use super::reading::{Jump, Offset};
use super::{FASTEST, Oddity, REACH, SLOWEST, STRONGEST, Sign};
use crate::files::log::{GAP, Sample};
use crate::text::found;

/// Speed that no hand reaches, m/s: the fastest throws leave it at less.
const THROW: f64 = 50.0;

/// The least force that is felt, N: the weight of a gram.
const GRAM: f64 = 0.01;

/// Rows in contact below which nothing is said about the sign of the force.
const ROWS: u64 = 10;

/// Weight from which on, below 0, a force depends on the motion.
const DEPENDS: f64 = -0.5;

/// Weight of the position that is none.
const NONE: f64 = 0.05;

/// Weight of the velocity above which a force that falls over the position comes late.
const LATE: f64 = 0.5;

/// The most that may go in, as a share of the most that came out, of a port with its sign turned.
const INTO: f64 = 0.1;

/// Share of bad rows from which on they are told.
const BAD: f64 = 0.1;

/// Contact threshold as a share of the largest force so far, where no threshold is given.
pub(crate) const SHARE: f64 = 0.01;

/// The largest of something, and its time.
#[derive(Clone, Copy, Debug, Default)]
struct Largest {
    size: f64,
    time: f64,
}

impl Largest {
    fn add(&mut self, value: f64, time: f64) {
        if value.abs() > self.size {
            *self = Self { size: value.abs(), time };
        }
    }
}

/// Motion and force up to some row.
#[derive(Clone, Copy, Debug)]
struct Sizes {
    low: f64,
    high: f64,
    speed: Largest,
    force: Largest,
}

/// Watches a log, row by row.
#[derive(Clone, Debug)]
pub(crate) struct LogSigns {
    contact: Option<f64>,
    rows: u64,
    last: Option<Sample>,
    /// The last step that was no gap, s.
    usual: f64,
    /// Energy by the force of each row held until the next, `Σ f Δx`, J.
    held: Compensated<f64>,
    all: Sizes,
    /// Until the port has given energy: what moves until then does so by the hand.
    by_hand: Sizes,
    has_given: bool,
    touched: u64,
    fit: Fit,
    hold: Hold,
    jump: Jump,
    offset: Offset,
    /// Energy by the force of each row, `Σ f v T`, J, and its extremes.
    sampled: f64,
    lowest: f64,
    highest: f64,
}

impl LogSigns {
    /// Nothing read yet; `contact`: the given threshold, N.
    pub(crate) fn new(contact: Option<f64>) -> Self {
        let none = Sizes {
            low: f64::INFINITY,
            high: f64::NEG_INFINITY,
            speed: Largest::default(),
            force: Largest::default(),
        };
        Self {
            contact,
            rows: 0,
            last: None,
            usual: f64::INFINITY,
            held: Compensated::zero(),
            all: none,
            by_hand: none,
            has_given: false,
            touched: 0,
            fit: Fit::default(),
            hold: Hold::default(),
            jump: Jump::default(),
            offset: Offset::default(),
            sampled: 0.0,
            lowest: 0.0,
            highest: 0.0,
        }
    }

    /// Adds a row, later than the one before.
    pub(crate) fn add(&mut self, row: &Sample) {
        let Sample { t: time, x: position, f: force, .. } = *row;
        let last = self.last.replace(*row).unwrap_or(*row);
        let (period, displacement) = (row.since - last.since, position - last.x);
        let mean = if period > 0.0 { displacement / period } else { 0.0 };
        let is_gap = period > GAP * self.usual;
        self.usual = if is_gap || period == 0.0 { self.usual } else { period };
        // What was measured at the end of a gap says little of the time before.
        let is_slow = |measured: &f64| !(is_gap && mean.abs() < measured.abs());
        let velocity = row.v.filter(is_slow).unwrap_or(mean);
        self.rows += 1;
        self.held.add(last.f * displacement);
        self.all.low = self.all.low.min(position);
        self.all.high = self.all.high.max(position);
        self.all.speed.add(velocity, time);
        self.all.force.add(force, time);
        if !self.has_given {
            self.by_hand = self.all;
            self.has_given = self.held.value() < 0.0;
        }
        let threshold = self.contact.unwrap_or(SHARE * self.all.force.size);
        self.hold.add(row, threshold);
        self.jump.add(row);
        self.offset.add(displacement, force);
        if force.abs() > threshold {
            self.touched += 1;
            if period > 0.0 {
                self.fit.add(position, velocity, force);
            }
        }
        self.sampled += force * velocity * period;
        self.lowest = self.lowest.min(self.sampled);
        self.highest = self.highest.max(self.sampled);
    }

    /// The signs of a log of this median `period`, s, with so many `bad` rows.
    pub(crate) fn finish(&self, period: f64, bad: u64) -> Vec<Oddity> {
        // A loop that generates energy may end anywhere; what it did before is the hand's.
        let reversed = self.reversed();
        let gives = self.held.value() < 0.0 || reversed.is_some();
        let sizes = if gives { &self.by_hand } else { &self.all };
        // A bad reading moves faster than any hand as well.
        let time = time(period);
        let moved = self.jump.finish().or_else(|| motion(sizes, time.is_none()));
        let told = [
            self.bad_rows(bad),
            time,
            moved,
            strong(sizes),
            self.faint(),
            self.idle(),
            reversed,
            self.offset.finish(self.all.force.size),
            self.hold.finish(),
        ];
        told.into_iter().flatten().collect()
    }

    fn bad_rows(&self, bad: u64) -> Option<Oddity> {
        let all = self.rows + bad;
        (bad as f64 > BAD * all as f64).then(|| {
            Oddity::new(Sign::Reading, format!("{bad} of {all} rows are bad and left out"))
        })
    }

    /// A force that nobody feels.
    fn faint(&self) -> Option<Oddity> {
        let Largest { size, time } = self.all.force;
        (size > 0.0 && size < GRAM).then(|| {
            let (size, time) = (found(size), found(time));
            let seen = format!("f reaches only {size} N at {time} s, less than a gram weighs");
            Oddity::new(Sign::Unit, format!("{seen}: in kN, --scale f=1e3"))
        })
    }

    /// A log without contact, or without motion.
    fn idle(&self) -> Option<Oddity> {
        let (rows, most) = (self.rows, self.all.force.size);
        let untouched = |text: String| Some(Oddity::new(Sign::Untouched, text));
        if most == 0.0 {
            return untouched(format!("f is 0 in all {rows} rows: nothing is touched"));
        }
        if self.all.low == self.all.high {
            let text = format!("x is the same in all {rows} rows: f does no work");
            return Some(Oddity::new(Sign::Idle, text));
        }
        let threshold = self.contact.filter(|_| self.touched == 0)?;
        let (most, threshold) = (found(most), found(threshold));
        untouched(format!("f is at most {most} N, and --contact is {threshold} N: no contact"))
    }

    /// A force that grows as the contact is left, or pushes along the motion, while energy only comes out.
    fn reversed(&self) -> Option<Oddity> {
        let it = self.fit.dependence();
        let gives = self.lowest < 0.0 && self.highest <= -INTO * self.lowest;
        // A force that comes late pushes along the motion too: it grows with the depth or, later still, with the velocity.
        let falls = it.with_position <= NONE && it.with_velocity <= LATE;
        if !(gives && falls && it.count >= ROWS) {
            return None;
        }
        let seen = if it.with_position <= DEPENDS {
            format!("{} N/m of x", found(-it.by_position))
        } else if it.with_velocity <= DEPENDS {
            format!("{} N.s/m of v", found(-it.by_velocity))
        } else {
            return None;
        };
        let turn = "its sign looks reversed (--scale f=-1 turns it)";
        Some(Oddity::new(Sign::Reversed, format!("in contact f falls by {seen}: {turn}")))
    }
}

fn time(period: f64) -> Option<Oddity> {
    let told = |unit: &str, factor: &str| {
        let period = found(period);
        let text =
            format!("t steps by {period} s, as no such loop does: in {unit}, --scale t={factor}");
        Some(Oddity::new(Sign::Unit, text))
    };
    if period > 0.0 && period * FASTEST < 1.0 {
        let text = format!("t steps by {} s, as no such loop does: check --scale t", found(period));
        return Some(Oddity::new(Sign::Unit, text));
    }
    match period * SLOWEST {
        late if late <= 1.0 + 1e-9 => None,
        late if late <= 1e3 => told("ms", "1e-3"),
        late if late <= 1e6 => told("us", "1e-6"),
        _ => told("ns", "1e-9"),
    }
}

/// A motion that no hand makes; its speed is judged where the times are.
fn motion(sizes: &Sizes, is_timed: bool) -> Option<Oddity> {
    let (travel, Largest { size: speed, time }) = (sizes.high - sizes.low, sizes.speed);
    let seen = if travel > REACH {
        let [low, high] = [sizes.low, sizes.high].map(found);
        format!("x runs from {low} to {high} m, further than arms reach")
    } else if is_timed && speed > THROW {
        format!("x moves at {} m/s at {} s, faster than any hand", found(speed), found(time))
    } else {
        return None;
    };
    let unit = if travel > 1e3 * REACH { "um, --scale x=1e-6" } else { "mm, --scale x=1e-3" };
    Some(Oddity::new(Sign::Unit, format!("{seen}: in {unit}")))
}

fn strong(sizes: &Sizes) -> Option<Oddity> {
    let Largest { size, time } = sizes.force;
    (size > STRONGEST).then(|| {
        let (size, time) = (found(size), found(time));
        let seen = format!("f reaches {size} N at {time} s, the weight of 200 kg and more");
        Oddity::new(Sign::Unit, format!("{seen}: in mN, --scale f=1e-3"))
    })
}
