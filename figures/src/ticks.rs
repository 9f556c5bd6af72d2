//! Round numbers along an axis, and their labels.

use super::span::Span;

/// Round number on an axis.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub(super) value: f64,
    pub(super) label: String,
}

/// Round numbers within a range, with the factor and offset that their labels leave out.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Ticks {
    pub(super) marks: Vec<Tick>,
    /// Factor and offset common to all labels, such as "×10⁻⁶"; empty if labels are complete.
    pub(super) note: String,
}

/// Step of 1, 2 or 5 times a power of ten.
#[derive(Debug, Clone, Copy)]
struct Step {
    mantissa: i64,
    exponent: i32,
}

impl Step {
    /// The smallest step that is no smaller than `least`.
    fn at_least(least: f64) -> Self {
        let exponent = decimal_exponent(least);
        let mantissa = [1, 2, 5]
            .into_iter()
            .find(|mantissa| scaled(*mantissa, exponent) >= least * (1.0 - 1e-9));
        match mantissa {
            Some(mantissa) => Self { mantissa, exponent },
            None => Self { mantissa: 1, exponent: exponent + 1 },
        }
    }

    /// The multiples within the span, in units of the power of ten.
    fn multiples(self, span: Span) -> Vec<i64> {
        let step = scaled(self.mantissa, self.exponent);
        let first = (span.low / step - 1e-9).ceil() as i64;
        let last = (span.high / step + 1e-9).floor() as i64;
        (first..=last).map(|count| count.saturating_mul(self.mantissa)).collect()
    }
}

impl Ticks {
    /// Names in rows, from the top.
    pub(super) fn named(rows: &[String]) -> Self {
        let mark =
            |(row, name): (usize, &String)| Tick { value: -(row as f64), label: name.clone() };
        Self { marks: rows.iter().enumerate().map(mark).collect(), note: String::new() }
    }

    /// About `count` round numbers within the span, two at least.
    pub(super) fn within(span: Span, count: usize) -> Self {
        const ENOUGH: usize = 10;
        let mut wanted = count.clamp(2, 50);
        loop {
            let step = Step::at_least(span.half_width() * (2.0 / wanted as f64));
            let multiples = step.multiples(span);
            if multiples.len() >= 2 || wanted >= ENOUGH {
                return Self::written(span, &multiples, step.exponent);
            }
            wanted += 1;
        }
    }

    /// At most `count` powers of ten, where the span is that of their exponents; between few of them also their double
    /// and fivefold.
    pub(super) fn powers(span: Span, count: usize) -> Self {
        const FEW: f64 = 1.5;
        let (first, last) = (span.low.floor() as i32, span.high.ceil() as i32);
        let between: &[i64] = if span.half_width() < FEW { &[1, 2, 5] } else { &[1] };
        let stride = last.saturating_sub(first).max(0) as usize / count.max(1) + 1;
        // A given range may span all 2^32 exponents, too many to look at each.
        let before = (-i64::from(first)).rem_euclid(stride as i64) as usize;
        let exponents = (first..=last).skip(before).step_by(stride);
        let all = exponents
            .flat_map(|exponent| between.iter().map(move |&multiple| (multiple, exponent)));
        // All numbers of an axis are written in one form.
        let plain = -2.0 <= span.low && span.high <= 5.0;
        let marks = all
            .map(|(multiple, exponent)| Tick {
                value: f64::from(exponent) + libm::log10(multiple as f64),
                label: match multiple {
                    1 if !plain => format!("10{}", superscript(exponent)),
                    _ => complete(multiple, exponent),
                },
            })
            .filter(|tick| span.low - 1e-9 <= tick.value && tick.value <= span.high + 1e-9)
            .collect();
        Self { marks, note: String::new() }
    }

