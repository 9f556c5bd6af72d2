//! Scenes as the page sends them.

use lyapunov_lab::Scene;
use lyapunov_lab::family::StabilizerName;

use crate::exchange::answer;

/// Name of the page's scene in a message.
const NAME: &str = "the scene";

/// The scene in `text`.
pub(crate) fn parsed(text: &str) -> Result<Scene, String> {
    Scene::parse(text, NAME).map_err(|fault| fault.to_string())
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
    name.written_in(&scene, &[]).map_err(|conflict| conflict.problem().to_owned())
}

/// Reads a scene: the output is that scene with every default, as JSON.
#[unsafe(no_mangle)]
pub extern "C" fn read() -> u32 {
    answer(|text| {
        let scene = parsed(text)?;
        serde_json::to_vec(&scene).map_err(|error| error.to_string())
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
