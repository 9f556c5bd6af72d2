//! Fuzz of the arithmetic of poses.

/// Poses, twists and wrenches of any numbers.
pub fn poses(_bytes: &[u8]) {}