    fn written(span: Span, multiples: &[i64], exponent: i32) -> Self {
        let base = common_base(multiples);
        let largest = multiples.iter().map(|multiple| (multiple - base).abs()).max();
        let factor = common_factor(largest.unwrap_or(0), exponent);
        let marks = multiples
            .iter()
            .map(|&multiple| Tick {
                value: scaled(multiple, exponent).clamp(span.low, span.high),
                label: decimal(multiple - base, exponent - factor),
            })
            .collect();
        let mut note = String::new();
        if factor != 0 {
            note.push_str(&format!("×10{}", superscript(factor)));
        }
        if base != 0 {
            let sign = if base < 0 { '−' } else { '+' };
            note.push_str(&format!(" {sign} {}", complete(base.abs(), exponent)));
        }
        Self { marks, note: note.trim_start().to_owned() }
    }
}

/// Exponent of the leading digit. Read from the number's text: logarithms may differ in their
/// last place from machine to machine, and so would the picture.
fn decimal_exponent(value: f64) -> i32 {
    format!("{value:e}")
        .split_once('e')
        .and_then(|(_, exponent)| exponent.parse().ok())
        .unwrap_or(0)
}

/// `multiple` times ten to the `exponent`, rounded once.
fn scaled(multiple: i64, exponent: i32) -> f64 {
    format!("{multiple}e{exponent}").parse().unwrap_or(0.0)
}

/// Offset to take off the labels so that they need only a few digits.
fn common_base(multiples: &[i64]) -> i64 {
    const LONGEST: i64 = 1_000_000;
    let (Some(&first), Some(&last)) = (multiples.first(), multiples.last()) else {
        return 0;
    };
    if first.saturating_abs().max(last.saturating_abs()) < LONGEST
        || first.signum() != last.signum()
    {
        return 0;
    }
    let mut unit = 10;
    while unit <= last - first {
        unit *= 10;
    }
    first.div_euclid(unit) * unit
}

/// Exponent, a multiple of three, of the factor to take out of the labels.
fn common_factor(largest: i64, exponent: i32) -> i32 {
    let leading = decimal_exponent(largest as f64) + exponent;
    let has_plain_labels = (-3..5).contains(&leading) && exponent >= -5;
    if largest == 0 || has_plain_labels { 0 } else { leading.div_euclid(3) * 3 }
}

/// The number written out, with a minus sign rather than a hyphen.
fn decimal(multiple: i64, exponent: i32) -> String {
    let digits = multiple.abs().to_string();
    let sign = if multiple < 0 { "−" } else { "" };
    if exponent >= 0 {
        let zeros = if multiple == 0 { 0 } else { exponent as usize };
        return format!("{sign}{digits}{}", "0".repeat(zeros));
    }
    let places = exponent.unsigned_abs() as usize;
    let padded = format!("{digits:0>width$}", width = places + 1);
    let (whole, fraction) = padded.split_at(padded.len() - places);
    format!("{sign}{whole}.{fraction}")
}

/// The number in the shortest form that needs no common factor.
fn complete(multiple: i64, exponent: i32) -> String {
    let digits = multiple.to_string();
    let leading = digits.len() as i32 - 1 + exponent;
    let significant = digits.trim_end_matches('0');
    let dropped = (digits.len() - significant.len()) as i32;
    if (-4..7).contains(&leading) {
        let kept = if exponent < 0 { dropped.min(-exponent) } else { 0 };
        return decimal(multiple / 10_i64.pow(kept as u32), exponent + kept);
    }
    let (first, rest) = significant.split_at(1);
    let point = if rest.is_empty() { "" } else { "." };
    format!("{first}{point}{rest}×10{}", superscript(leading))
}

