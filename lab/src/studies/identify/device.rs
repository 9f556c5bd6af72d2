//! Mass, damping and spring that a log tells.

use nalgebra::Vector4;

use super::blocks::{Spread, spread};
use super::estimate::Estimate;
use super::feedback::is_feedback;
use super::least_squares::inverse;
use super::motion::{BIAS, Coefficients, DECAY, MOBILITY, SPRING, before};
use super::plant::{Fit, Setting};
use super::recording::{FEWEST_OF_STRETCH, Recording};
use super::stretch::Stretch;
use crate::files::log::{BadRows, LogError};

/// Fewest rows that a fit is told of.
const FEWEST: usize = 50;

/// Most rows by which the force may act late.
const LAGS: usize = 8;

/// Rows over which the lateness is looked for, and rows that are predicted from one state meanwhile.
const LOOKED: usize = 4000;
const AHEAD: usize = 256;

/// Share by which a late force has to fit better than one that is not late.
const BETTER: f64 = 0.98;

/// Rows of a stretch in which an unknown force may be taken as constant.
const STRETCH: usize = 32;

/// Factor by which the whole log may fit worse than short stretches do before something unknown is said to push.
const WORSE: f64 = 2.0;

/// Factor by which the whole log may fit worse than the steps of its positions ask for, and the likeness of the errors of
/// neighbouring rows from which on something other than the steps makes them: theirs are alike only where `x` stands.
const COARSE: f64 = 2.0;
const ALIKE: f64 = 0.5;

/// Share of the way from the least to the largest position below which nothing but rounding is left.
const ROUNDING: f64 = 1e-9;

/// Coefficients with what is known of their errors.
#[derive(Clone, Debug)]
struct Told {
    fit: Fit,
    spread: Spread,
    /// The coefficients without the bounds at 0.
    middle: Coefficients,
}

/// Mass, damping and spring, fitted.
#[derive(Clone, Debug)]
pub(super) struct Device {
    told: Told,
    /// The fit of the whole log, where `told` is that of short stretches.
    other: Option<Told>,
    lag: usize,
    /// The time by which the first fitted row comes after the first, s.
    ahead: f64,
    /// The error of the whole log, and that of short stretches with a constant force of their own, m.
    pub(super) error: f64,
    pub(super) short_error: f64,
    /// Whether something pushes that the log does not hold.
    pub(super) is_pushed: bool,
    /// The error of the steps of the positions alone, m, where the whole log leaves far more of them, row after row alike.
    pub(super) unlike: Option<f64>,
}

/// Reason why a log tells no mass.
#[derive(Clone, Copy, Debug)]
pub(super) enum Fault {
    Short,
    Still,
    NoForce,
    Feedback,
    NoMass,
}

impl Fault {
    /// The refusal of the log called `name`, which has so many `gaps` and these `bad` rows, which may be why.
    pub(super) fn about(self, name: &str, gaps: usize, bad: &BadRows) -> LogError {
        let (fault, remedy) = match self {
            Self::Short => (
                "too few rows without a gap",
                "give a log of 50 rows or more, in free motion and in contact",
            ),
            Self::Still => ("x is the same in all rows", "give a log of a motion"),
            Self::NoForce => (
                "f is 0 in all rows, so only ratios to the mass are told",
                "record a contact: the force that moves the device tells its mass",
            ),
            Self::Feedback => (
                "f is the force of one spring and damper in all rows, so only ratios to the mass are told",
                "record free motion as well as contact: begin away from the wall, or leave it",
            ),
            Self::NoMass => (
                "the force does not tell the mass: a mass without end lies within its 95 % interval",
                "record firmer or longer contacts, with free motion between them; check the sign of f (--scale f=-1) and its unit",
            ),
        };
        let cut = matches!(self, Self::Short | Self::NoMass) && gaps > 0;
        let remedy = match (cut, gaps) {
            (false, _) => remedy.to_owned(),
            (true, 1) => format!("a gap cuts the log: record every row; {remedy}"),
            (true, _) => format!("{gaps} gaps cut the log: record every row; {remedy}"),
        };
        let blamed = bad.blamed().filter(|_| matches!(self, Self::Short | Self::NoForce));
        LogError::about(name, fault).with_help(match blamed {
            Some(blamed) => format!("{remedy}; {blamed}"),
            None => remedy,
        })
    }
}

