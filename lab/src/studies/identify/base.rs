//! Responses that belong to one segment of a log.

use nalgebra::SMatrix;

use super::motion::{RESPONSES, State};

/// An orthonormal base of a segment's own responses.
#[derive(Debug)]
pub(super) struct Base {
    vectors: Vec<Vec<f64>>,
    /// Triangle of products, column by column.
    triangle: SMatrix<f64, RESPONSES, RESPONSES>,
}

impl Base {
    /// The base of the first `own` responses, weighted.
    pub(super) fn of(lines: &[State], own: usize, weights: &[f64]) -> Self {
        let mut base = Self { vectors: Vec::new(), triangle: SMatrix::zeros() };
        for column in 0..own {
            let mut vector: Vec<f64> = lines
                .iter()
                .zip(weights)
                .map(|(line, weight)| weight * line[(0, column)])
                .collect();
            // Twice: the second pass removes what the first rounds.
            for _ in 0..2 {
                for (row, other) in base.vectors.iter().enumerate() {
                    let part = dot(other, &vector);
                    base.triangle[(row, column)] += part;
                    subtract(&mut vector, other, part);
                }
            }
            let length = dot(&vector, &vector).sqrt();
            base.triangle[(column, column)] = length;
            let scale = if length > 0.0 { length.recip() } else { 0.0 };
            vector.iter_mut().for_each(|it| *it *= scale);
            base.vectors.push(vector);
        }
        base
    }

    /// The segment's own numbers that fit `values` best.
    pub(super) fn numbers(&self, values: &[f64], weights: &[f64]) -> [f64; 3] {
        let values: Vec<f64> = values.iter().zip(weights).map(|(it, weight)| it * weight).collect();
        let mut numbers = [0.0; 3];
        for row in (0..self.vectors.len()).rev() {
            let more =
                (row + 1..self.vectors.len()).map(|it| self.triangle[(row, it)] * numbers[it]);
            let left = dot(&self.vectors[row], &values) - more.sum::<f64>();
            let length = self.triangle[(row, row)];
            numbers[row] = if length > 0.0 { left / length } else { 0.0 };
        }
        numbers
    }

    /// What the segment's own numbers leave of `values`, weighted.
    pub(super) fn rest(&self, values: &[f64], weights: &[f64]) -> Vec<f64> {
        let mut rest: Vec<f64> =
            values.iter().zip(weights).map(|(it, weight)| it * weight).collect();
        for _ in 0..2 {
            for vector in &self.vectors {
                let part = dot(vector, &rest);
                subtract(&mut rest, vector, part);
            }
        }
        rest
    }
}

fn dot(one: &[f64], other: &[f64]) -> f64 {
    one.iter().zip(other).map(|(one, other)| one * other).sum()
}

fn subtract(vector: &mut [f64], other: &[f64], part: f64) {
    vector.iter_mut().zip(other).for_each(|(it, other)| *it -= part * other);
}
