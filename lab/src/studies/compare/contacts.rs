//! Contact meters: forces while the environment pushes.

use std::fmt;

use lyapunov::Signal;

use crate::files::scene::Scene;
use crate::measure::SolidError;
use crate::measure::stiffness_felt::LONG;
use crate::simulate::Space;

/// One tick, as the hand feels it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Touch<V> {
    /// The plant's true position, m.
    pub(super) position: V,
    /// The plant's own velocity, m/s.
    pub(super) velocity: V,
    /// The force on the plant, N.
    pub(super) force: V,
    /// The environment's share of it, N.
    pub(super) environment: V,
}

/// Watches contacts: unbroken runs of ticks on which the environment's force acts.
pub(super) struct Contacts<V: Signal> {
    /// None without the wall or solid that it is measured against; the other meters need none.
    error: Option<SolidError<V>>,
    long: f64,
    now: Contact,
    short_peak: Option<f64>,
    long_peak: Option<f64>,
}

#[derive(Clone, Copy, Debug, Default)]
struct Contact {
    ticks: u64,
    peak: f64,
}

impl<V: Signal> fmt::Debug for Contacts<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Contacts").finish_non_exhaustive()
    }
}

impl<V: Space<Scalar = f64>> Contacts<V> {
    pub(super) fn new(scene: &Scene) -> Self {
        Self {
            error: SolidError::of(scene),
            long: LONG * scene.servo_rate.get(),
            now: Contact::default(),
            short_peak: None,
            long_peak: None,
        }
    }

    pub(super) fn add(&mut self, touch: &Touch<V>) {
        let acts = touch.environment != V::zero();
        if acts {
            self.now.ticks += 1;
            self.now.peak = self.now.peak.max(touch.force.length());
        } else {
            self.end();
        }
        if let Some(error) = &mut self.error {
            error.add([touch.position, touch.velocity], touch.force, touch.environment);
        }
    }

    /// Ends the current contact, if there is one; to be called after the last tick too.
    pub(super) fn end(&mut self) {
        let contact = std::mem::take(&mut self.now);
        if contact.ticks == 0 {
            return;
        }
        let is_long = contact.ticks as f64 >= self.long;
        let peak = if is_long { &mut self.long_peak } else { &mut self.short_peak };
        *peak = Some(peak.unwrap_or(0.0).max(contact.peak));
    }

    /// Largest `|f_act|` in contacts shorter than half a second, N.
    pub(super) fn short_peak(&self) -> Option<f64> {
        self.short_peak
    }

    /// Largest `|f_act|` in contacts of half a second or more, N.
    pub(super) fn long_peak(&self) -> Option<f64> {
        self.long_peak
    }

    /// Root mean square of `f_act − f_ideal` in contact, N.
    pub(super) fn force_error(&self) -> Option<f64> {
        self.error.as_ref().and_then(SolidError::root_mean_square)
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_abs_diff_eq;

    use super::*;
    use crate::measure::samples::scene;

    /// A tick with the plant at `x`; `environment` is the wall's part of the force, `controller` the rest.
    fn tick(x: f64, environment: f64, controller: f64) -> Touch<f64> {
        Touch { position: x, velocity: 0.0, force: environment + controller, environment }
    }

    /// The meter after `ticks`; the wall is 1 kN/m at 1 mm, the rate 100 Hz.
    fn after(ticks: &[Touch<f64>]) -> Contacts<f64> {
        let mut contacts = Contacts::new(&scene(""));
        ticks.iter().for_each(|tick| contacts.add(tick));
        contacts.end();
        contacts
    }

    #[test]
    fn peaks_are_split_at_half_a_second_and_nothing_is_merged() {
        let push = |force: f64| tick(0.002, force, 0.0);
        let mut ticks = vec![push(7.0); 49];
        ticks.push(push(0.0));
        ticks.extend(vec![push(2.0); 50]);
        let contacts = after(&ticks);
        assert_eq!((contacts.short_peak(), contacts.long_peak()), (Some(7.0), Some(2.0)));
        // One tick without force makes two short contacts of a long one.
        ticks[75] = push(0.0);
        assert_eq!(after(&ticks).long_peak(), None);
        assert_eq!(after(&[push(0.0); 100]).short_peak(), None);
    }

    #[test]
    fn a_peak_is_of_the_whole_force_on_the_plant() {
        let contacts = after(&[tick(0.002, 1.0, -4.0), tick(0.0, 0.0, 9.0)]);
        assert_eq!(contacts.short_peak(), Some(3.0));
    }

    #[test]
    fn the_force_error_counts_late_forces_and_missing_ones() {
        let right = tick(0.003, 2.0, 0.0);
        let missing = tick(0.002, 0.0, 0.0); // 1 N is due
        let late = tick(0.0, 0.5, 0.0); // nothing is due
        let damped = tick(0.003, 2.0, 0.25);
        let free = tick(0.0, 0.0, 0.0);
        let error = after(&[right, missing, late, damped, free, free]).force_error().unwrap();
        let expected = f64::sqrt((1.0 + 0.25 + 0.0625) / 4.0);
        assert_abs_diff_eq!(error, expected, epsilon = 1e-12);
        assert_eq!(after(&[free]).force_error(), None);
    }

    #[test]
    fn the_ideal_wall_never_pulls_and_knows_the_surface() {
        // 1000 N/m, 2 N·s/m, surface at 1 mm; the error of a force of 1 N, which counts before the surface too.
        let off = |position: f64, velocity: f64| {
            after(&[Touch { velocity, ..tick(position, 1.0, 0.0) }]).force_error().unwrap()
        };
        assert_eq!(off(0.001, 1.0), 1.0);
        assert_eq!(off(0.0005, 1.0), 1.0);
        assert_abs_diff_eq!(off(0.003, 0.5), 3.0 - 1.0, epsilon = 1e-12);
        assert_eq!(off(0.003, -5.0), 1.0);
    }
}
