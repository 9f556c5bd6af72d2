//! Memories outside the family that are stored and go on bit for bit, and memories that cannot be right.

use lyapunov::{
    Correction, Lolc, OnePort, ParameterError, PortEnergy, PortSample, Snapshot, Stabilizer,
    environments::Spring,
    laws,
    stabilizers::{
        BoundedValve, EnergyTank, ForceBound, ForceBounding, InputToState, LeastNorm, MemoryBased,
        OpenValve, PathMemory, PerAxis, ReferenceDamper, Tank, TankLimits, Valve, WaveFilter,
    },
};
use nalgebra::{SVector, Vector2};

use crate::support::{Dice, PERIOD, limit, popc};

/// Something with a memory, in the place of a stabilizer.
#[derive(Clone)]
struct In<P>(P);

impl<P: Snapshot> Snapshot for In<P> {
    type State = P::State;

    fn state(&self) -> P::State {
        self.0.state()
    }

    fn restored(self, state: P::State) -> Result<Self, ParameterError> {
        Ok(Self(self.0.restored(state)?))
    }
}

impl<P: OnePort<f64>> Stabilizer<f64> for In<InputToState<P, f64>> {
    fn stabilize(&mut self, sample: &PortSample<f64>, _effort: f64) -> Correction<f64> {
        Correction { alpha: self.0.slope(), ..Correction::none(self.0.respond(sample)) }
    }
}

impl<L: Valve<f64>> Stabilizer<f64> for In<EnergyTank<f64, L>> {
    fn stabilize(&mut self, sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        let passed = self.0.pass(sample.period, sample.work, effort, sample.velocity);
        Correction { observed_energy: self.0.energy(), ..Correction::none(passed) }
    }
}

impl Stabilizer<f64> for In<WaveFilter<f64>> {
    fn stabilize(&mut self, _sample: &PortSample<f64>, effort: f64) -> Correction<f64> {
        Correction::none(self.0.pass(effort))
    }
}

/// From what is stored at any tick it goes on, and what is stored of that is the same again.
fn goes_on<S: Stabilizer<f64> + Snapshot + Clone>(one: &S) {
    laws::snapshot(one, laws::Samples::<f64>::new(PERIOD)).expect("the law");
    let mut running = one.clone();
    for (sample, effort) in laws::Samples::<f64>::new(PERIOD).take(300) {
        running.stabilize(&sample, effort);
        let again = one.clone().restored(running.state()).expect("a memory");
        assert!(again.state() == running.state(), "{:?}", running.state());
    }
}

fn spring() -> Spring<f64> {
    Spring::new(500.0).expect("a spring")
}

const STORE: TankLimits<f64> = TankLimits { start: 2e-3, floor: 1e-3, ceiling: 5e-3, power: 3.0 };

#[test]
fn what_is_no_member_goes_on() {
    goes_on(&In(InputToState::new(spring(), 1e4, 0.1).expect("a port")));
    goes_on(&In(InputToState::adaptive(spring(), 1.5, 0.1).expect("a port")));
    let inside = InputToState::new(spring(), 1e4, 0.0).expect("a port");
    goes_on(&In(InputToState::new(inside, 2e4, 0.1).expect("a port")));
    let tank = EnergyTank::new(STORE).expect("a tank");
    goes_on(&In(tank));
    goes_on(&In(tank.opening()));
    goes_on(&In(WaveFilter::new(0.25).expect("a filter")));
    let damper = ReferenceDamper::starting(2.0, |x: f64| x.max(0.0), -0.01).expect("a damper");
    goes_on(&Lolc::new((PortEnergy, damper), limit::<f64>()));
    goes_on(&MemoryBased::<f64, 16>::beyond(-0.01, 0.1).expect("a memory"));
    goes_on(&PathMemory::<f64, 16>::beyond(-0.01, 0.1).expect("a memory"));
    goes_on(&ForceBounding::of_damping(0.1).and_then(|it| it.delayed::<4>(3)).expect("a pipe"));
    goes_on(&Tank::new(PortEnergy, STORE).expect("a tank"));
    goes_on(&LeastNorm::new(PortEnergy, limit::<f64>(), 0.3).expect("a filter"));
    let axes = PerAxis::of([popc::<f64>(), popc::<f64>()]);
    laws::snapshot(&axes, laws::Samples::<Vector2<f64>>::new(PERIOD)).expect("the law");
}

