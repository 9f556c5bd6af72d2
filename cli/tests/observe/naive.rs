//! The definitions of docs/observe.md, calculated in memory and without the library.

/// Row of a log, with its numbers in SI units.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Row {
    Good(Sample),
    /// A row that cannot be used, with its time and force if they can be read.
    Bad {
        t: Option<f64>,
        f: Option<f64>,
    },
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    pub(crate) t: f64,
    pub(crate) x: f64,
    pub(crate) f: f64,
    pub(crate) v: Option<f64>,
}

/// Step between two good rows.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Step {
    pub(crate) from: Sample,
    pub(crate) to: Sample,
    spans: bool,
    least: f64,
    most: f64,
    pub(crate) work: f64,
    pub(crate) sampled: f64,
    /// `v² T`.
    pub(crate) motion: f64,
    pub(crate) gap: bool,
}

/// Steps of a log, and the number of bad rows.
pub(crate) fn steps(rows: &[Row]) -> (Vec<Step>, u64) {
    let (mut steps, mut bad) = (Vec::new(), 0);
    let mut last: Option<Sample> = None;
    let mut told: Option<Vec<f64>> = None;
    for row in rows {
        match (*row, last) {
            (Row::Good(to), Some(from)) if to.t > from.t => {
                let spans = told.is_some();
                let forces = [vec![from.f], told.take().unwrap_or_default()].concat();
                let least = forces.iter().copied().fold(f64::INFINITY, f64::min);
                let most = forces.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                let (work, sampled, motion, gap) = (0.0, 0.0, 0.0, false);
                steps.push(Step { from, to, spans, least, most, work, sampled, motion, gap });
                last = Some(to);
            }
            (Row::Good(to), None) => {
                (last, told) = (Some(to), None);
            }
            (Row::Good(_), Some(_)) => {
                bad += 1;
                told.get_or_insert_default();
            }
            (Row::Bad { t, f }, last) => {
                bad += 1;
                let told = told.get_or_insert_default();
                if let (Some(t), Some(f), Some(last)) = (t, f, last)
                    && t > last.t
                {
                    told.push(f);
                }
            }
        }
    }
    let median = median(&steps);
    steps.iter_mut().for_each(|step| step.calculate(median));
    (steps, bad)
}

fn median(steps: &[Step]) -> f64 {
    let first = &steps[..steps.len().min(1024)];
    let period = |step: &Step| step.to.t - step.from.t;
    let mut periods: Vec<f64> = first.iter().filter(|step| !step.spans).map(period).collect();
    if periods.is_empty() {
        periods = first.iter().map(period).collect();
    }
    periods.sort_by(f64::total_cmp);
    match periods.len() {
        0 => 0.0,
        odd if odd % 2 == 1 => periods[odd / 2],
        even => 0.5 * (periods[even / 2 - 1] + periods[even / 2]),
    }
}

impl Step {
    fn calculate(&mut self, median: f64) {
        let (period, moved) = (self.to.t - self.from.t, self.to.x - self.from.x);
        self.gap = period > 1.5 * median;
        let mean = moved / period;
        let v = match self.to.v {
            Some(v) if (self.gap || self.spans) && mean * v < 0.0 => 0.0,
            Some(v) if (self.gap || self.spans) && mean.abs() < v.abs() => mean,
            Some(v) => v,
            None => mean,
        };
        self.work = f64::min(self.least * moved, self.most * moved);
        self.sampled = self.to.f * v * period;
        self.motion = v * v * period;
    }
}

/// Contact: the steps from `first` to `last`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contact {
    pub(crate) first: usize,
    pub(crate) last: usize,
}

/// Contacts above a threshold; up to three steps below it do not end one.
pub(crate) fn contacts(steps: &[Step], threshold: f64) -> Vec<Contact> {
    let mut contacts: Vec<Contact> = Vec::new();
    for (index, step) in steps.iter().enumerate() {
        if step.from.f.abs() > threshold {
            match contacts.last_mut() {
                Some(contact) if index - contact.last <= 4 => contact.last = index,
                _ => contacts.push(Contact { first: index, last: index }),
            }
        }
    }
    contacts
}
