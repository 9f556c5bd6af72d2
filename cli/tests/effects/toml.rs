//! Scene file of a scene, and the file of its motion.

use std::fmt::Write;

use crate::effects::scene::{Axes, Environment, Filter, Kind, Motion, Scene, Stabilizer};

/// File of the motion, beside the scene, under the name that the scene gives it.
pub(crate) const MOTION_FILE: &str = "recorded/hand.csv";

impl Scene {
    pub(crate) fn toml(&self) -> String {
        let mut text = String::new();
        let mut line = |line: String| writeln!(text, "{line}").expect("a String takes every line");
        line(format!("duration = {:?}\nservo_rate = {:?}", self.duration, self.servo_rate));
        line(format!("environment_rate = {:?}", self.servo_rate / self.hold as f64));
        if self.exact {
            line("velocity = \"exact\"".to_owned());
        }
        if self.single {
            line("scalar = \"f32\"".to_owned());
        }
        if self.dimensions > 1 {
            line(format!("space.dimensions = {}", self.dimensions));
        }
        let operator = &self.operator;
        line(format!(
            "[operator]\nmass = {:?}\ndamping = {:?}\nstiffness = {:?}\nrest = {}",
            operator.mass,
            operator.damping,
            operator.stiffness,
            self.vector(operator.rest)
        ));
        line(format!("[device]\nmass = {:?}\ndamping = {:?}", self.device[0], self.device[1]));
        let (position, velocity) = (self.vector(self.position), self.vector(self.velocity));
        line(format!("[initial]\nposition = {position}\nvelocity = {velocity}"));
        line(self.environment());
        line(self.stabilizer.map_or(String::new(), stabilizer));
        self.hand().into_iter().chain(self.effects()).for_each(line);
        text
    }

    pub(crate) fn motion_file(&self) -> Option<String> {
        let Some(Motion::File { rows }) = &self.motion else {
            return None;
        };
        let line = |(t, rest): &(f64, f64)| format!("{t:?},{rest:?}\n");
        Some("t,rest\n".to_owned() + &rows.iter().map(line).collect::<String>())
    }

    fn vector(&self, axes: Axes) -> String {
        match self.dimensions {
            1 => format!("{:?}", axes[0]),
            several => format!("{:?}", &axes[..several]),
        }
    }

    fn environment(&self) -> String {
        let table = |name: &str, keys: &[(&str, f64)]| {
            let line = |(key, value): &(&str, f64)| format!("{key} = {value:?}\n");
            format!("[environment.{name}]\n") + &keys.iter().map(line).collect::<String>()
        };
        match self.environment {
            Environment::Wall { position, stiffness, damping } => table(
                "wall",
                &[("position", position), ("stiffness", stiffness), ("damping", damping)],
            ),
            Environment::Spring { position, stiffness } => {
                table("spring", &[("position", position), ("stiffness", stiffness)])
            }
            Environment::MassSpringDamper { position, mass, damping, stiffness } => {
                let body = [("mass", mass), ("damping", damping), ("stiffness", stiffness)];
                table("mass-spring-damper", &[&[("position", position)][..], &body].concat())
            }
            Environment::LayeredWall { position, depth, stiffness, damping } => {
                let keys = [("position", position), ("depth", depth), ("damping", damping)];
                table("layered-wall", &keys) + &format!("stiffness = {stiffness:?}")
            }
            Environment::HuntCrossley { position, stiffness, exponent, damping } => {
                let keys = [("stiffness", stiffness), ("exponent", exponent), ("damping", damping)];
                table("hunt-crossley", &[&[("position", position)][..], &keys].concat())
            }
            Environment::MovingWall { position, stiffness, damping, amplitude, frequency } => {
                let wall = [("position", position), ("stiffness", stiffness), ("damping", damping)];
                let motion = [("amplitude", amplitude), ("frequency", frequency)];
                table("moving-wall", &[&wall[..], &motion].concat())
            }
            Environment::VaryingSpring { position, stiffness, amplitude, frequency } => {
                let spring = [("position", position), ("stiffness", stiffness)];
                let change = [("amplitude", amplitude), ("frequency", frequency)];
                table("varying-spring", &[spring, change].concat())
            }
            Environment::CubicSpring { position, stiffness, cubic } => {
                let spring = [("position", position), ("stiffness", stiffness)];
                table("cubic-spring", &[&spring[..], &[("cubic", cubic)]].concat())
            }
            Environment::Plane { point, normal, stiffness, damping } => {
                table("plane", &[("stiffness", stiffness), ("damping", damping)])
                    + &format!("point = {}\nnormal = {}", self.vector(point), self.vector(normal))
            }
            Environment::Sphere { center, radius, stiffness, damping } => {
                let keys = [("radius", radius), ("stiffness", stiffness), ("damping", damping)];
                table("sphere", &keys) + &format!("center = {}", self.vector(center))
            }
            Environment::Cuboid { center, half, stiffness, damping } => {
                table("box", &[("stiffness", stiffness), ("damping", damping)])
                    + &format!("center = {}\nhalf = {}", self.vector(center), self.vector(half))
            }
        }
    }

