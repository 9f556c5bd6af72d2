//! The runs of every member that the claims are about.

use super::ensemble::{Control, Loop, Run, Steps, measured};
use super::measures::Measures;
use super::member::Member;
use crate::studies::paper::PaperError;

/// Walls that each member compares the stabilizers on.
pub const WALLS: usize = 8;

/// The paper's soft wall: 8 kN/m and 2 N·s/m.
pub const SOFT: [f64; 2] = [8e3, 2.0];
/// Its stiff wall: 50 kN/m and 20 N·s/m.
pub const STIFF: [f64; 2] = [50e3, 20.0];

/// Measures of one member's runs.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Runs {
    /// The soft wall without control.
    pub soft_none: Measures,
    /// The soft wall with POPC.
    pub soft_popc: Measures,
    /// The soft wall with LOLC.
    pub soft_lolc: Measures,
    /// The stiff wall without control.
    pub stiff_none: Measures,
    /// The stiff wall with POPC.
    pub stiff_popc: Measures,
    /// The stiff wall with LOLC.
    pub stiff_lolc: Measures,
    /// The number of the member's own walls on which the loop settles with POPC; none if it has no walls.
    pub popc_walls: Option<usize>,
    /// The same with LOLC.
    pub lolc_walls: Option<usize>,
}

impl Runs {
    /// The runs of each member, in order; calls `tell` before each of [`Runs::LOOPS`].
    ///
    /// # Errors
    /// A number that a part rejects.
    pub fn of(
        steps: Steps,
        members: &[Member],
        mut tell: impl FnMut(),
    ) -> Result<Vec<Self>, PaperError> {
        let mut all = vec![Self::default(); members.len()];
        type Place = fn(&mut Runs) -> &mut Measures;
        let loops: [(Control, [f64; 2], Place); 6] = [
            (Control::None, SOFT, |runs| &mut runs.soft_none),
            (Control::Popc, SOFT, |runs| &mut runs.soft_popc),
            (Control::Lolc, SOFT, |runs| &mut runs.soft_lolc),
            (Control::None, STIFF, |runs| &mut runs.stiff_none),
            (Control::Popc, STIFF, |runs| &mut runs.stiff_popc),
            (Control::Lolc, STIFF, |runs| &mut runs.stiff_lolc),
        ];
        for (control, wall, place) in loops {
            tell();
            let measures = measured(Loop { control, steps }, &Run::each(members, wall))?;
            all.iter_mut().zip(measures).for_each(|(runs, it)| *place(runs) = it);
        }
        type Count = fn(&mut Runs) -> &mut Option<usize>;
        let counts: [(Control, Count); 2] = [
            (Control::Popc, |runs| &mut runs.popc_walls),
            (Control::Lolc, |runs| &mut runs.lolc_walls),
        ];
        let own = |member| move |wall: &[f64; 2]| Run { member, wall: *wall };
        let walls = members.iter().flat_map(|member| member.walls.iter().map(own(member)));
        let walls: Vec<Run<'_>> = walls.collect();
        for (control, place) in counts {
            tell();
            let measures = measured(Loop { control, steps }, &walls)?;
            for (runs, measures) in all.iter_mut().zip(measures.chunks(WALLS)) {
                let settled = measures.iter().filter(|run| run.settled.is_some());
                *place(runs) = Some(settled.count());
            }
        }
        Ok(all)
    }

    /// The number of loops, for a progress display.
    pub const LOOPS: usize = 8;
}
