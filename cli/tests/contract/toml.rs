//! The scene file of a scene.

use std::fmt::Write;

use crate::contract::scene::{Kind, Scalar, Scene, Stabilizer, Velocity, Work};

impl Scene {
    pub(crate) fn toml(&self) -> String {
        let mut text = Text { text: String::new(), terse: self.terse };
        text.number("duration", self.duration, None);
        text.number("servo_rate", self.servo_rate, None);
        let environment_rate = self.servo_rate / self.hold as f64;
        text.number("environment_rate", environment_rate, Some(self.servo_rate));
        match self.velocity {
            Velocity::Exact => text.word("velocity", "exact", false),
            Velocity::BackwardDifference => text.word("velocity", "backward-difference", true),
        }
        match self.scalar {
            Scalar::F64 => text.word("scalar", "f64", true),
            Scalar::F32 => text.word("scalar", "f32", false),
        }
        text.word("integrator", "exact", true);

        let o = &self.operator;
        let keys = ["mass", "damping", "stiffness", "rest"];
        text.table("operator", &keys, &[o.mass, o.damping, o.stiffness, o.rest]);
        text.line("[device]");
        text.number("mass", self.device.mass, None);
        text.number("damping", self.device.damping, Some(0.0));
        let start = [self.initial.position, self.initial.velocity];
        text.table("initial", &["position", "velocity"], &start);
        text.line("[environment.wall]");
        text.number("position", self.wall.position, Some(0.0));
        text.number("stiffness", self.wall.stiffness, None);
        text.number("damping", self.wall.damping, Some(0.0));
        if let Some(stabilizer) = &self.stabilizer {
            text.stabilizer(stabilizer, self.default_cap());
        }
        if let Some(resolution) = self.encoder {
            text.line("[effects.encoder]");
            text.number("resolution", resolution, None);
        }
        if self.delay > 0 || !self.terse {
            text.line("[effects.delay]");
            text.line(&format!("ticks = {}", self.delay));
        }
        if let Some(force) = self.saturation {
            text.line("[effects.saturation]");
            text.number("force", force, None);
        }
        text.text
    }
}

struct Text {
    text: String,
    terse: bool,
}

impl Text {
    fn line(&mut self, line: &str) {
        writeln!(self.text, "{line}").expect("a String takes every line");
    }

    fn number(&mut self, key: &str, value: f64, default: Option<f64>) {
        if self.terse && default == Some(value) {
            return;
        }
        let line = if self.terse && value.fract() == 0.0 && value.abs() < 1e15 {
            format!("{key} = {}", value as i64)
        } else {
            format!("{key} = {value:?}")
        };
        self.line(&line);
    }

    fn word(&mut self, key: &str, word: &str, default: bool) {
        if !(self.terse && default) {
            self.line(&format!("{key} = {word:?}"));
        }
    }

    fn table(&mut self, name: &str, keys: &[&str], values: &[f64]) {
        if self.terse && values.iter().all(|&value| value == 0.0) {
            return;
        }
        self.line(&format!("[{name}]"));
        for (key, &value) in keys.iter().zip(values) {
            self.number(key, value, Some(0.0));
        }
    }

    fn stabilizer(&mut self, stabilizer: &Stabilizer, default_cap: f64) {
        let candidate = match stabilizer.kind {
            Kind::Popc => None,
            Kind::MassSpringDamper => Some("mass-spring-damper"),
            Kind::DeviceDamping => Some("device-damping"),
            Kind::Spring => Some("spring"),
        };
        self.line(match candidate {
            None => "[stabilizer.popc]",
            Some(_) => "[stabilizer.lolc]",
        });
        match stabilizer.work {
            Work::Held => self.word("work", "held", true),
            Work::Sampled => self.word("work", "sampled", false),
        }
        if let Some(candidate) = candidate {
            self.word("candidate", candidate, stabilizer.kind == Kind::MassSpringDamper);
        }
        self.number("damping_cap", stabilizer.cap, Some(default_cap));
    }
}
