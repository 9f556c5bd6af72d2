//! Errors of making a PNG of a figure.

use std::fmt;

/// Reason why a figure could not be made into a PNG.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum ChartError {
    /// The scale is not a positive finite number.
    Scale {
        /// The scale that was asked for, in pixels of the picture per unit of the drawing.
        scale: f64,
    },
    /// The picture would have more pixels than [`MOST_PIXELS`](super::MOST_PIXELS).
    TooLarge {
        /// Width of the rejected picture, in pixels.
        width: f64,
        /// Height of the rejected picture, in pixels.
        height: f64,
    },
}

impl fmt::Display for ChartError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Scale { scale } => {
                write!(
                    formatter,
                    "scale {scale} is not a positive finite number\n  = give one above 0, such as 2"
                )
            }
            Self::TooLarge { width, height } => {
                write!(
                    formatter,
                    "a picture of {width} by {height} pixels is too large\n  = give a smaller scale"
                )
            }
        }
    }
}

impl std::error::Error for ChartError {}
