//! Member of the family, chosen at run time.

use core::fmt;

use lyapunov_core::{
    Correction, Dissipation, Held, LyapunovCandidate, ParameterError, Plain, PortEnergy,
    PortSample, Requirement, Signal, Snapshot, Stabilizer,
};

use crate::{
    AlongDirection, AxisWeights, BoundedCredit, DirectedDamping, EnergyBounding, ForceBound,
    ForceBounding, LeastNorm, Lolc, NoStabilizer, Popc, RateLimit, SlopeBound, SoftStart, Spread,
    StabilizerExt, Tank, VelocityThreshold, WindowedCredit,
};

/// One scalar of the signal `V`.
type Of<V> = <V as Signal>::Scalar;

/// Sum of a windowed credit, with as many slots as in the commands.
type Window<V> = WindowedCredit<Of<V>, Plain<Of<V>>, 8>;

/// The enumeration, with a line for each member: variant, name, type.
macro_rules! members {
    (
        $(#[$about:meta])*
        pub enum $enum:ident<$v:ident, $c:ident = $default:ty>, remembered as $state:ident {
            $($(#[$told:meta])* $variant:ident $name:literal $type:ty,)+
        }
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug)]
        #[non_exhaustive]
        pub enum $enum<$v: Signal, $c = $default> {
            $(
                #[doc = concat!("`", $name, "`.")]
                $(#[$told])*
                $variant($type),
            )+
        }

        impl<$v: Signal, $c> $enum<$v, $c> {
            /// The names of all members, in the order of the variants.
            pub const NAMES: &'static [&'static str] = &[$($name),+];

            /// The name of this member, as in docs/family.md where it stands there.
            pub fn name(&self) -> &'static str {
                match self {
                    $(Self::$variant(_) => $name,)+
                }
            }
        }

        impl<$v: Signal, $c: LyapunovCandidate<$v>> Stabilizer<$v> for $enum<$v, $c> {
            #[inline]
            fn stabilize(&mut self, sample: &PortSample<$v>, effort: $v) -> Correction<$v> {
                match self {
                    $(Self::$variant(member) => member.stabilize(sample, effort),)+
                }
            }
        }

        /// Memory of a member: that of what it holds, under its name.
        ///
        /// ```
        /// use lyapunov_core::{ParameterError, PortEnergy, Snapshot};
        /// use lyapunov_stabilizers::{DampingLimit, Member, MemberState, NoStabilizer, Popc, StabilizerExt};
        /// let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
        /// let member: Member<f64> = Member::Bounded(popc.bounded(1e-3)?);
        /// let state: MemberState<f64, _> = member.state();
        /// assert!(member.restored(state).is_ok());
        /// let other: Member<f64> = Member::NoStabilizer(NoStabilizer);
        /// assert!(other.restored(state).is_err()); // the memory of another member
        /// # Ok::<(), ParameterError>(())
        /// ```
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(
            feature = "serde",
            serde(bound(
                serialize = "V: serde::Serialize, V::Scalar: serde::Serialize, \
                             C::State: serde::Serialize",
                deserialize = "V: serde::Deserialize<'de>, V::Scalar: serde::Deserialize<'de>, \
                               C::State: serde::Deserialize<'de>"
            ))
        )]
        #[non_exhaustive]
        pub enum $state<$v: Signal, $c: Snapshot> {
            $(
                #[doc = concat!("Of `", $name, "`.")]
                #[cfg_attr(feature = "serde", serde(rename = $name))]
                $variant(<$type as Snapshot>::State),
            )+
        }

        impl<$v: Signal, $c: Snapshot> Clone for $state<$v, $c> {
            fn clone(&self) -> Self {
                *self
            }
        }

        impl<$v: Signal, $c: Snapshot> Copy for $state<$v, $c> {}

        impl<$v: Signal, $c: Snapshot> PartialEq for $state<$v, $c> {
            fn eq(&self, other: &Self) -> bool {
                match (self, other) {
                    $((Self::$variant(one), Self::$variant(other)) => one == other,)+
                    _ => false,
                }
            }
        }

        impl<$v: Signal, $c: Snapshot> fmt::Debug for $state<$v, $c> {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                match self {
                    $(Self::$variant(state) => f.debug_tuple($name).field(state).finish(),)+
                }
            }
        }

        /// A memory of another member is refused: the error tells the two by their places in
        #[doc = concat!("[`NAMES`](", stringify!($enum), "::NAMES).")]
        impl<$v, $c> Snapshot for $enum<$v, $c>
        where
            $v: Signal,
            $c: Snapshot + 'static,
        {
            type State = $state<$v, $c>;

            fn state(&self) -> Self::State {
                match self {
                    $(Self::$variant(member) => $state::$variant(member.state()),)+
                }
            }

            fn restored(self, state: Self::State) -> Result<Self, ParameterError> {
                let (own, stored) = (
                    self.name(),
                    match state {
                        $($state::$variant(_) => $name,)+
                    },
                );
                match (self, state) {
                    $((Self::$variant(member), $state::$variant(state)) => {
                        member.restored(state).map(Self::$variant)
                    })+
                    _ => Err(another(Self::NAMES, stored, own)),
                }
            }
        }
    };
}