impl Device {
    pub(super) fn of(recording: &Recording) -> Result<Self, Fault> {
        let stretches = &recording.stretches;
        if recording.rows() < FEWEST {
            return Err(Fault::Short);
        }
        if stretches.iter().all(|it| it.positions.iter().all(|x| *x == stretches[0].positions[0])) {
            return Err(Fault::Still);
        }
        if recording.largest_force() == 0.0 {
            return Err(Fault::NoForce);
        }
        if is_feedback(stretches) {
            return Err(Fault::Feedback);
        }
        let setting = Setting {
            stretches,
            period: recording.period,
            lag: 0,
            horizon: usize::MAX,
            pushed: false,
            free: [true; 4],
        };
        let (lag, from) = lateness(&setting).ok_or(Fault::NoMass)?;
        let whole = Setting { lag, ..setting };
        let long = whole.fit(from).ok_or(Fault::NoMass)?;
        let short =
            Setting { horizon: STRETCH, pushed: true, free: [true, true, false, true], ..whole };
        // An unknown push looks like lateness over many rows, and like a constant over few.
        // The fit of the whole log may have run away, and is no place to begin at then.
        let (short, from) =
            lateness(&short).map_or((short, long.at), |(lag, at)| (Setting { lag, ..short }, at));
        let near = short.fit(from);
        let error = long.error(whole.count());
        let short_error = near.as_ref().map_or(error, |fit| fit.error(short.count()));
        let grid = recording.resolution().map_or(0.0, |it| it / 12_f64.sqrt());
        let least = short_error.max(grid).max(ROUNDING * recording.travel());
        let is_unlike = error > COARSE * grid.max(ROUNDING * recording.travel())
            && alike(stretches, lag, &long.pass.fitted) > ALIKE;
        let of_long = Told::of(&whole, long);
        let of_short = near.filter(|_| error > WORSE * least).and_then(|fit| Told::of(&short, fit));
        let is_pushed = of_short.is_some();
        let (told, other) = match of_short {
            // A whole log that tells no mass at all has nothing to add.
            Some(told) => {
                (told, of_long.filter(|it| lag == short.lag && it.mobility().inverse().is_some()))
            }
            None => (of_long.ok_or(Fault::NoMass)?, None),
        };
        let lag = if is_pushed { short.lag } else { lag };
        let ahead = first_fitted(stretches, lag);
        let unlike = (is_unlike && !is_pushed).then_some(grid);
        let device = Self { told, other, lag, ahead, error, short_error, is_pushed, unlike };
        device.mobility().inverse().map(|_| device).ok_or(Fault::NoMass)
    }

    /// Rows by which the force acts late.
    pub(super) fn lag(&self) -> usize {
        self.lag
    }

    /// Fitted positions, from the row of the lag on in each stretch.
    pub(super) fn fitted(&self) -> &[f64] {
        &self.told.fit.pass.fitted
    }

    /// Position, from the recording's origin on, and velocity of the first row.
    pub(super) fn start(&self) -> [f64; 2] {
        before(&self.told.fit.at, self.ahead, self.told.fit.pass.start)
    }

    /// The error of the fitted positions, m: that of a row, shared among the rows for each number fitted.
    pub(super) fn unsure(&self) -> f64 {
        let Fit { pass, .. } = &self.told.fit;
        (pass.cost * (pass.own + 4) as f64).sqrt() / pass.weight
    }

    fn mobility(&self) -> Estimate {
        let told = self.told.mobility();
        self.other.as_ref().map_or(told, |other| told.or(other.mobility()))
    }

    /// The mass, kg.
    pub(super) fn mass(&self) -> Estimate {
        let mobility = self.mobility();
        mobility.inverse().unwrap_or(Estimate {
            value: mobility.value.recip(),
            low: 0.0,
            high: f64::INFINITY,
        })
    }

    /// Damping in N·s/m.
    pub(super) fn damping(&self) -> Estimate {
        self.ratio(DECAY, MOBILITY)
    }

    /// Stiffness of the hand's spring in N/m.
    pub(super) fn stiffness(&self) -> Estimate {
        self.ratio(SPRING, MOBILITY)
    }

    /// The position at which the spring is relaxed, from the recording's origin on, m; none where no spring is told.
    pub(super) fn rest(&self) -> Option<Estimate> {
        self.stiffness().is_told().then(|| self.ratio(BIAS, SPRING))
    }

    /// The constant force at the recording's origin, N.
    pub(super) fn load(&self) -> Estimate {
        self.ratio(BIAS, MOBILITY)
    }

    fn ratio(&self, over: usize, under: usize) -> Estimate {
        let slope = |at: &Coefficients| {
            let mut slope = Vector4::zeros();
            slope[over] = at[under].recip();
            slope[under] = -at[over] / at[under].powi(2);
            slope
        };
        self.told_by(|at| at[over] / at[under], slope)
    }

    /// A function of the coefficients, to first order about them; of two fits the interval spans both.
    fn told_by(
        &self,
        of: impl Fn(&Coefficients) -> f64,
        slope: impl Fn(&Coefficients) -> Vector4<f64>,
    ) -> Estimate {
        let told = self.told.estimate(&of, &slope);
        self.other.as_ref().map_or(told, |other| told.or(other.estimate(&of, &slope)))
    }
}