/// A port that was asked elsewhere goes on with the last answer, the place it was asked at, the shift and the slope.
#[test]
fn a_port_that_is_restored_shifts_as_before() {
    for share in [None, Some(2.0)] {
        let made = || match share {
            None => InputToState::<_, f64>::new(spring(), 1e3, 2e-3).expect("a port"),
            Some(share) => InputToState::adaptive(spring(), share, 2e-3).expect("a port"),
        };
        let (mut port, mut dice) = (made(), Dice::of(31));
        let mut position = 0.0;
        for tick in 0..40 {
            let displacement = dice.within(1e-3);
            position += displacement;
            let velocity = displacement / PERIOD;
            let sample =
                PortSample { displacement, ..PortSample::starting(PERIOD, position, velocity) };
            let mut again = made().restored(port.state()).expect("a memory");
            let answers = [port.respond(&sample), again.respond(&sample)];
            assert_eq!(answers[0].to_bits(), answers[1].to_bits(), "tick {tick}");
            assert_eq!(
                format!("{:?}", port.state()),
                format!("{:?}", again.state()),
                "tick {tick}"
            );
        }
        assert!(port.slope() >= 1e3 * (1.0 - 1e-9));
    }
}

fn refused<T>(made: Result<T, ParameterError>, parameter: &str) {
    let error = made.err().map(|error| error.parameter);
    assert_eq!(error, Some(parameter));
}

/// A memory that cannot be right is refused, with the name of the number.
#[test]
fn a_memory_that_cannot_be_right_is_refused() {
    let bad = f64::NAN;
    let port = || InputToState::<_, f64>::new(spring(), 1e3, 0.0).expect("a port");
    assert!(port().restored(((), f64::INFINITY, 1.0, bad, 0.0)).is_ok());
    refused(port().restored(((), -1.0, 1.0, bad, 0.0)), "stored slope");
    refused(port().restored(((), 1.0, bad, bad, 0.0)), "stored answer");
    refused(port().restored(((), 1.0, 1.0, f64::INFINITY, 0.0)), "stored position");
    refused(port().restored(((), 1.0, 1.0, bad, bad)), "stored shift");

    refused(EnergyTank::new(STORE).expect("a tank").restored(bad), "stored sum");
    refused(WaveFilter::new(0.5).expect("a filter").restored(bad), "stored wave");
    let damper = ReferenceDamper::starting(2.0, |x: f64| x, 0.0).expect("a damper");
    refused(damper.restored(f64::INFINITY), "stored deformation");

    let memory = MemoryBased::<f64, 2>::beyond(0.0, 1.0).expect("a memory");
    let (forces, pulling) = (SVector::from([1.0, 0.0]), SVector::from([1.0, -1.0]));
    assert!(memory.restored((None, forces, 0.0)).is_ok());
    refused(memory.restored((Some(f64::INFINITY), forces, 0.0)), "stored depth");
    refused(memory.restored((None, pulling, 0.0)), "stored force");
    assert!(memory.restored((None, forces, bad)).is_err());
    let path = PathMemory::<f64, 2>::beyond(0.0, 1.0).expect("a memory");
    refused(path.restored((pulling, 0.0)), "stored force");
    refused(path.restored((forces, 1.0)), "stored debt");

    let pipe = ForceBounding::of_damping(0.1).and_then(|it| it.delayed::<2>(1)).expect("a pipe");
    refused(pipe.restored((0.0, pulling)), "stored cost");
    assert!(pipe.restored((bad, forces)).is_err());
    assert!(Tank::new(PortEnergy, STORE).expect("a tank").restored(((), bad)).is_err());
    let filter = LeastNorm::new(PortEnergy, limit::<f64>(), 0.5).expect("a filter");
    assert!(filter.restored(((), bad)).is_err());
    let axes = PerAxis::of([popc::<f64>(), popc::<f64>()]);
    assert!(axes.restored(SVector::from([((), 1.0), ((), bad)])).is_err());
    assert!(
        ForceBound::<f64>::new(0.1).expect("a bound").restored((bad, SVector::from([]))).is_err()
    );
}

/// Nothing is in a place of the pipe that the delay leaves out, whatever was stored.
#[test]
fn a_place_that_is_left_out_holds_nothing() {
    let pipe = ForceBounding::of_damping(0.1).and_then(|it| it.delayed::<3>(1)).expect("a pipe");
    let restored = pipe.restored((2e-3, SVector::from([1e-3, 1e-3, 1e-3]))).expect("a memory");
    assert_eq!(restored.state(), (2e-3, SVector::from([1e-3, 0.0, 0.0])));
}

/// The valves, that of a name each.
#[test]
fn a_valve_is_open_or_bounded() {
    let share = |asked: f64, energy: f64| {
        let open = OpenValve.share(&STORE, energy, asked, PERIOD);
        (open, BoundedValve.share(&STORE, energy, asked, PERIOD))
    };
    assert_eq!(share(-5.0, 0.0), (1.0, 1.0));
    assert_eq!(share(2.0, STORE.floor), (0.0, 0.0));
    assert_eq!(share(2.0, 0.0), (0.0, 0.0));
    let (open, bounded) = share(4.0, STORE.floor + 1e-3);
    assert!(open == 1.0 && (bounded - 0.25).abs() < 1e-14);
    let (_, bounded) = share(12.0, STORE.floor + 1.0);
    assert!((bounded - 0.25).abs() < 1e-14, "3 W of the 12 are handed out");
}
