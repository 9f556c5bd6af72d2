//! The rules between the tables of the effects, the operator and the space.

use super::check::Conflict;
use super::environments::NAMES;
use super::keys::example;
use super::{Draft, Friction, Integrator, Stabilizer, Velocity};
use crate::text::{counted, found};

/// The largest angle, rad, through which a link may swing within a period: a larger one is rounded by a thousandth of a radian or
/// more, each tick a push that no motion has.
const MOST_TURN: f64 = 1.0 / (1024.0 * f64::EPSILON);

/// Share by which a told limit stays below the limit, so that the shown digits are within it.
const ROUNDING: f64 = 1e-3;

impl Draft {
    /// Checks each table whose values must fit each other or another table.
    pub(super) fn check_tables(&self) -> Result<(), Conflict> {
        self.check_filter()?;
        self.effects.friction.map_or(Ok(()), check_friction)?;
        self.check_integrator()?;
        self.check_link()?;
        self.check_grip()?;
        self.check_space()
    }

    fn check_filter(&self) -> Result<(), Conflict> {
        if self.effects.filter.is_none() || self.velocity != Velocity::Exact {
            return Ok(());
        }
        Err(Conflict::new(
            "effects.filter",
            "`effects.filter` filters a velocity that is taken from positions, and `velocity` is \"exact\"",
            "leave the filter out, or take `velocity = \"backward-difference\"`",
        ))
    }

    fn check_integrator(&self) -> Result<(), Conflict> {
        if self.effects.friction.is_none()
            || self.link.is_none()
            || self.integrator == Integrator::Exact
        {
            return Ok(());
        }
        Err(Conflict::new(
            "effects.friction",
            format!(
                "`effects.friction` behind a `link` moves exactly only, and `integrator` is \"{}\"",
                self.integrator.name()
            ),
            "take `integrator = \"exact\"`, or leave out the friction or the link",
        ))
    }

    fn check_link(&self) -> Result<(), Conflict> {
        let Some(link) = self.link else {
            return Ok(());
        };
        if self.operator.mass.get() > 0.0 {
            return self.check_turn(link.stiffness.get());
        }
        Err(Conflict::new(
            "operator.mass",
            "`operator.mass` must be greater than 0 where `link` joins operator and device, not 0.0",
            "give it in kg, for example `operator.mass = 0.1`, or leave out `link`: the two then move as one",
        )
        .asked_by("link"))
    }

    /// Checks that rounding knows how far a link of this `stiffness` turns within a period.
    fn check_turn(&self, stiffness: f64) -> Result<(), Conflict> {
        let (hand, device) = (self.operator.mass.get(), self.device.mass.get());
        let (rate, yielding) = (self.servo_rate.get(), hand.recip() + device.recip());
        let turn = (stiffness * yielding).sqrt() / rate;
        if turn <= MOST_TURN {
            return Ok(());
        }
        let most = (1.0 - ROUNDING) * (MOST_TURN * rate).powi(2) / yielding;
        Err(Conflict::new(
            "link.stiffness",
            format!(
                "`link.stiffness` = {stiffness:?} between {hand:?} and {device:?} kg swings through {} rad within one period, \
                 more than rounding tells apart",
                found(turn)
            ),
            format!(
                "give at most {} N/m, or leave out `link`: the two then move as one",
                found(most)
            ),
        ))
    }

    fn check_grip(&self) -> Result<(), Conflict> {
        let Some(grip) = &self.operator.grip else {
            return Ok(());
        };
        let times = grip.times.len();
        let lists = [("stiffness", grip.stiffness.len()), ("damping", grip.damping.len())];
        if let Some((name, length)) = lists.into_iter().find(|(_, length)| *length != times) {
            return Err(Conflict::new(
                format!("operator.grip.{name}"),
                format!("`operator.grip.{name}` has {length} numbers and `times` has {times}"),
                "give one stiffness and one damping for each time",
            ));
        }
        match grip.times.windows(2).find(|pair| pair[0] >= pair[1]) {
            None => Ok(()),
            Some(pair) => Err(Conflict::new(
                "operator.grip.times",
                format!(
                    "`operator.grip.times` has {:?} s after {:?} s",
                    pair[1].get(),
                    pair[0].get()
                ),
                "each time must be later than the one before",
            )),
        }
    }

