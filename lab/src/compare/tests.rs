//! Comparisons of whole scenes.
