//! Runs of single cells, for scenes with parts that the kernel does not have.

use lyapunov::{ParameterError, Scalar};

use super::outcome::{Measures, Outcome};
use crate::files::scene::Scene;
use crate::measure::{Chatter, Energies, Fate, Physical, Settling, Share, Verdict};
use crate::simulate::family::StabilizerName;
use crate::simulate::{Criterion, Rollout, Space, Tick, in_space};

/// Ticks between two checks whether the verdict is decided.
const STRETCH: u64 = 64;

/// Outcome of the run of `scene` under `member`; none if `go_on` stopped it. A lost run is not run to its end.
pub(super) fn outcome(
    scene: &Scene,
    member: StabilizerName,
    go_on: &(dyn Fn() -> bool + Sync),
) -> Result<Option<Outcome>, ParameterError> {
    in_space!(scene, Axes => run::<Axes>(scene, member, go_on))
}

fn run<V: Space>(
    scene: &Scene,
    member: StabilizerName,
    go_on: &(dyn Fn() -> bool + Sync),
) -> Result<Option<Outcome>, ParameterError> {
    let mut fate = Fate::<f64>::of(scene);
    let mut meters = Meters::<V>::new(scene, fate.criterion(0));
    let mut ticks = 0;
    for tick in Rollout::<V>::under(scene, member)? {
        fate.add_tick(&tick);
        meters.add(&tick);
        ticks += 1;
        if ticks % STRETCH == 0 {
            if fate.is_lost(0) {
                break;
            }
            if !go_on() {
                return Ok(None);
            }
        }
    }
    let verdict = fate.verdict(0);
    let measures = match verdict {
        Verdict::Grows => Measures::default(),
        _ => {
            let measures = meters.finish(scene);
            Measures { active: measures.active.filter(|_| member.reports_damping()), ..measures }
        }
    };
    Ok(Some(Outcome { verdict, verdict_by: fate.verdict_by(0), measures }))
}

struct Meters<V: Space> {
    criterion: Criterion,
    ticks: u64,
    active: u64,
    peak: f64,
    settling: Settling<f64>,
    share: Share<V::Double>,
    energies: Energies<V::Double>,
    physical: Physical<V::Double>,
    chatter: Option<Chatter<V::Double>>,
}

impl<V: Space> Meters<V> {
    fn new(scene: &Scene, criterion: &Criterion) -> Self {
        let (rest, band) = criterion.rest();
        Self {
            criterion: criterion.clone(),
            ticks: 0,
            active: 0,
            peak: 0.0,
            settling: Settling::new(rest, band),
            share: Share::new::<V>(scene),
            energies: Energies::new(),
            physical: Physical::new(scene),
            chatter: Chatter::new(scene.servo_rate.get()),
        }
    }

    fn add(&mut self, tick: &Tick<V>) {
        let (position, force) = (tick.truth.position.double(), tick.applied.double());
        let split = self.share.split(tick);
        self.ticks += 1;
        self.active += u64::from(tick.correction.alpha.lane(0) > 0.0);
        self.peak = self.peak.max(force.length());
        self.settling.add(self.criterion.coordinate(position));
        self.energies.add(position, split.environment, split.controller);
        self.physical.add(tick, &split);
        if let Some(chatter) = &mut self.chatter {
            chatter.add(force);
        }
    }

    fn finish(&self, scene: &Scene) -> Measures {
        let [given, beyond_damper] = self.physical.millijoules_given();
        Measures {
            peak_force: Some(self.peak),
            settling_time: self.settling.since(0).map(|tick| tick / scene.servo_rate.get()),
            energy_injected: Some(1e3 * self.energies.injected()),
            energy_taken: Some(1e3 * self.energies.taken()),
            active: Some(100.0 * self.active as f64 / self.ticks as f64),
            chatter: self.chatter.as_ref().and_then(Chatter::root_mean_square),
            energy_given: Some(given),
            energy_given_beyond_damper: Some(beyond_damper),
            force_felt: self.physical.force_felt(),
            stiffness_felt: self.physical.stiffness_felt().map(|(_, percent)| percent),
        }
        .in_range()
    }
}
