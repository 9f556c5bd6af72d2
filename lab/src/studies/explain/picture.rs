//! Figure of the energies of an explanation, by cause.

use lyapunov_figures::Figure;

use super::Explanation;
use crate::measure::Balance;
use crate::show::csv::{self, Field};
use crate::show::energy_bars;
use crate::text::file_name;

impl Explanation {
    /// Two bars each for the first contact and for the whole run: the energy that came in, and where it went.
    pub fn figure(&self, name: &str) -> Figure {
        let told = |(what, balance): (&str, &Balance)| {
            energy_bars::panel(
                &format!("{what}: came in (upper bar), went (lower bar)"),
                &[(String::new(), Some(balance))],
            )
        };
        let stretches = self.stretches().map(told);
        let figure = Figure::new(file_name(name))
            .with_width(960.0)
            .with_panel_height(2.0 * energy_bars::ROW);
        stretches.fold(figure, Figure::with_panel)
    }

    /// The energy that each part gave, in J, as comma-separated values in numbers that read back exactly.
    pub fn csv(&self) -> String {
        let rows = self.stretches().flat_map(|(what, balance)| {
            let parts = balance.parts().into_iter();
            parts.map(move |(part, given)| {
                [Field::Text(what), Field::Text(part), Field::Number(given + 0.0)]
            })
        });
        csv::text(["stretch", "part", "given_j"], rows)
    }

    fn stretches(&self) -> impl Iterator<Item = (&'static str, &Balance)> {
        let first = self.first_contact.as_ref().map(|first| ("first contact", first));
        first.into_iter().chain([("whole run", &self.whole_run)])
    }
}