impl Told {
    fn of(setting: &Setting<'_>, mut fit: Fit) -> Option<Self> {
        let inverse = inverse(&fit.pass.known, setting.free)?;
        let spread = spread(&fit.pass.scores, fit.pass.weight, &inverse, setting.count())?;
        let middle = fit.at + setting.unbound_step(&fit);
        if setting.pushed {
            fit.at[BIAS] = fit.pass.pushes / fit.pass.fitted.len() as f64;
        }
        Some(Self { fit, spread, middle })
    }

    fn mobility(&self) -> Estimate {
        self.estimate(|at| at[MOBILITY], |_| Vector4::ith(MOBILITY, 1.0))
    }

    fn estimate(
        &self,
        of: impl Fn(&Coefficients) -> f64,
        slope: impl Fn(&Coefficients) -> Vector4<f64>,
    ) -> Estimate {
        let at = &self.fit.at;
        let (value, slope) = (of(at), slope(at));
        let variance = slope.dot(&(self.spread.covariance * slope));
        let bound = |it: usize| at[it] <= 0.0;
        // Only a number that is held at 0 is away from what the data alone ask for.
        let off: f64 = [DECAY, SPRING]
            .into_iter()
            .filter(|it| bound(*it))
            .map(|it| slope[it] * (self.middle[it] - at[it]))
            .sum();
        Estimate::about(value, value + off, self.spread.factor * variance.max(0.0).sqrt(), value)
    }
}

/// Correlation of what the `fitted` positions leave in a row with what they leave in the next.
fn alike(stretches: &[Stretch], lag: usize, fitted: &[f64]) -> f64 {
    let (mut fitted, mut squares, mut products) = (fitted.iter(), 0.0, 0.0);
    for stretch in stretches {
        let measured = stretch.positions.iter().skip(lag);
        let left: Vec<f64> = measured.zip(fitted.by_ref()).map(|(x, fit)| x - fit).collect();
        squares += left.iter().map(|it| it * it).sum::<f64>();
        products += left.windows(2).map(|it| it[0] * it[1]).sum::<f64>();
    }
    products / squares
}

/// The time from the first row to the first one that is fitted, s.
fn first_fitted(stretches: &[Stretch], lag: usize) -> f64 {
    stretches[0].times.get(lag).map_or(0.0, |it| it - stretches[0].times[0])
}

/// Rows by which the force acts late, and coefficients for it, from the part of the log about the largest force.
fn lateness(setting: &Setting<'_>) -> Option<(usize, Coefficients)> {
    let parts = excerpt(setting.stretches);
    let fit = |lag: usize| {
        let horizon = setting.horizon.min(AHEAD);
        let setting = Setting { stretches: &parts, lag, horizon, ..*setting };
        let fit = setting.fit(Coefficients::zeros())?;
        Some((lag, fit.error(setting.count()), fit.at))
    };
    let fits: Vec<_> = (0..=LAGS).filter_map(fit).collect();
    let best = fits.iter().min_by(|one, other| one.1.total_cmp(&other.1))?;
    let chosen = fits.iter().find(|it| BETTER * it.1 <= best.1)?;
    Some((chosen.0, chosen.2))
}

/// The rows about the largest force, with those beyond the gaps beside it: a few rows between two gaps tell nothing.
fn excerpt(stretches: &[Stretch]) -> Vec<Stretch> {
    let forces = || stretches.iter().flat_map(|it| &it.forces).map(|it| it.abs());
    let most = forces().fold(0.0, f64::max);
    let at = forces().position(|it| it == most).unwrap_or_default();
    let from = at.saturating_sub(LOOKED / 2).min(forces().count().saturating_sub(LOOKED));
    let mut before = 0;
    let part = |stretch: &Stretch| {
        let rows = [from, from + LOOKED].map(|it| it.saturating_sub(before).min(stretch.len()));
        before += stretch.len();
        stretch.part(rows[0]..rows[1])
    };
    stretches.iter().map(part).filter(|it| it.len() >= FEWEST_OF_STRETCH).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_excerpt_is_about_the_largest_force_of_either_sign() {
        let numbers =
            |scale: f64| (0..10_000).map(|row| scale * f64::from(row)).collect::<Vec<_>>();
        for (at, first) in [(0, 0), (1500, 0), (7000, 5000), (9999, 6000)] {
            let mut forces = vec![0.5; 10_000];
            forces[at] = -3.0;
            let long = Stretch {
                times: numbers(1e-3),
                positions: numbers(1.0),
                forces,
                velocities: numbers(2.0),
            };
            let found = excerpt(std::slice::from_ref(&long));
            assert_eq!((found[0].len(), found[0].positions[0]), (4000, f64::from(first)), "{at}");
            assert!(found[0].forces.contains(&-3.0));
            // The same rows between gaps.
            let cut: Vec<_> = (0..10).map(|it| long.part(1000 * it..1000 * (it + 1))).collect();
            let joined: Vec<f64> = excerpt(&cut).into_iter().flat_map(|it| it.positions).collect();
            assert_eq!(joined, found[0].positions, "{at}");
        }
    }
}
