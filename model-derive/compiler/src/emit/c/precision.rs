//! The two kinds of numbers that everything is written in.

use crate::domain::{Bound, Domain};

/// A kind of numbers of C.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Precision {
    Double,
    Single,
}

impl Precision {
    pub const ALL: [Self; 2] = [Self::Double, Self::Single];

    /// What functions and types have in their names, as in Rust.
    pub fn name(self) -> &'static str {
        match self {
            Self::Double => "f64",
            Self::Single => "f32",
        }
    }

    /// The type of C.
    pub fn number(self) -> &'static str {
        match self {
            Self::Double => "double",
            Self::Single => "float",
        }
    }

    /// The largest number, by its name in `float.h`.
    fn largest(self) -> &'static str {
        match self {
            Self::Double => "DBL_MAX",
            Self::Single => "FLT_MAX",
        }
    }

    /// A function of `math.h`.
    pub fn function(self, name: &str) -> String {
        match self {
            Self::Double => name.to_string(),
            Self::Single => format!("{name}f"),
        }
    }

    /// A number rounded to the nearest of this kind, in parentheses if it has a sign.
    pub fn literal(self, value: f64) -> String {
        let digits = match self {
            Self::Double => format!("{:?}", value.abs()),
            Self::Single if (value as f32).is_infinite() => "HUGE_VALF".to_string(),
            Self::Single => format!("{:?}F", value.abs() as f32),
        };
        if value.is_sign_negative() && value != 0.0 { format!("(-{digits})") } else { digits }
    }

    /// Whether `literal` needs `math.h`.
    pub fn is_too_large(self, value: f64) -> bool {
        self == Self::Single && (value as f32).is_infinite()
    }

    /// The condition that a value of this kind is finite and in a domain, whose bounds are doubles: for single precision
    /// they are replaced by the numbers of that kind that decide the same.
    pub fn condition(self, domain: Domain, value: &str) -> String {
        let largest = self.largest();
        let mut terms = Vec::new();
        terms.push(match domain.lower {
            Bound::Unbounded => format!("({value} >= -{largest})"),
            Bound::Open(bound) => format!("({value} > {})", self.literal(self.round(bound, f32::next_down))),
            Bound::Closed(bound) => format!("({value} >= {})", self.literal(self.round(bound, f32::next_up))),
        });
        terms.push(match domain.upper {
            Bound::Unbounded => format!("({value} <= {largest})"),
            Bound::Open(bound) => format!("({value} < {})", self.literal(self.round(bound, f32::next_up))),
            Bound::Closed(bound) => format!("({value} <= {})", self.literal(self.round(bound, f32::next_down))),
        });
        if domain.nonzero {
            let zero = self.literal(0.0);
            terms.push(format!("(({value} < {zero}) || ({value} > {zero}))"));
        }
        terms.join(" && ")
    }

    /// A bound as a number of this kind, on the side that `step` leads to.
    fn round(self, bound: f64, step: fn(f32) -> f32) -> f64 {
        if self == Self::Double {
            return bound;
        }
        let nearest = bound as f32;
        let stepped = step(nearest);
        let is_beyond = |value: f32| (f64::from(value) - bound) * (f64::from(stepped) - f64::from(nearest)) >= 0.0;
        f64::from(if is_beyond(nearest) { nearest } else { stepped })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a condition of single precision says, by hand: only `>=`, `>`, `<=` and `<` of a number.
    fn holds(condition: &str, value: f32) -> bool {
        condition.split(" && ").all(|term| {
            let words: Vec<&str> = term.trim_matches(['(', ')']).split(' ').collect();
            let bound: f32 = match words[2] {
                "FLT_MAX" => f32::MAX,
                "-FLT_MAX" => -f32::MAX,
                number => number.trim_matches(['(', ')', 'F']).parse().expect("a number"),
            };
            match words[1] {
                ">" => value > bound,
                ">=" => value >= bound,
                "<" => value < bound,
                "<=" => value <= bound,
                other => panic!("{other}"),
            }
        })
    }

    /// 0.1 lies between two floats, 0.5 is one.
    #[test]
    fn bounds_decide_in_single_precision_as_in_double() {
        let kinds: [fn(f64) -> Bound; 2] = [Bound::Open, Bound::Closed];
        for bound in [0.1, -0.1, 0.5, 0.0, 1e-50, -1e-50, 1.5e300, 16_777_217.0] {
            for kind in kinds {
                let domains = [
                    Domain { lower: kind(bound), upper: Bound::Unbounded, nonzero: false },
                    Domain { lower: Bound::Unbounded, upper: kind(bound), nonzero: false },
                ];
                let nearest = bound as f32;
                let near = [nearest.next_down(), nearest, nearest.next_up(), 0.0, -0.0, f32::MAX, -f32::MAX];
                for (domain, value) in domains.iter().flat_map(|domain| near.map(|value| (domain, value))) {
                    let condition = Precision::Single.condition(*domain, "x").replace("HUGE_VALF", "inf");
                    assert_eq!(holds(&condition, value), domain.contains(value.into()), "{value:?}: {condition}");
                }
            }
        }
    }

    #[test]
    fn numbers_are_rounded_once() {
        assert_eq!(Precision::Single.literal(0.1), "0.1F");
        assert_eq!(Precision::Single.literal(-16_777_217.0), "(-16777216.0F)");
        assert_eq!(Precision::Double.literal(-1e-300), "(-1e-300)");
        assert_eq!(Precision::Single.literal(1e-300), "0.0F");
        assert_eq!(Precision::Single.literal(1e300), "HUGE_VALF");
    }
}
