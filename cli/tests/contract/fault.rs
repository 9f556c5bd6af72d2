//! Misreadings of the contract.

macro_rules! faults {
    ($($name:ident),+ $(,)?) => {
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub(crate) enum Fault {
            $($name),+
        }

        impl Fault {
            pub(crate) const ALL: &[Self] = &[$(Self::$name),+];
        }
    };
}

faults! {
    ForcePushes,
    RestForgotten,
    OperatorDampingForgotten,
    DeviceMassForgotten,
    DelayForgotten,
    DelayTooLong,
    HoldForgotten,
    HoldLate,
    WallPulls,
    WallPositionForgotten,
    EncoderRoundsDown,
    EncoderHalvesToEven,
    VelocityOfThePlant,
    VelocityOneTickOld,
    CreditNegative,
    CreditWithoutPeriod,
    CreditInFreeMotion,
    CreditOnlyAtEnvironmentTicks,
    CreditOnlyUnderForce,
    CreditOfAllDamping,
    WorkOfCommand,
    WorkOfNewForce,
    WorkNegative,
    SampledWithoutPeriod,
    SampledWithoutDamper,
    SampledWithNewDamper,
    ObserverAfterCorrection,
    DebtForgotten,
    DamperWithoutPeriod,
    DamperNegative,
    CapWithoutMass,
    CapOfDeviceMass,
    CapForgotten,
    ShortfallForgotten,
    SaturationBeforeController,
    SaturationOneSided,
    TimeOneTickLate,
}