    fn check_space(&self) -> Result<(), Conflict> {
        self.check_environment()?;
        let dimensions = self.dimensions();
        self.stabilizer.as_ref().map_or(Ok(()), |stabilizer| self.check_axes_of(stabilizer))?;
        let mut vectors = vec![
            ("initial.position".to_owned(), self.initial.position.len()),
            ("initial.velocity".to_owned(), self.initial.velocity.len()),
            ("operator.rest".to_owned(), self.operator.rest.len()),
        ];
        // An absent vector is the origin, or rest.
        vectors.retain(|(_, length)| *length != 0);
        let (name, kind) = (self.environment.name(), self.environment.kind());
        let own = kind.vectors().into_iter();
        vectors.extend(own.map(|(key, length)| (format!("environment.{name}.{key}"), length)));
        if let Some(stabilizer) = &self.stabilizer {
            let (name, own) = (stabilizer.name(), stabilizer.kind().vectors().into_iter());
            vectors.extend(own.map(|(key, length)| (format!("stabilizer.{name}.{key}"), length)));
        }
        if let Some((key, length)) = vectors.into_iter().find(|(_, length)| *length != dimensions) {
            let numbers = |count: usize| match count {
                1 => "one number".to_owned(),
                more => format!("a list of {more} numbers"),
            };
            return Err(Conflict::new(
                &key,
                format!(
                    "`{key}` is {}, and the scene has {}",
                    numbers(length),
                    counted(dimensions, "dimension")
                ),
                match dimensions {
                    1 => "give one number, or a table [space] with `dimensions = 2`".to_owned(),
                    more => {
                        format!("give {}, for example {}", numbers(more), example(&key, more))
                    }
                },
            ));
        }
        self.check_friction_in_space()?;
        kind.check()
    }

    fn check_friction_in_space(&self) -> Result<(), Conflict> {
        let dimensions = self.dimensions();
        if dimensions == 1 || self.effects.friction.is_none() {
            return Ok(());
        }
        let other = match (self.link.is_some(), self.integrator) {
            (true, _) => {
                "behind a `link` it would leave rest within a period, in a direction that turns"
            }
            (_, Integrator::Exact) => return Ok(()),
            _ => {
                "an integrator finds the instants of rest by the sign of the velocity, and a vector has none"
            }
        };
        Err(Conflict::new(
            "effects.friction",
            format!(
                "`effects.friction` in {dimensions} dimensions is for one mass that moves exactly: {other}"
            ),
            "take `integrator = \"exact\"` without a `link`, or leave out the friction",
        ))
    }

    /// Checks that a stabilizer works in as many dimensions as the scene has.
    ///
    /// # Errors
    /// A stabilizer for one dimension in a space.
    pub(crate) fn check_axes_of(&self, stabilizer: &Stabilizer) -> Result<(), Conflict> {
        if self.dimensions() == 1 || !stabilizer.is_on_a_line() {
            return Ok(());
        }
        Err(Conflict::new(
            format!("stabilizer.{}", stabilizer.name()),
            format!(
                "`stabilizer.{}` works in one dimension only, and the scene has {}",
                stabilizer.name(),
                self.dimensions()
            ),
            "take another, such as popc, or leave out [space]",
        ))
    }

    fn check_environment(&self) -> Result<(), Conflict> {
        let (name, dimensions) = (self.environment.name(), self.dimensions());
        let is_solid = self.environment.is_solid();
        if is_solid == (dimensions > 1) {
            return Ok(());
        }
        let remedy = if is_solid {
            format!(
                "add a table [space] with `dimensions = 2` or 3, or take an environment of one dimension: {}",
                NAMES[0].join(", ")
            )
        } else {
            let (last, others) = NAMES[1].split_last().unwrap_or((&"", &[]));
            format!("take {} or {last}, or leave out [space]", others.join(", "))
        };
        Err(Conflict::new(
            format!("environment.{name}"),
            format!("`environment.{name}` is not for {}", counted(dimensions, "dimension")),
            remedy,
        ))
    }
}

fn check_friction(friction: Friction) -> Result<(), Conflict> {
    let (coulomb, breakaway) = (friction.coulomb.get(), friction.breakaway());
    if breakaway < coulomb {
        return Err(Conflict::new(
            "effects.friction.static",
            format!(
                "`effects.friction.static` = {breakaway:?} N is less than `coulomb` = {coulomb:?} N"
            ),
            "what holds a device at rest is no less than what brakes it in motion: give at least `coulomb`",
        ));
    }
    if breakaway > coulomb && friction.stribeck_velocity.is_none() {
        return Err(Conflict::new(
            "effects.friction",
            "`effects.friction` lacks `stribeck_velocity`, over which `static` comes down to `coulomb`",
            "give it in m/s, for example `stribeck_velocity = 0.01`, or make the two forces equal",
        ));
    }
    Ok(())
}
