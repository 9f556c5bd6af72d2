//! Scenes as the page sends them.

use std::cell::RefCell;
use std::io::{self, Cursor, Read};
use std::path::Path;
use std::rc::Rc;

use lyapunov_lab::Scene;
use lyapunov_lab::family::StabilizerName;

use crate::exchange::answer;

/// Name of the page's scene in a message.
const NAME: &str = "the scene";

thread_local! {
    /// Files that scenes may name, by their own names.
    static KEPT: RefCell<Vec<(String, Rc<[u8]>)>> = const { RefCell::new(Vec::new()) };
}

/// Keeps the file below the first line of the input, which is its name, for the scenes that name it.
#[unsafe(no_mangle)]
pub extern "C" fn keep() -> u32 {
    answer(|text| {
        let (name, text) = headed(text);
        KEPT.with_borrow_mut(|kept| {
            kept.retain(|(other, _)| other != name);
            kept.push((name.to_owned(), text.as_bytes().into()));
        });
        Ok(Vec::new())
    })
}

/// The kept file that `path` ends in.
fn opened(path: &Path) -> io::Result<Box<dyn Read>> {
    let found = KEPT.with_borrow(|kept| {
        let found = kept.iter().find(|(name, _)| path.file_name().is_some_and(|it| it == &**name));
        found.map(|(_, bytes)| Rc::clone(bytes))
    });
    match found {
        Some(bytes) => Ok(Box::new(Cursor::new(bytes))),
        None => Err(io::Error::other("drop it here first, or together with the scene")),
    }
}

/// The scene in `text`.
pub(crate) fn parsed(text: &str) -> Result<Scene, String> {
    Scene::parse_beside(text, NAME, &opened).map_err(|fault| fault.to_string())
}

/// The first line of an input, and the rest of it.
pub(crate) fn headed(text: &str) -> (&str, &str) {
    text.split_once('\n').unwrap_or((text, ""))
}

/// The scene in the rest of `text` under the stabilizer that its first line names; its own where that line is empty.
pub(crate) fn stabilized(text: &str) -> Result<Scene, String> {
    let (name, text) = headed(text);
    let scene = parsed(text)?;
    if name.is_empty() {
        return Ok(scene);
    }
    let name: StabilizerName = name.parse().map_err(|it| format!("{it}"))?;
    name.written_in(&scene, &[]).map_err(|conflict| conflict.to_string())
}

/// Reads a scene under the stabilizer in the first line of the input: the output is that scene with every default, as JSON, but
/// for a cap that it does not write, which goes on following the delay.
#[unsafe(no_mangle)]
pub extern "C" fn read() -> u32 {
    answer(|text| {
        let scene = stabilized(text)?;
        // By way of the tree that maps are made of, so that a scene is serialized by one code.
        let tree = toml::Value::try_from(scene.as_written()).map_err(|error| error.to_string())?;
        serde_json::to_vec(&tree).map_err(|error| error.to_string())
    })
}

/// Names the stabilizers that fit a scene, one on a line.
#[unsafe(no_mangle)]
pub extern "C" fn names() -> u32 {
    answer(|text| {
        let scene = parsed(text)?;
        let fitting = StabilizerName::all().filter(|name| name.fits(&scene));
        Ok(fitting.map(StabilizerName::name).collect::<Vec<_>>().join("\n").into_bytes())
    })
}
