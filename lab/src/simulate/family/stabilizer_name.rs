//! Names of the stabilizers of the family.

use std::fmt;
use std::str::FromStr;

use lyapunov::ParameterError;

use super::{BasicName, OwnName};
use crate::files::scene::{Basis, Conflict, Draft, Member, Parameter, Scene, Stabilizer};
use crate::simulate::building::{Fitted, Space};
use crate::text::{nearest, shorten};

/// Name of a stabilizer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StabilizerName {
    /// One that maps run on lanes, or none.
    Basic(BasicName),
    /// One with a table of its own in scene files.
    Member(Member),
    /// One of the program's own.
    Own(OwnName),
}

impl StabilizerName {
    /// All names that ship.
    pub const ALL: [Self; COUNT] = all();

    /// All names: those that ship, then the program's own.
    pub fn all() -> impl Iterator<Item = Self> {
        Self::ALL.into_iter().chain(OwnName::all().map(Self::Own))
    }

    /// The name on the command line and in every table and file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Basic(basic_name) => basic_name.name(),
            Self::Member(member) => member.name(),
            Self::Own(own) => own.name(),
        }
    }

    /// The basic name, if it is one.
    pub fn basic_name(self) -> Option<BasicName> {
        match self {
            Self::Basic(basic_name) => Some(basic_name),
            Self::Member(_) | Self::Own(_) => None,
        }
    }

    /// The table under this name in `scene`: its own where it names this stabilizer, else one with the cap of whichever
    /// it names. None without a stabilizer.
    pub fn table(self, scene: &Draft) -> Option<Stabilizer> {
        let bare = match self {
            Self::Basic(basic_name) => return basic_name.table(scene),
            Self::Member(_) | Self::Own(_) => self.bare_table(),
        };
        let named = scene.stabilizer.filter(|named| named.name() == self.name());
        named.or_else(|| {
            let mut table = bare?;
            if let Some(cap) = scene.written_cap() {
                // Every cap is right, and a table without the key stays as it is.
                let _ = table.write("damping_cap", cap);
            }
            Some(table)
        })
    }

    /// Its table without a written key; none of a basic name, whose table the scene sets.
    pub(crate) fn bare_table(self) -> Option<Stabilizer> {
        match self {
            Self::Basic(_) => None,
            Self::Member(member) => Some(member.table()),
            Self::Own(own) => Some(own.table()),
        }
    }

    /// Whether `scene` has the axes and the numbers that this stabilizer is set by; some are for one axis only, and some
    /// rely on a damping of the device.
    pub fn fits(self, scene: &Scene) -> bool {
        self.table(scene).is_none_or(|table| {
            scene.check_axes_of(&table).is_ok() && table.kind().lacks(&Basis::of(scene)).is_none()
        })
    }

    /// Checks that it works in as many dimensions as `scene` has.
    ///
    /// # Errors
    /// A stabilizer for one dimension in a space.
    pub fn check_axes(self, scene: &Scene) -> Result<(), Conflict> {
        self.table(scene).map_or(Ok(()), |table| scene.check_axes_of(&table))
    }

    /// The stabilizer on the loop of `scene`, whatever `scene` names.
    ///
    /// # Errors
    /// A parameter that is right by itself but out of the range of the scalar, alone or with others; a scene without
    /// what the stabilizer [needs](Self::fits).
    pub fn on<V: Space>(self, scene: &Scene) -> Result<Fitted<V>, ParameterError> {
        Fitted::named(scene, self.table(scene))
    }

    /// The numbers of its table on `scene`: what it writes, what else they are, and where to look for better ones.
    pub fn parameters(self, scene: &Scene) -> Vec<Parameter> {
        let basis = Basis::of(scene);
        self.table(scene).map_or_else(Vec::new, |table| table.kind().parameters(&basis))
    }

    /// `scene` with this stabilizer on a motion that starts elsewhere, at `start` m and m/s: of the numbers that are left out
    /// those are written that follow from what is stored there.
    ///
    /// # Errors
    /// A number that its key does not allow.
    pub(crate) fn started_in(self, scene: &Scene, start: [f64; 2]) -> Result<Scene, Conflict> {
        let here = Basis::of(scene);
        let there = Basis { start, ..here.clone() };
        let parameters =
            |on| self.table(scene).map_or_else(Vec::new, |it| it.kind().parameters(on));
        let pairs = parameters(&here).into_iter().zip(parameters(&there));
        let moved = pairs.filter(|(here, there)| here.value() != there.value());
        let numbers: Vec<_> = moved.filter_map(|(_, it)| Some((it.name(), it.default?))).collect();
        self.written_in(scene, &numbers)
    }

    /// `scene` with this stabilizer, and `numbers` written in its table under keys without their table path.
    ///
    /// # Errors
    /// A number that its key does not allow, alone or with the others; a key that the table does not have.
    pub fn written_in(self, scene: &Scene, numbers: &[(&str, f64)]) -> Result<Scene, Conflict> {
        let mut stabilizer = self.table(scene);
        for (key, number) in numbers {
            let path = format!("stabilizer.{self}.{key}");
            let told = stabilizer.as_mut().map_or(Ok(false), |table| table.write(key, *number));
            match told {
                Ok(true) => {}
                Ok(false) => {
                    let problem = format!("there is no key `{path}`");
                    return Err(Conflict::new(path, problem, "docs/family.md lists the keys"));
                }
                Err(rule) => {
                    let problem = format!("`{path}` {rule}");
                    return Err(Conflict::new(path, problem, "give a value that the key allows"));
                }
            }
        }
        Draft { stabilizer, ..scene.to_draft() }.check()
    }
}

/// The number of names.
const COUNT: usize = BasicName::ALL.len() + Member::ALL.len();

const fn all() -> [StabilizerName; COUNT] {
    let mut all = [StabilizerName::Basic(BasicName::NoStabilizer); COUNT];
    let (mut next, mut member) = (0, 0);
    while next < BasicName::ALL.len() {
        all[next] = StabilizerName::Basic(BasicName::ALL[next]);
        next += 1;
    }
    while member < Member::ALL.len() {
        all[next] = StabilizerName::Member(Member::ALL[member]);
        (next, member) = (next + 1, member + 1);
    }
    all
}

impl From<BasicName> for StabilizerName {
    fn from(basic_name: BasicName) -> Self {
        Self::Basic(basic_name)
    }
}

impl fmt::Display for StabilizerName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Name that no stabilizer has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownStabilizer {
    given: String,
}

impl fmt::Display for UnknownStabilizer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names: Vec<&str> = StabilizerName::all().map(StabilizerName::name).collect();
        write!(f, "no stabilizer is called `{}`\n  = ", shorten(&self.given))?;
        if let Some(name) = nearest(&self.given, &names) {
            write!(f, "did you mean `{name}`?\n  = ")?;
        }
        f.write_str("the names are:")?;
        names.chunks(5).try_for_each(|names| write!(f, "\n    {}", names.join(", ")))
    }
}

impl std::error::Error for UnknownStabilizer {}

impl FromStr for StabilizerName {
    type Err = UnknownStabilizer;

    fn from_str(given: &str) -> Result<Self, UnknownStabilizer> {
        let found = Self::all().find(|one| one.name() == given);
        found.ok_or_else(|| UnknownStabilizer { given: given.to_owned() })
    }
}
