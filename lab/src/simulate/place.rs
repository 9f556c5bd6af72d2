//! Place in the space of a scene.

use super::building::Space;
use crate::files::scene::Coordinates;

/// Place on a line or in a space, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Place {
    axes: [f64; 3],
    dimensions: usize,
}

impl Place {
    /// The place `x` on a line.
    pub(crate) fn on_a_line(x: f64) -> Self {
        Self { axes: [x, 0.0, 0.0], dimensions: 1 }
    }

    /// The place with these coordinates, 0 where none is given.
    pub(crate) fn of(coordinates: &Coordinates, dimensions: usize) -> Self {
        Self { axes: [0, 1, 2].map(|axis| coordinates.axis(axis)), dimensions }
    }

    /// The origin.
    pub(crate) fn origin(dimensions: usize) -> Self {
        Self { axes: [0.0; 3], dimensions }
    }

    /// The place at `position`.
    pub(crate) fn at<V: Space>(position: V) -> Self {
        Self { axes: position.axes(), dimensions: V::DIMENSIONS }
    }

    /// The coordinates.
    #[inline]
    pub(crate) fn axes(&self) -> &[f64] {
        &self.axes[..self.dimensions]
    }

    /// The distance from here to the point with the coordinate `of` each axis, m.
    #[inline]
    pub(crate) fn distance(&self, of: impl Fn(usize) -> f64) -> f64 {
        let apart = self.axes().iter().enumerate().map(|(index, own)| of(index) - own);
        apart.fold(0.0, f64::hypot)
    }
}
