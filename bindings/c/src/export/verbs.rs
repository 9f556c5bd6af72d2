//! Groups of functions that blocks have.

/// A group of functions of one block on one signal.
macro_rules! verbs {
    (life, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// Makes the block of parameters that fit together. Called through the macro without `_abi`, which tells the
            /// version of the header.
            fn init_abi(storage: *mut Storage<Block>, parameters: *const Parameters, abi: u32) -> Status {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::init(storage, parameters, abi) }
            }
            /// Changes the parameters between ticks; the memory stays, so that a `budget` or `start` among them, which init alone reads,
            /// changes nothing. A refused change changes nothing.
            fn retune(storage: *mut Storage<Block>, parameters: *const Parameters) -> Status {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::retune(storage, parameters) }
            }
            /// Takes the memory out, to be stored over a restart.
            fn save(storage: *const Storage<Block>, memory: *mut Memory) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::save(storage, memory) }
            }
            /// Puts a stored memory in place of the own one. A refused one changes nothing.
            fn restore(storage: *mut Storage<Block>, memory: *const Memory) -> Status {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::restore(storage, memory) }
            }
        }
    };
    (stabilizer, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// One tick: what the other side did, and the effort that your controller asks for; out comes the correction.
            fn step(storage: *mut Storage<Block>, sample: *const SampleForm<V>, effort: <V as Port>::Given, correction: *mut CorrectionForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::step(storage, sample, effort, correction) }
            }
        }
    };
    (custom, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// One tick. `candidate` is called once, with `context` and the sample, and gives the decrease over it, J; it must not touch
            /// this storage. A value that is not finite rejects the sample.
            fn step(storage: *mut Storage<Block>, sample: *const SampleForm<V>, effort: <V as Port>::Given, candidate: $crate::told::Candidate<V>, context: *mut core::ffi::c_void, correction: *mut CorrectionForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::called(storage, sample, effort, (candidate, context), correction, |body, value| body.candidate_mut().decrease = value) }
            }
        }
    };
    (storage, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// One tick. `energy` is called once, with `context` and the sample, and gives V there, J; it must not touch this storage.
            fn step(storage: *mut Storage<Block>, sample: *const SampleForm<V>, effort: <V as Port>::Given, energy: $crate::told::Energy<V>, context: *mut core::ffi::c_void, correction: *mut CorrectionForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::called(storage, sample, effort, (energy, context), correction, |body, value| body.candidate_mut().now = value) }
            }
        }
    };
    (observer, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// Books a sample; writes the observed energy, J. A decrease that is not finite is left out.
            fn observe(storage: *mut Storage<Block>, sample: *const SampleForm<V>, energy: *mut T) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::watched::observe(storage, sample, energy) }
            }
        }
    };
    (meter, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// Adds a tick. A correction whose observed energy or shortfall is not finite, which no block gives, is left out and not
            /// counted.
            fn add(storage: *mut Storage<Block>, sample: *const SampleForm<V>, correction: *const CorrectionForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::watched::add(storage, sample, correction) }
            }
            /// Writes the energies up to now.
            fn summary(storage: *const Storage<Block>, summary: *mut $crate::watched::SummaryForm<T>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::watched::summary(storage, summary) }
            }
        }
    };
    (reading, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of this tick's reading: the position now, and the effort that the motor applied since the last.
            fn read(storage: *mut Storage<Block>, position: <V as Port>::Given, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [position, applied], checked, |body, [position, applied]| body.read(Reading { position, applied })) }
            }
            /// The sample of a tick without a reading.
            fn missed(storage: *mut Storage<Block>, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| body.missed(applied)) }
            }
        }
    };
    (moving_reading, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of this tick's reading: position and velocity now, and the effort that the motor applied since the last.
            fn read_moving(storage: *mut Storage<Block>, position: <V as Port>::Given, velocity: <V as Port>::Given, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [position, velocity, applied], checked, |body, [position, velocity, applied]| body.read_moving(MovingReading { position, velocity, applied })) }
            }
            /// The sample of a tick without a reading.
            fn missed_moving(storage: *mut Storage<Block>, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| body.missed_moving(applied)) }
            }
        }
    };
    (reading_at, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of the reading at the time `now`, s from any start.
            fn read_at(storage: *mut Storage<Block>, now: f64, position: <V as Port>::Given, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [position, applied], checked, |body, [position, applied]| body.read_at(now, Reading { position, applied })) }
            }
            /// The sample of a tick without a reading at the time `now`, s.
            fn missed_at(storage: *mut Storage<Block>, now: f64, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| body.missed_at(now, applied)) }
            }
        }
    };
    (moving_reading_at, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of the reading at the time `now`, s from any start.
            fn read_moving_at(storage: *mut Storage<Block>, now: f64, position: <V as Port>::Given, velocity: <V as Port>::Given, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [position, velocity, applied], checked, |body, [position, velocity, applied]| body.read_moving_at(now, MovingReading { position, velocity, applied })) }
            }
            /// The sample of a tick without a reading at the time `now`, s.
            fn missed_moving_at(storage: *mut Storage<Block>, now: f64, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| body.missed_moving_at(now, applied)) }
            }
        }
    };
    (pose_reading, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of this tick's reading: the pose now, and the wrench that the motors applied since the last.
            fn read(storage: *mut Storage<Block>, pose: *const PoseForm<T>, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::poses::read(storage, pose, [applied], checked, |body, position, [applied]| body.read(Reading { position, applied })) }
            }
            /// The sample of a tick without a reading.
            fn missed(storage: *mut Storage<Block>, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| $crate::poses::seen(body.missed(applied.into()))) }
            }
        }
    };
    (moving_pose_reading, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of this tick's reading: pose and twist now, and the wrench that the motors applied since the last.
            fn read_moving(storage: *mut Storage<Block>, pose: *const PoseForm<T>, velocity: <V as Port>::Given, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::poses::read(storage, pose, [velocity, applied], checked, |body, position, [velocity, applied]| body.read_moving(MovingReading { position, velocity, applied })) }
            }
            /// The sample of a tick without a reading.
            fn missed_moving(storage: *mut Storage<Block>, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| $crate::poses::seen(body.missed_moving(applied.into()))) }
            }
        }
    };
    (pose_reading_at, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of the reading at the time `now`, s from any start.
            fn read_at(storage: *mut Storage<Block>, now: f64, pose: *const PoseForm<T>, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::poses::read(storage, pose, [applied], checked, |body, position, [applied]| body.read_at(now, Reading { position, applied })) }
            }
            /// The sample of a tick without a reading at the time `now`, s.
            fn missed_at(storage: *mut Storage<Block>, now: f64, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| $crate::poses::seen(body.missed_at(now, applied.into()))) }
            }
        }
    };
    (moving_pose_reading_at, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The sample of the reading at the time `now`, s from any start.
            fn read_moving_at(storage: *mut Storage<Block>, now: f64, pose: *const PoseForm<T>, velocity: <V as Port>::Given, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::poses::read(storage, pose, [velocity, applied], checked, |body, position, [velocity, applied]| body.read_moving_at(now, MovingReading { position, velocity, applied })) }
            }
            /// The sample of a tick without a reading at the time `now`, s.
            fn missed_moving_at(storage: *mut Storage<Block>, now: f64, applied: <V as Port>::Given, checked: *mut CheckedForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::readings::read(storage, [applied], checked, |body, [applied]| $crate::poses::seen(body.missed_moving_at(now, applied.into()))) }
            }
        }
    };
    (place, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// Forgets the position: the next reading displaces nothing, as the first. For a device that was moved without being read.
            fn restart(storage: *mut Storage<Block>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::change(storage, |body| body.restart()) }
            }
        }
    };
    (side, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// What this side absorbed since the start, J, to be sent to the other; NaN if the storage is not initialised.
            fn absorbed(storage: *const Storage<Block>) -> T {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::told_by(storage, |body| body.absorbed()) }
            }
            /// The energy that the other side told it absorbed, J. Packets may come late, twice or not at all: one that is not finite,
            /// or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are
            /// ignored: check packets before, by a checksum.
            fn receive(storage: *mut Storage<Block>, energy: T) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::change(storage, |body| body.receive(energy)) }
            }
        }
    };
    (layer, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// What this side sent since the start, J, to be told the other; NaN if the storage is not initialised.
            fn sent(storage: *const Storage<Block>) -> T {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::told_by(storage, |body| body.sent()) }
            }
            /// The energy that the other side told it sent, J. Packets may come late, twice or not at all: one that is not finite,
            /// or not above the largest so far, is ignored. A false one that is above it stays, and later true ones below it are
            /// ignored: check packets before, by a checksum.
            fn receive(storage: *mut Storage<Block>, energy: T) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::change(storage, |body| body.receive(energy)) }
            }
        }
    };
    (wave, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The waves of a flow and an effort.
            fn encode(storage: *const Storage<Block>, flow: <V as Port>::Given, effort: <V as Port>::Given, wave: *mut WaveForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::answered::answer_of(storage, [flow, effort], wave, |wave, [flow, effort]| WaveForm::of(flow, effort, wave.encode(flow, effort))) }
            }
            /// The flow and the effort of the waves there and back.
            fn decode(storage: *const Storage<Block>, there: <V as Port>::Given, back: <V as Port>::Given, wave: *mut WaveForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe {
                    $crate::answered::answer_of(storage, [there, back], wave, |wave, [there, back]| {
                        let (flow, effort) = wave.decode(there, back);
                        WaveForm::of(flow, effort, (there, back))
                    })
                }
            }
            /// The effort where the flow is known and the wave `back` came in, and the wave that goes there.
            fn effort(storage: *const Storage<Block>, flow: <V as Port>::Given, back: <V as Port>::Given, wave: *mut WaveForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe {
                    $crate::answered::answer_of(storage, [flow, back], wave, |wave, [flow, back]| {
                        let (effort, there) = wave.effort(flow, back);
                        WaveForm::of(flow, effort, (there, back))
                    })
                }
            }
            /// The flow where the effort is known and the wave `there` came in, and the wave that goes back.
            fn flow(storage: *const Storage<Block>, effort: <V as Port>::Given, there: <V as Port>::Given, wave: *mut WaveForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe {
                    $crate::answered::answer_of(storage, [effort, there], wave, |wave, [effort, there]| {
                        let (flow, back) = wave.flow(effort, there);
                        WaveForm::of(flow, effort, (there, back))
                    })
                }
            }
        }
    };
    (wave_filter, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The wave to send for `wave`. One that is not finite is passed over.
            fn pass(storage: *mut Storage<Block>, wave: <V as Port>::Given, sent: *mut Form) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::answered::answer(storage, [wave], sent, |body, [wave]| body.pass(wave).form()) }
            }
        }
    };
    (wave_follower, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The answer to the wave `there`, at the error of the spring (commanded position minus the slave's), m, and the slave's
            /// velocity, m/s: the flow that is commanded, the effort on the slave, and the wave that goes back.
            fn follow(storage: *const Storage<Block>, there: <V as Port>::Given, error: <V as Port>::Given, velocity: <V as Port>::Given, wave: *mut WaveForm<V>) -> u32 {
                // SAFETY: as the caller says.
                unsafe {
                    $crate::answered::answer_of(storage, [there, error, velocity], wave, |follower, [there, error, velocity]| {
                        let following = follower.follow(there, error, velocity);
                        WaveForm::of(following.flow, following.effort, (there, following.back))
                    })
                }
            }
        }
    };
    (drawn, $name:literal, $signal:literal) => {
        $crate::export::exported! { $name, $signal, describe;
            /// The part of the wished input that passes over `period` s at the flow it acts on (wished times flow above 0 extracts),
            /// while `dissipated` W flow in; below 0 they count as 0. What is not finite passes nothing and leaves the tank as it is.
            fn pass(storage: *mut Storage<Block>, period: T, dissipated: T, wished: <V as Port>::Given, flow: <V as Port>::Given, passed: *mut Form) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::answered::answer(storage, [wished, flow], passed, |body, [wished, flow]| body.pass(period, dissipated, wished, flow).form()) }
            }
            /// The energy in it, J; NaN if the storage is not initialised.
            fn energy(storage: *const Storage<Block>) -> T {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::told_by(storage, |body| body.energy()) }
            }
        }
    };
    (account, $name:literal, $signal:literal) => {
        use lyapunov::stabilizers::Account;

        $crate::export::exported! { $name, $signal, describe;
            /// The observed energy, J; NaN if the storage is not initialised.
            fn observed_energy(storage: *const Storage<Block>) -> T {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::told_by(storage, |body| Account::observed_energy(body)) }
            }
            /// Sets the observed energy to 0: credit is forfeited, a debt forgiven.
            fn reset(storage: *mut Storage<Block>) -> u32 {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::change(storage, |body| Account::<T>::reset(body)) }
            }
            /// Adds as many joules of credit that were not absorbed.
            fn grant(storage: *mut Storage<Block>, energy: T) -> Status {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::ask(storage, |body| Account::<T>::grant(body, energy)) }
            }
            /// Adds a debt of as many joules.
            fn owe(storage: *mut Storage<Block>, debt: T) -> Status {
                // SAFETY: as the caller says.
                unsafe { $crate::verbs::ask(storage, |body| Account::<T>::owe(body, debt)) }
            }
        }
    };
}

pub(crate) use verbs;
