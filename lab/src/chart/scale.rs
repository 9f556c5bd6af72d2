//! What the numbers along the axes say.

/// What the numbers along both axes of a panel say of the data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Scale {
    /// The data.
    #[default]
    Plain,
    /// Ten to the power of the data: what is drawn are decimal logarithms. An inset keeps the plain numbers.
    PowersOfTen,
}
