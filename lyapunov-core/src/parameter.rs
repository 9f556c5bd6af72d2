//! Parameter errors: the values that a constructor rejects.

use core::fmt;

use crate::{Mask, Scalar, Signal};

/// Rejected parameter: its name, its value and what would be right.
///
/// ```
/// use lyapunov_core::{ParameterError, Requirement};
/// let refused: Result<f64, ParameterError> = Requirement::Positive.check("mass", -1.0);
/// assert_eq!(refused.unwrap_err().to_string(), "mass is -1.0; it must be above 0 and finite");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ParameterError {
    /// The parameter's name in words, as a sentence has it: `damping cap`, `operator mass`. Of a field or an argument that a
    /// program knows by a shorter name, the words say of what it is: `watchdog hold`.
    pub parameter: &'static str,
    /// The given value; of lanes, the first that is not right.
    pub value: f64,
    /// The requirement that the value breaks.
    pub requirement: Requirement,
}

/// Requirement on a parameter's value.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Requirement {
    /// Neither infinite nor NaN.
    Finite,
    /// Finite and above 0.
    Positive,
    /// Finite and not below 0.
    NonNegative,
    /// Not below 0; infinity means without a limit.
    Limit,
    /// Above 0; infinity means without a limit.
    AboveZero,
    /// Not above the given number.
    AtMost(f64),
    /// Finite and not below the given number.
    AtLeast(f64),
    /// Such that the numbers computed from it stay within the range of the scalar.
    InRange,
}

impl Requirement {
    /// The number of a requirement that has one, else 0. Taken before an axis is looked at: most have none, and optimized
    /// code that looks for it from axis to axis branches on memory that was never written.
    fn number(self) -> f64 {
        match self {
            Self::AtMost(number) | Self::AtLeast(number) => number,
            _ => 0.0,
        }
    }

    /// Whether the value of one lane is right, for a requirement with this [`number`](Self::number).
    fn holds(self, number: f64, value: f64) -> bool {
        match self {
            Self::Finite | Self::InRange => value.is_finite(),
            Self::Positive => value.is_finite() && value > 0.0,
            Self::NonNegative => value.is_finite() && value >= 0.0,
            Self::Limit => value >= 0.0,
            Self::AboveZero => value > 0.0,
            Self::AtMost(_) => value <= number,
            Self::AtLeast(_) => value.is_finite() && value >= number,
        }
    }

    /// The first lane of `value` that is not right.
    #[inline(always)]
    fn first_wrong<T: Scalar>(self, number: f64, value: T) -> Option<f64> {
        match T::LANES {
            1 if self.holds_in_one_lane(number, value) => None,
            1 => Some(value.lane(0)),
            _ => self.first_wrong_of_lanes(number, value),
        }
    }

    /// Whether the only lane of `value` is right. Written out for each parameter, so that the match folds.
    #[inline(always)]
    fn holds_in_one_lane<T: Scalar>(self, number: f64, value: T) -> bool {
        self.lanes_that_hold(value).map_or_else(|| self.holds(number, value.lane(0)), Mask::all)
    }

    /// The same of several lanes. Out of line: written out for each parameter, the checks of lanes are most of a
    /// constructor.
    #[inline(never)]
    fn first_wrong_of_lanes<T: Scalar>(self, number: f64, value: T) -> Option<f64> {
        // All at once first, for loops that change a parameter on each tick.
        if self.lanes_that_hold(value).is_some_and(Mask::all) {
            return None;
        }
        (0..T::LANES).map(|lane| value.lane(lane)).find(|&lane| !self.holds(number, lane))
    }

    /// The lanes in which `value` is right, in its own type: where the processor has no doubles, each comparison of them is a
    /// function. None for a requirement with a number, which that type might round.
    #[inline(always)]
    fn lanes_that_hold<T: Scalar>(self, value: T) -> Option<T::Mask> {
        let none = T::zero();
        Some(match self {
            Self::Finite | Self::InRange => value.finite(),
            Self::Positive => value.finite() & value.above(none),
            Self::NonNegative => value.finite() & !value.below(none),
            Self::Limit => value.above(none) | value.finite() & !value.below(none),
            Self::AboveZero => value.above(none),
            Self::AtMost(_) | Self::AtLeast(_) => return None,
        })
    }

