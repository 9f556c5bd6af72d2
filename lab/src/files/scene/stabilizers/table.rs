//! Description of a stabilizer's table in one place: keys, types, units, examples, defaults and ranges.

/// A table of a stabilizer, all of whose keys are optional.
///
/// `words` are keys with a default of their own. `numbers` have one that follows from the loop: a function of the table
/// and of the [`Basis`](super::Basis) gives it, and one of that default and of the basis the range to
/// [search](super::kind::Search). `damping_cap;` as the first of them is the one that many tables have.
macro_rules! table {
    (
        $(#[$about:meta])*
        $Table:ident = $name:literal {
            words { $($words:tt)* }
            numbers { damping_cap; $($numbers:tt)* }
        }
    ) => {
        table! {
            $(#[$about])*
            $Table = $name {
                words { $($words)* }
                numbers {
                    /// Limit of the injected damping in units of m / T, 0 or more, inf for no limit; default 0.5,
                    /// where a force acts d ticks late 0.5 tan(pi / (4 (d + 1))). A limit of 0 only observes.
                    damping_cap: Cap, "m / T", "damping_cap = 0.5  # m / T",
                    |_, on| on.limit.cap, |_, on| on.caps();
                    $($numbers)*
                }
            }
        }
    };
    (
        $(#[$about:meta])*
        $Table:ident = $name:literal {
            words { $($(#[$said:meta])* $word:ident: $Word:ty, $spelling:literal;)* }
            numbers { $(
                $(#[$told:meta])*
                $key:ident: $Quantity:ident, $unit:literal, $example:literal,
                $default:expr, $search:expr;
            )* }
        }
    ) => {
        $(#[$about])*
        #[derive(
            Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize,
            schemars::JsonSchema,
        )]
        #[serde(default, deny_unknown_fields)]
        pub struct $Table {
            $($(#[$said])* pub $word: $Word,)*
            $($(#[$told])* pub $key: Option<$crate::files::scene::$Quantity>,)*
        }

        pub(super) const KEYS: $crate::files::scene::stabilizers::kind::Keys = &[
            $crate::files::scene::key(
                concat!("stabilizer.", $name),
                "",
                concat!("[stabilizer.", $name, "]\n", table!(@first $($example),*)),
            ),
            $($crate::files::scene::key(
                concat!("stabilizer.", $name, ".", stringify!($word)), "", $spelling
            ),)*
            $($crate::files::scene::key(
                concat!("stabilizer.", $name, ".", stringify!($key)), $unit, $example
            ),)*
        ];

        pub(super) const NAME: &str = $name;

        impl $Table {
            $(
                fn $key(&self, on: &super::Basis) -> f64 {
                    let default: fn(&Self, &super::Basis) -> f64 = $default;
                    let written = self.$key.map($crate::files::scene::Quantity::number);
                    written.unwrap_or_else(|| default(self, on))
                }
            )*
        }

        impl super::kind::Numbers for $Table {
            fn name(&self) -> &'static str {
                NAME
            }

            fn parameters(&self, on: &super::Basis) -> Vec<super::Parameter> {
                vec![$({
                    use $crate::files::scene::Quantity;
                    type Type = $crate::files::scene::$Quantity;
                    let search: fn(f64, &super::Basis) -> Option<super::Search> = $search;
                    let mut unwritten = *self;
                    unwritten.$key = None;
                    let default = unwritten.$key(on);
                    super::Parameter {
                        key: concat!("stabilizer.", $name, ".", stringify!($key)),
                        unit: $unit,
                        written: self.$key.map(Quantity::number),
                        default: <Type as Quantity>::of(default).ok().map(Quantity::number),
                        is_whole: <Type as Quantity>::IS_WHOLE,
                        search: search(default, on),
                    }
                },)*]
            }

            fn written(&self, key: &str) -> Option<f64> {
                match key {
                    $(stringify!($key) => self.$key.map($crate::files::scene::Quantity::number),)*
                    _ => None,
                }
            }

            fn write(
                &mut self,
                key: &str,
                number: f64,
            ) -> Result<bool, $crate::files::scene::OutOfRange> {
                match key {
                    $(stringify!($key) => {
                        self.$key = Some($crate::files::scene::Quantity::of(number)?);
                        Ok(true)
                    })*
                    _ => Ok(false),
                }
            }
        }
    };
    (@first $first:literal $(, $more:literal)*) => { $first };
}

pub(super) use table;
