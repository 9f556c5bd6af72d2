//! Reasons for a verdict, and limits by formula.

use lyapunov_lab::bound::Limits;
use lyapunov_lab::explain::{Explanation, Hint};
use lyapunov_lab::scene::Scene;
use lyapunov_lab::{Rollout, Space, Summary, in_space};

use crate::exchange::{answer, bytes};
use crate::scene::{parsed, stabilized};

/// Explains a scene under the stabilizer in the first line of the input: the output is the hint of `run` on a line, the
/// table of energies on the next, a tab before each row and bars between its cells, then the JSON of `explain`.
#[unsafe(no_mangle)]
pub extern "C" fn explain() -> u32 {
    answer(|text| {
        let scene = stabilized(text)?;
        in_space!(scene, V => explained::<V>(&scene))
    })
}

fn explained<V: Space>(scene: &Scene) -> Result<Vec<u8>, String> {
    let rollout = Rollout::<V>::of(scene).map_err(|error| error.to_string())?;
    let summary = Summary::of(scene, rollout);
    let sentence = Hint::of(&summary).sentence().unwrap_or_default();
    let explanation = Explanation::of::<V>(scene).map_err(|error| error.to_string())?;
    let mut energies = String::new();
    if let Some(first) = explanation.first_contact {
        for (name, [first, whole]) in explanation.energies(&first) {
            energies += &format!("\t{name}|{first:?}|{whole:?}");
        }
    }
    let json = explanation.to_json("page");
    Ok(format!("{sentence}\n{energies}\n{json}").into_bytes())
}

/// Limits of a scene: the exact one of its stiffness, N/m, the cap that it writes, m / T, each NaN where there is none, and the mass in
/// kg in which that cap counts.
#[unsafe(no_mangle)]
pub extern "C" fn limits() -> u32 {
    answer(|text| {
        let scene = parsed(text)?;
        let numbers = [Limits::of(&scene).exact, scene.written_cap(), Some(scene.port_mass())];
        Ok(bytes(numbers.map(|it| it.unwrap_or(f64::NAN))))
    })
}
