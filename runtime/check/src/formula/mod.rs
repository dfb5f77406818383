//! Formulas as declarations and `carvallo equations` have them: their tokens, and the tree of which the value is taken.

mod expression;
mod token;

pub use self::expression::{Expression, Function};
pub use self::token::{Token, TokenKind, tokens};

#[cfg(test)]
mod tests {
    use super::Expression;

    /// The value with a = 2 and b = 3 for parameters and c = 5 for a definition.
    fn value(text: &str) -> Option<f64> {
        let name = |name: &str| match name {
            "a" => Some(Expression::Parameter(0)),
            "b" => Some(Expression::Parameter(1)),
            "c" => Some(Expression::Definition(0)),
            _ => None,
        };
        Some(Expression::parse(text, &name)?.value(&[2.0, 3.0], &[5.0]))
    }

    #[test]
    fn formulas_have_the_values_of_their_text() {
        for (text, expected) in [
            ("a + b*c", 17.0),
            ("(a + b)*c", 25.0),
            ("a - b - c", -6.0),
            ("a/b/c", 2.0 / 15.0),
            ("-a^2", -4.0),
            ("a*-b^-1", -2.0 / 3.0),
            ("(a + b)^-1", 0.2),
            (" - b + 0.5", -2.5),
            ("2*a1", f64::NAN),
            ("sqrt(a*8) + sin(0) + cos(0) + tan(0)", 5.0),
            ("2e-1*a", 0.4),
            ("--a", 2.0),
            ("a^0", 1.0),
        ] {
            assert_eq!(value(text).unwrap_or(f64::NAN).to_bits(), expected.to_bits(), "{text}");
        }
        assert_eq!(value("cos(pi)"), Some(-1.0));
    }

    #[test]
    fn what_is_no_formula_has_no_value() {
        for text in ["", "a +", "a b", "(a", "a)", "a^b", "unknown", "exp(a)", "a^0.5", "1.2.3", "a # b", "()", "*a"] {
            assert_eq!(value(text), None, "{text}");
        }
    }
}