fn superscript(exponent: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    let sign = if exponent < 0 { "⁻" } else { "" };
    let digits = exponent.unsigned_abs().to_string();
    let raised = digits.bytes().map(|digit| DIGITS[usize::from(digit - b'0') % 10]);
    sign.chars().chain(raised).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_ten_are_written_as_such() {
        let labels = |low, high, count| {
            let ticks = Ticks::powers(Span { low, high }, count);
            ticks.marks.into_iter().map(|tick| (tick.value, tick.label)).collect::<Vec<_>>()
        };
        let mark = |value: i32, label: &str| (f64::from(value), label.to_owned());
        assert_eq!(
            labels(-15.0, 3.0, 5),
            [mark(-12, "10⁻¹²"), mark(-8, "10⁻⁸"), mark(-4, "10⁻⁴"), mark(0, "10⁰")]
        );
        let wide: Vec<String> = labels(3.2, 4.8, 9).into_iter().map(|(_, label)| label).collect();
        assert_eq!(wide, ["2000", "5000", "10000", "20000", "50000"]);
        let near: Vec<String> = labels(0.2, 1.1, 5).into_iter().map(|(_, label)| label).collect();
        assert_eq!(near, ["2", "5", "10"]);
    }

    fn ticks(low: f64, high: f64) -> Ticks {
        Ticks::within(Span::given(Some((low, high))).unwrap(), 5)
    }

    fn labels(low: f64, high: f64) -> Vec<String> {
        ticks(low, high).marks.into_iter().map(|tick| tick.label).collect()
    }

    #[test]
    fn ordinary_ranges_are_written_plainly() {
        assert_eq!(labels(0.0, 2.0), ["0.0", "0.5", "1.0", "1.5", "2.0"]);
        assert_eq!(labels(-4.3, 2.1), ["−4", "−2", "0", "2"]);
        assert_eq!(labels(0.0, 50_000.0)[1], "10000");
        assert_eq!(ticks(0.0, 50_000.0).note, "");
    }

    #[test]
    fn small_and_large_ranges_share_a_factor() {
        let small = ticks(0.0, 1e-12);
        assert_eq!(small.note, "×10⁻¹²");
        assert_eq!(labels(0.0, 1e-12), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(ticks(0.0, 2.5e-4).note, "×10⁻⁶");
        assert_eq!(labels(0.0, 2.5e-4)[1], "50");
        assert_eq!(ticks(-3e12, 5e12).note, "×10¹²");
    }

    #[test]
    fn a_small_range_far_from_zero_shares_an_offset() {
        let far = ticks(1e12, 1e12 + 8.0);
        assert_eq!(far.note, "+ 1×10¹²");
        assert_eq!(far.marks[1].label, "2");
        let near = ticks(100.000_1, 100.000_2);
        assert_eq!(near.note, "×10⁻⁶ + 100");
        assert_eq!(ticks(-100.000_2, -100.000_1).note, "×10⁻⁶ − 100.001");
    }

    #[test]
    fn ticks_are_round_and_inside_any_range() {
        let bounds =
            [-1e300, -1e12, -7.3, -1e-12, 0.0, 1e-300, 3e-12, 0.017, 1.1, 5.1, 9.12, 1e12, 1.7e308];
        for low in bounds {
            for high in bounds.into_iter().filter(|high| *high > low) {
                let span = Span::given(Some((low, high))).unwrap();
                for count in [0, 2, 4, 7, 1000] {
                    let ticks = Ticks::within(span, count);
                    assert!((2..=51).contains(&ticks.marks.len()), "{low} {high} {count}");
                    assert!(ticks.marks.iter().all(|tick| span.contains(tick.value)));
                    for pair in ticks.marks.windows(2) {
                        assert!(pair[0].value < pair[1].value, "{low} {high}");
                        assert_ne!(pair[0].label, pair[1].label, "{low} {high}");
                    }
                    let longest = ticks.marks.iter().map(|tick| tick.label.chars().count());
                    assert!(longest.max().unwrap() <= 9, "{low} {high}: {ticks:?}");
                }
            }
        }
    }

    #[test]
    fn steps_are_one_two_or_five() {
        for (least, mantissa, exponent) in [
            (1.0, 1, 0),
            (1.1, 2, 0),
            (2.3, 5, 0),
            (5.1, 1, 1),
            (0.3, 5, -1),
            (1e-12, 1, -12),
            (3e250, 5, 250),
        ] {
            let step = Step::at_least(least);
            assert_eq!((step.mantissa, step.exponent), (mantissa, exponent), "{least}");
        }
    }
}
