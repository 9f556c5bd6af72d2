//! Map of the verdicts over two numbers of a scene, in bands.

use std::cell::RefCell;

use lyapunov_lab::Verdict;
use lyapunov_lab::family::StabilizerName;
use lyapunov_lab::map::{Axis, BasicName, Grid, Instructions, Kernel, Lanes};

use crate::exchange::answer;
use crate::scene::{headed, parsed};

thread_local! {
    static MAP: RefCell<Option<Map>> = const { RefCell::new(None) };
}

/// A map that is being computed.
struct Map {
    name: BasicName,
    kernel: Kernel,
}

/// Begins a map: the lines of the input are the two axes, the stabilizer, and the scene. The output is empty where only the
/// command maps that scene.
#[unsafe(no_mangle)]
pub extern "C" fn chart() -> u32 {
    answer(|text| {
        let (x, rest) = headed(text);
        let (y, rest) = headed(rest);
        let (name, rest) = headed(rest);
        let axis = |text: &str| text.parse::<Axis>().map_err(|error| error.to_string());
        let name: StabilizerName = name.parse().map_err(|it| format!("{it}"))?;
        let name = name.basic_name().ok_or("the page maps POPC and LOLC only")?;
        let scene = parsed(rest)?;
        let grid = Grid::new(scene, axis(x)?, axis(y)?, [name]).map_err(|it| it.to_string())?;
        let kernel = Kernel::of(&grid, Instructions::Base, Lanes::Many);
        let kernel = kernel.map_err(|error| error.to_string())?;
        Ok(kernel.map_or_else(Vec::new, |kernel| {
            MAP.set(Some(Map { name, kernel }));
            vec![1]
        }))
    })
}

/// Computes `count` cells of the map from cell `first` on: the output has a byte for each, the place of its verdict.
#[unsafe(no_mangle)]
pub extern "C" fn band(first: usize, count: usize) -> u32 {
    answer(|_| {
        MAP.with_borrow(|map| {
            let Map { name, kernel } = map.as_ref().ok_or("no map was begun")?;
            let cells: Vec<u64> = (first..first + count).map(|cell| cell as u64).collect();
            let verdicts = lyapunov_web_speed::verdicts(kernel, *name, &cells);
            let verdicts = verdicts.map_err(|error| error.to_string())?;
            Ok(verdicts.iter().map(|(verdict, _)| place(*verdict)).collect())
        })
    })
}

/// The place of a verdict among all.
pub(crate) fn place(verdict: Verdict) -> u8 {
    Verdict::ALL.iter().position(|it| *it == verdict).unwrap_or_default() as u8
}
