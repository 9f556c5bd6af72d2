//! Comparison of values within a tolerance: the traits of `approx`, behind the feature of that name.
//!
//! Two values are near if all their fields are, each by the same rule. `epsilon` is one number for every field, in the
//! field's own SI unit: with `epsilon = 1e-9` positions may differ by 1e-9 m, efforts by 1e-9 N, works by 1e-9 J.
//! `max_relative` is a share of the larger of the two magnitudes, field by field and axis by axis. Masks must be equal.
//!
//! Lane types and traits both come from other crates, so they cannot be joined here: compare lane by lane
//! ([`Scalar::lane`]).

use approx::{AbsDiffEq, RelativeEq, UlpsEq};

use crate::telemetry::{EnergySummary, RecordedTick};
use crate::{
    AdmittanceSample, Axes, Correction, DoubleDouble, PortSample, Scalar, Screw, Signal, State,
    WithPose,
};

/// Implementation of `approx`'s three traits for a type whose fields all have them, with the tolerance of the first
/// bound.
#[doc(hidden)]
#[macro_export]
macro_rules! approximate {
    (impl[$($parameters:tt)*] $type:ty, of $first:ty $(, $more:ty)* {
        $($field:ident),+ $(; same $same:path)?
    }) => {
        impl<$($parameters)*> $crate::approx::AbsDiffEq for $type
        where
            $first: $crate::approx::AbsDiffEq<Epsilon: Clone>,
            $($more: $crate::approx::AbsDiffEq<
                Epsilon = <$first as $crate::approx::AbsDiffEq>::Epsilon,
            >,)*
        {
            type Epsilon = <$first as $crate::approx::AbsDiffEq>::Epsilon;

            fn default_epsilon() -> Self::Epsilon {
                <$first>::default_epsilon()
            }

            fn abs_diff_eq(&self, other: &Self, epsilon: Self::Epsilon) -> bool {
                $(self.$field.abs_diff_eq(&other.$field, epsilon.clone()))&&+
                    $(&& $same(self, other))?
            }
        }

        impl<$($parameters)*> $crate::approx::RelativeEq for $type
        where
            $first: $crate::approx::RelativeEq<Epsilon: Clone>,
            $($more: $crate::approx::RelativeEq<
                Epsilon = <$first as $crate::approx::AbsDiffEq>::Epsilon,
            >,)*
        {
            fn default_max_relative() -> Self::Epsilon {
                <$first>::default_max_relative()
            }

            fn relative_eq(
                &self,
                other: &Self,
                epsilon: Self::Epsilon,
                max_relative: Self::Epsilon,
            ) -> bool {
                $(self.$field.relative_eq(&other.$field, epsilon.clone(), max_relative.clone()))&&+
                    $(&& $same(self, other))?
            }
        }

        impl<$($parameters)*> $crate::approx::UlpsEq for $type
        where
            $first: $crate::approx::UlpsEq<Epsilon: Clone>,
            $($more: $crate::approx::UlpsEq<
                Epsilon = <$first as $crate::approx::AbsDiffEq>::Epsilon,
            >,)*
        {
            fn default_max_ulps() -> u32 {
                <$first>::default_max_ulps()
            }

            fn ulps_eq(&self, other: &Self, epsilon: Self::Epsilon, max_ulps: u32) -> bool {
                $(self.$field.ulps_eq(&other.$field, epsilon.clone(), max_ulps))&&+
                    $(&& $same(self, other))?
            }
        }
    };
}

approximate!(impl[V: Signal] PortSample<V>, of V, V::Scalar {
    period, position, velocity, displacement, applied, work
});
approximate!(impl[V: Signal] AdmittanceSample<V>, of V, V::Scalar {
    period, momentum, effort, impulse, flow, work
});
approximate!(impl[V: Signal] Correction<V>, of V, V::Scalar {
    effort, observed_energy, alpha, shortfall; same Correction::accepted_alike
});
approximate!(impl[Q: PartialEq] State<Q>, of Q { position, velocity });
approximate!(impl[T: Scalar, F: Axes] Screw<T, F>, of T { translation, rotation });
approximate!(impl[T: Scalar, F: Axes] WithPose<T, F>, of T { screw, pose });
approximate!(impl[V: Signal] RecordedTick<V>, of PortSample<V>, Correction<V> { sample, correction });
approximate!(impl[T: PartialEq] EnergySummary<T>, of T {
    active, rejected, now, least, most, asked, absorbed, shortfall, largest_shortfall;
    same EnergySummary::of_as_many_ticks
});

/// Tolerances are `f64`, whose range reaches far below the last digit.
impl AbsDiffEq for DoubleDouble {
    type Epsilon = f64;

    /// `2⁻¹⁰²`.
    fn default_epsilon() -> f64 {
        <Self as Scalar>::epsilon().high()
    }

    fn abs_diff_eq(&self, other: &Self, epsilon: f64) -> bool {
        within(*self, *other, epsilon.into())
    }
}

impl RelativeEq for DoubleDouble {
    /// `2⁻¹⁰²`.
    fn default_max_relative() -> f64 {
        Self::default_epsilon()
    }

    fn relative_eq(&self, other: &Self, epsilon: f64, max_relative: f64) -> bool {
        let share = self.magnitude().larger(other.magnitude()) * Self::from(max_relative);
        within(*self, *other, share.larger(epsilon.into()))
    }
}

/// A unit in the last place is `2⁻¹⁰²` of the larger magnitude.
impl UlpsEq for DoubleDouble {
    fn default_max_ulps() -> u32 {
        4
    }

    fn ulps_eq(&self, other: &Self, epsilon: f64, max_ulps: u32) -> bool {
        self.relative_eq(other, epsilon, f64::from(max_ulps) * Self::default_epsilon())
    }
}

/// Whether two numbers are equal, or finite and no farther apart than `allowed`.
fn within(one: DoubleDouble, other: DoubleDouble, allowed: DoubleDouble) -> bool {
    let apart = (one - other).magnitude();
    one == other || one.finite() && other.finite() && !allowed.below(apart)
}
