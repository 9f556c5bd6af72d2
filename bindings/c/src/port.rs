//! Signals, samples and corrections as C has them: numbers in a fixed order, without padding.

use lyapunov::poses::Screw;
use lyapunov::{Correction, PortSample, Signal};
use nalgebra::{SVector, Vector3};

use crate::export::form;
use crate::number::Number;

form! {
    /// Several axes, in C `lyapunov_f64x3` and kin.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct AxesForm<T, const N: usize> {
        /// The axes.
        pub axis: [T; N],
    }
}

impl<T: Number, const N: usize> Default for AxesForm<T, N> {
    #[inline]
    fn default() -> Self {
        Self { axis: [T::default(); N] }
    }
}

form! {
    /// Twist or wrench, in C `lyapunov_f64screw` and kin.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct ScrewForm<T> {
        /// The part of translation: m/s, m, N, or J.
        pub translation: [T; 3],
        /// The part of rotation: rad/s, rad, N.m, or J.
        pub rotation: [T; 3],
    }
}

/// Signal that C has a form for.
pub trait Port: Signal<Scalar: Number> {
    /// The form.
    type Form: Copy + Default + PartialEq + core::fmt::Debug + 'static;

    /// The form as the argument of a function: a number itself, else a pointer.
    type Given: Copy;

    /// The signal of a form.
    fn of(form: Self::Form) -> Self;

    /// The form of a signal.
    fn form(self) -> Self::Form;

    /// The address of the form that was given; of a number, which is given itself, one that can be followed.
    fn address(given: Self::Given) -> usize;

    /// The signal that was given.
    ///
    /// # Safety
    /// At the address is a form that can be read.
    unsafe fn read(given: Self::Given) -> Self;
}

macro_rules! line {
    ($($number:ident),+) => {$(
        impl Port for $number {
            type Form = $number;

            type Given = $number;

            #[inline(always)]
            fn of(form: $number) -> Self {
                form
            }

            #[inline(always)]
            fn form(self) -> $number {
                self
            }

            #[inline(always)]
            fn address(_given: $number) -> usize {
                align_of::<$number>()
            }

            #[inline(always)]
            unsafe fn read(given: $number) -> $number {
                given
            }
        }
    )+};
}

line!(f32, f64);

impl<T: Number, const N: usize> Port for SVector<T, N> {
    type Form = AxesForm<T, N>;

    type Given = *const AxesForm<T, N>;

    #[inline(always)]
    fn of(form: Self::Form) -> Self {
        form.axis.into()
    }

    #[inline(always)]
    fn form(self) -> Self::Form {
        let mut form = AxesForm::default();
        // Axis by axis: copied as a whole, they take another way through the registers.
        form.axis.iter_mut().zip(self.iter()).for_each(|(place, axis)| *place = *axis);
        form
    }

    #[inline(always)]
    fn address(given: Self::Given) -> usize {
        given.addr()
    }

    #[inline(always)]
    unsafe fn read(given: Self::Given) -> Self {
        // SAFETY: as the caller says.
        Self::of(unsafe { given.read() })
    }
}

impl<T: Number> Port for Screw<T> {
    type Form = ScrewForm<T>;

    type Given = *const ScrewForm<T>;

    #[inline(always)]
    fn of(form: Self::Form) -> Self {
        Self::new(form.translation.into(), form.rotation.into())
    }

    #[inline(always)]
    fn form(self) -> Self::Form {
        let part = |part: Vector3<T>| part.into();
        ScrewForm { translation: part(self.translation), rotation: part(self.rotation) }
    }

    #[inline(always)]
    fn address(given: Self::Given) -> usize {
        given.addr()
    }

    #[inline(always)]
    unsafe fn read(given: Self::Given) -> Self {
        // SAFETY: as the caller says.
        Self::of(unsafe { given.read() })
    }
}

form! {
    /// Port sample of C.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct SampleForm<V: Port> {
        /// Time since the last call, s: above 0 and finite.
        pub period: V::Scalar,
        /// Position now, m.
        pub position: V::Form,
        /// Velocity now, m/s.
        pub velocity: V::Form,
        /// Displacement since the last call, m.
        pub displacement: V::Form,
        /// The effort applied last, N: after saturation and delay.
        pub applied: V::Form,
        /// Work of the applied efforts since the last call, on each axis, J: applied times displacement under one held
        /// effort.
        pub work: V::Form,
    }
}

impl<V: Port> SampleForm<V> {
    /// The sample.
    #[inline(always)]
    pub fn sample(self) -> PortSample<V> {
        PortSample {
            period: self.period,
            position: V::of(self.position),
            velocity: V::of(self.velocity),
            displacement: V::of(self.displacement),
            applied: V::of(self.applied),
            work: V::of(self.work),
        }
    }

    /// The form of a sample.
    #[inline(always)]
    pub fn of(sample: &PortSample<V>) -> Self {
        Self {
            period: sample.period,
            position: sample.position.form(),
            velocity: sample.velocity.form(),
            displacement: sample.displacement.form(),
            applied: sample.applied.form(),
            work: sample.work.form(),
        }
    }
}

form! {
    /// Correction of C.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct CorrectionForm<V: Port> {
        /// The effort to command, correction included, N.
        pub effort: V::Form,
        /// The observed energy before this tick's correction, J.
        pub observed_energy: V::Scalar,
        /// The damping injected on this tick, N.s/m; 0 from a block that corrects in another way.
        pub alpha: V::Scalar,
        /// The part of the debt that this tick's correction cannot serve, J; it stays.
        pub shortfall: V::Scalar,
        /// 1 if the sample was accepted; else 0, with a zero effort or with what a watchdog holds, and of several axes or parts with the
        /// efforts of those that did accept it.
        pub accepted: u32,
        /// The code that the call returned.
        pub code: u32,
    }
}

impl<V: Port> CorrectionForm<V> {
    /// The form of a correction.
    #[inline(always)]
    pub fn of(correction: &Correction<V>) -> Self {
        Self {
            effort: correction.effort.form(),
            observed_energy: correction.observed_energy,
            alpha: correction.alpha,
            shortfall: correction.shortfall,
            accepted: u32::from(correction.accepted),
            code: 0,
        }
    }

    /// The correction of a call that did nothing: no effort, not accepted.
    pub fn refused(code: crate::status::Code) -> Self {
        let none = Correction { accepted: false, ..Correction::none(V::zero()) };
        Self { code: code as u32, ..Self::of(&none) }
    }

    /// The correction.
    pub fn correction(self) -> Correction<V> {
        Correction {
            effort: V::of(self.effort),
            observed_energy: self.observed_energy,
            alpha: self.alpha,
            shortfall: self.shortfall,
            accepted: self.accepted != 0,
        }
    }
}