/// The error of a memory of `stored` that was given to a member called `own`.
fn another(names: &[&str], stored: &str, own: &str) -> ParameterError {
    let place = |name| names.iter().position(|it| *it == name).unwrap_or(0) as f64;
    let (value, own) = (place(stored), place(own));
    let (most, least) = (Requirement::AtMost(own), Requirement::AtLeast(own));
    let requirement = if value > own { most } else { least };
    ParameterError { parameter: "place of the stored member", value, requirement }
}

members! {
    /// Member of the family, chosen at run time: one type for all of them, without an allocator.
    ///
    /// In it are the stabilizers of one port that serve every [`Signal`], one axis or several, and [`Lolc`] with one
    /// candidate `C` of your choice; by default that is the port's energy with the credit of the device's own damper.
    /// The same [`Lolc`] with a reference as its candidate is [`ReferenceFollowing`](crate::ReferenceFollowing). Not in
    /// it are those that serve one axis only and bring a memory of the way
    /// ([`MemoryBased`](crate::MemoryBased), [`PathMemory`](crate::PathMemory)) or a surface
    /// ([`ContactReset`](crate::ContactReset)), those for several axes or a rigid body only ([`PerAxis`](crate::PerAxis),
    /// [`PerPart`](crate::PerPart), [`InertiaLimit`](crate::InertiaLimit)), and the sides of a two-port; box them
    /// (`Box<dyn Stabilizer<V>>`, feature `alloc`), or write an enumeration of your own.
    ///
    /// Its [state](Snapshot) is stored with the name of the member. What is changed between ticks (an account, a limit) is
    /// changed in the member itself: `if let Member::Popc(popc) = &mut member { popc.owe(debt)?; }`.
    ///
    /// A value takes the room of the largest member, the windowed credit, and a tag: with the default candidate 104 bytes
    /// in `f64` and 72 in `f32` (56 on a processor of 32 bits, 64 there on six axes). A step costs a call more than the
    /// member's own (docs/telemetry.md has numbers). The code of all members is linked in.
    ///
    /// ```
    /// use lyapunov_core::{HeldTick, ParameterError, PortEnergy, Stabilizer};
    /// use lyapunov_stabilizers::{DampingLimit, ForceBound, Member, NoStabilizer, Popc, StabilizerExt};
    /// fn named(name: &str) -> Result<Member<f64>, ParameterError> {
    ///     let popc = Popc::new(PortEnergy, DampingLimit::of_mass(0.5, 0.2, 1e-3)?);
    ///     Ok(match name {
    ///         "popc" => Member::Popc(popc),
    ///         "popc-bounded" => Member::Bounded(popc.bounded(1e-3)?),
    ///         "force-bound" => Member::ForceBound(ForceBound::new(0.1)?),
    ///         _ => Member::NoStabilizer(NoStabilizer),
    ///     })
    /// }
    /// let tick = HeldTick { period: 1e-3, position: 1e-4, velocity: 0.1, displacement: 1e-4, applied: -2.0 };
    /// let sample = tick.sample(); // a debt of 0.2 mJ
    /// let efforts = ["none", "popc"].map(|name| named(name).unwrap().stabilize(&sample, 0.5).effort);
    /// assert!(efforts[0] == 0.5 && efforts[1] > 0.5);
    /// assert_eq!(named("popc-bounded")?.name(), "popc-bounded");
    /// assert_eq!((size_of::<Member<f64>>(), size_of::<Member<f32>>()), (104, 72));
    /// # Ok::<(), ParameterError>(())
    /// ```
    pub enum Member<V, C = (PortEnergy, Dissipation<Of<V>>)>, remembered as MemberState {
        NoStabilizer "none" NoStabilizer,
        Popc "popc" Popc<Of<V>>,
        Lolc "lolc" Lolc<Of<V>, C>,
        Bounded "popc-bounded" BoundedCredit<Popc<Of<V>>, Of<V>>,
        Windowed "popc-windowed" Popc<Of<V>, Held, Window<V>>,
        Threshold "popc-threshold" VelocityThreshold<Popc<Of<V>>, Of<V>>,
        Spread "popc-spread" Spread<Popc<Of<V>>, Of<V>>,
        RateLimited "popc-rate-limited" RateLimit<Popc<Of<V>>, V>,
        Rising "popc-rising" SoftStart<Popc<Of<V>>, Of<V>>,
        Weighted "popc-weighted" DirectedDamping<Popc<Of<V>>, AxisWeights<V>, Of<V>>,
        Directed "popc-directed" DirectedDamping<Popc<Of<V>>, AlongDirection<V>, Of<V>>,
        ForceBound "force-bound" ForceBound<Of<V>>,
        Tank "tank" Tank<Of<V>, PortEnergy>,
        EnergyBounding "energy-bounding" EnergyBounding<V>,
        ForceBounding "force-bounding" ForceBounding<Of<V>>,
        LeastNorm "least-norm" LeastNorm<Of<V>, PortEnergy>,
        SlopeBound "slope-bound" SlopeBound<V>,
    }
}

impl<V: Signal, C> StabilizerExt for Member<V, C> {}

/// What the page of the enumeration says of a processor of 32 bits, where its tests do not run.
#[cfg(target_pointer_width = "32")]
const _: () =
    assert!(size_of::<Member<f32>>() == 56 && size_of::<Member<nalgebra::Vector6<f32>>>() == 64);