    /// `value` if every lane of it is right.
    ///
    /// # Errors
    /// A [`ParameterError`] that names `parameter` and the first lane's value that is not right.
    #[inline]
    pub fn check<T: Scalar>(self, parameter: &'static str, value: T) -> Result<T, ParameterError> {
        match self.first_wrong(self.number(), value) {
            Some(value) => Err(ParameterError { parameter, value, requirement: self }),
            None => Ok(value),
        }
    }

    /// `value` if every axis meets the requirement in every lane, or is NaN there: a stored value that may be unknown.
    ///
    /// # Errors
    /// As [`check_axes`](Self::check_axes).
    pub fn check_known<V: Signal>(
        self,
        parameter: &'static str,
        value: V,
    ) -> Result<V, ParameterError> {
        let (zero, one) = (V::Scalar::of(0.0), V::Scalar::of(1.0));
        // A number's magnitude is above −1, a NaN's is not.
        let known = value.map(|axis| V::Scalar::choose(axis.magnitude().above(-one), axis, zero));
        self.check_axes(parameter, known).map(|_| value)
    }

    /// `Ok(())` if `kept` holds in every lane: the check of a number computed from `given`, which the error reports because the
    /// caller knows it.
    ///
    /// ```
    /// use lyapunov_core::{Requirement, Signal};
    /// let per_second = |period: f64| {
    ///     let rate = 1.0 / period;
    ///     Requirement::InRange.require("period", period, rate.finite()).map(|()| rate)
    /// };
    /// assert_eq!(per_second(1e-310).unwrap_err().value, 1e-310);
    /// # let _ = per_second(1.0);
    /// ```
    ///
    /// # Errors
    /// A [`ParameterError`] that names `parameter` and the first lane of `given` in which it is not.
    pub fn require<T: Scalar>(
        self,
        parameter: &'static str,
        given: T,
        kept: T::Mask,
    ) -> Result<(), ParameterError> {
        match (0..T::LANES).find(|&lane| !kept.lane(lane)) {
            None => Ok(()),
            Some(lane) => {
                Err(ParameterError { parameter, value: given.lane(lane), requirement: self })
            }
        }
    }

    /// `signal` if every lane of every axis is right.
    ///
    /// ```
    /// use lyapunov_core::Requirement;
    /// use nalgebra::Vector2;
    /// let refused = Requirement::NonNegative.check_axes("weight", Vector2::new(1.0, -0.5)).unwrap_err();
    /// assert_eq!(refused.value, -0.5);
    /// ```
    ///
    /// # Errors
    /// A [`ParameterError`] that names `parameter` and the first value that is not right.
    pub fn check_axes<V: Signal>(
        self,
        parameter: &'static str,
        signal: V,
    ) -> Result<V, ParameterError> {
        let (number, mut refused) = (self.number(), None);
        let _ = signal.map(|axis| {
            refused = refused.or_else(|| self.first_wrong(number, axis));
            axis
        });
        match refused {
            Some(value) => Err(ParameterError { parameter, value, requirement: self }),
            None => Ok(signal),
        }
    }
}

impl fmt::Display for Requirement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Finite => f.write_str("finite"),
            Self::Positive => f.write_str("above 0 and finite"),
            Self::NonNegative => f.write_str("at least 0 and finite"),
            Self::Limit => f.write_str("at least 0 (infinity: no limit)"),
            Self::AboveZero => f.write_str("above 0 (infinity: no limit)"),
            Self::AtMost(most) => write!(f, "at most {most:?}"),
            Self::AtLeast(least) => write!(f, "at least {least:?} and finite"),
            Self::InRange => f.write_str("such that the result is within the range of the scalar"),
        }
    }
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { parameter, value, requirement } = self;
        write!(f, "{parameter} is {value:?}; it must be {requirement}")
    }
}

impl core::error::Error for ParameterError {}