    fn hand(&self) -> Vec<String> {
        let motion = self.motion.as_ref().map(|motion| {
            "[operator.motion]\n".to_owned()
                + &match motion {
                    Motion::Step { at, to } => format!("kind = \"step\"\nat = {at:?}\nto = {to:?}"),
                    Motion::Ramp { at, to, rate } => {
                        format!("kind = \"ramp\"\nat = {at:?}\nto = {to:?}\nrate = {rate:?}")
                    }
                    Motion::Sine { amplitude, frequency } => {
                        format!(
                            "kind = \"sine\"\namplitude = {amplitude:?}\nfrequency = {frequency:?}"
                        )
                    }
                    Motion::File { .. } => format!("kind = \"file\"\npath = {MOTION_FILE:?}"),
                }
        });
        let grip = self.grip.as_ref().map(|rows| {
            let list = |index: usize| rows.iter().map(|row| row[index]).collect::<Vec<f64>>();
            format!(
                "[operator.grip]\ntimes = {:?}\nstiffness = {:?}\ndamping = {:?}",
                list(0),
                list(1),
                list(2)
            )
        });
        motion.into_iter().chain(grip).collect()
    }

    fn effects(&self) -> Vec<String> {
        let link = self.link.map(|[k, b]| format!("[link]\nstiffness = {k:?}\ndamping = {b:?}"));
        let encoder = self.encoder.map(|r| format!("[effects.encoder]\nresolution = {r:?}"));
        let delay = (self.delay > 0).then(|| format!("[effects.delay]\nticks = {}", self.delay));
        let saturation = self.saturation.map(|f| format!("[effects.saturation]\nforce = {f:?}"));
        let filter = self.filter.map(|filter| match filter {
            Filter::Cutoff(cutoff) => format!("[effects.filter]\ncutoff = {cutoff:?}"),
            Filter::Window(ticks) => format!("[effects.filter]\nwindow = {ticks}"),
        });
        let chance = |name: &'static str| {
            move |(deviation, seed)| {
                format!("[effects.{name}]\ndeviation = {deviation:?}\nseed = {seed}")
            }
        };
        let dropout = self.dropout.map(|it| {
            let policy = if it.zero { "zero" } else { "hold" };
            let (probability, seed) = (it.probability, it.seed);
            format!("[effects.dropout]\nprobability = {probability:?}\nseed = {seed}\npolicy = {policy:?}")
        });
        let friction = self.friction.map(|it| {
            let (coulomb, breakaway, velocity) = (it.coulomb, it.breakaway, it.stribeck_velocity);
            format!("[effects.friction]\ncoulomb = {coulomb:?}\nstatic = {breakaway:?}\nstribeck_velocity = {velocity:?}")
        });
        let load = self.load.map(|force| format!("[effects.load]\nforce = {force:?}"));
        let pulse = self.pulse.map(|it| {
            let (start, duration, force) = (it.start, it.duration, it.force);
            format!(
                "[effects.pulse]\nstart = {start:?}\nduration = {duration:?}\nforce = {force:?}"
            )
        });
        let random = [self.noise.map(chance("noise")), self.jitter.map(chance("jitter")), dropout];
        let rest = [link, encoder, delay, saturation, filter, friction, load, pulse];
        random.into_iter().chain(rest).flatten().collect()
    }
}

fn stabilizer(stabilizer: Stabilizer) -> String {
    let work = if stabilizer.sampled { "sampled" } else { "held" };
    let name = match stabilizer.kind {
        Kind::Popc => "[stabilizer.popc]",
        Kind::MassSpringDamper => "[stabilizer.lolc]",
        Kind::DeviceDamping => "[stabilizer.lolc]\ncandidate = \"device-damping\"",
        Kind::Spring => "[stabilizer.lolc]\ncandidate = \"spring\"",
    };
    format!("{name}\nwork = {work:?}\ndamping_cap = {:?}", stabilizer.cap)
}
