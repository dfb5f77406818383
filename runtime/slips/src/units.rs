//! Whether formulas make sense by the units in them.

use carvallo::{Expression, FormulaInfo, FormulaSubject, Function, ModelInfo};

/// The powers of kilogram, metre and second; an angle is a pure number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension([i32; 3]);

/// The dimensions of parameters and definitions, where they are known.
#[derive(Clone, Debug)]
pub struct Units {
    parameters: Vec<Option<Dimension>>,
    definitions: Vec<Option<Dimension>>,
}

/// Two quantities that cannot be added, or an argument that is no pure number.
struct Nonsense;

impl Dimension {
    const PURE: Self = Self([0; 3]);

    /// That of a unit as models declare it, such as `N*m/rad`; `None` for what is none of these.
    pub fn parse(unit: &str) -> Option<Self> {
        let mut own = Self::PURE;
        let mut rest = unit.trim();
        let mut sign = 1;
        while !rest.is_empty() {
            let end = rest.find(['*', '/']).unwrap_or(rest.len());
            let (name, power) = rest[..end].split_once('^').unwrap_or((&rest[..end], "1"));
            let powers = match name.trim() {
                "1" | "rad" => [0, 0, 0],
                "kg" => [1, 0, 0],
                "m" => [0, 1, 0],
                "s" => [0, 0, 1],
                "N" => [1, 1, -2],
                _ => return None,
            };
            own = own.times(Self(powers), sign * power.trim().parse::<i32>().ok()?);
            sign = if rest[end..].starts_with('/') { -1 } else { 1 };
            rest = rest[end..].trim_start_matches(['*', '/']);
        }
        Some(own)
    }

    fn times(self, other: Self, power: i32) -> Self {
        Self(std::array::from_fn(|at| self.0[at] + power * other.0[at]))
    }
}

impl Units {
    /// Those that a model tells, the definitions among these formulas behind its own.
    pub fn new(info: &ModelInfo, attributes: &[FormulaInfo]) -> Self {
        let known = |unit: &str| if unit.is_empty() { None } else { Dimension::parse(unit) };
        let definition = |formula: &FormulaInfo| match formula.of {
            FormulaSubject::Definition(_) | FormulaSubject::Attribute { .. } => Some(known(formula.unit)),
            FormulaSubject::Entry(_) => None,
        };
        Self {
            parameters: info.parameters.iter().map(|parameter| known(parameter.unit)).collect(),
            definitions: info.formulas.iter().chain(attributes).filter_map(definition).collect(),
        }
    }

    /// Whether a formula may have this dimension: nothing that is known speaks against it.
    pub fn fit(&self, formula: &Expression, dimension: Dimension) -> bool {
        self.dimension(formula).is_ok_and(|own| own.is_none_or(|own| own == dimension))
    }

    /// `None` where it is not known, and for zero, which has any.
    fn dimension(&self, formula: &Expression) -> Result<Option<Dimension>, Nonsense> {
        match formula {
            Expression::Number(_, value) if *value == 0.0 => Ok(None),
            Expression::Number(..) | Expression::Pi => Ok(Some(Dimension::PURE)),
            Expression::Parameter(at) => Ok(self.parameters[*at]),
            Expression::Definition(at) => Ok(self.definitions[*at]),
            Expression::Sum(terms) => {
                let mut sum = None;
                for (_, term) in terms {
                    match (sum, self.dimension(term)?) {
                        (Some(known), Some(own)) if known != own => return Err(Nonsense),
                        (known, own) => sum = known.or(own),
                    }
                }
                Ok(sum)
            }
            Expression::Product(factors) => {
                let mut product = Some(Dimension::PURE);
                for (divides, factor) in factors {
                    let power = if *divides { -1 } else { 1 };
                    let own = self.dimension(factor)?;
                    product = product.zip(own).map(|(product, own)| product.times(own, power));
                }
                Ok(product)
            }
            Expression::Power(base, exponent) => {
                Ok(self.dimension(base)?.map(|base| Dimension::PURE.times(base, *exponent)))
            }
            Expression::Call(function, argument) => match (function, self.dimension(argument)?) {
                (Function::Sqrt, None) => Ok(None),
                (Function::Sqrt, Some(Dimension(powers))) if powers.iter().all(|power| power % 2 == 0) => {
                    Ok(Some(Dimension(powers.map(|power| power / 2))))
                }
                (Function::Sqrt, Some(_)) => Err(Nonsense),
                (_, None | Some(Dimension::PURE)) => Ok(Some(Dimension::PURE)),
                (_, Some(_)) => Err(Nonsense),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Dimension;
    use crate::Formulas;
    use carvallo_models::Whipple;

    #[test]
    fn units_are_read_as_models_declare_them() {
        for (unit, powers) in [
            ("kg*m^2", [1, 2, 0]),
            ("N*m*s/rad", [1, 2, -1]),
            ("N/kg", [0, 1, -2]),
            ("1", [0, 0, 0]),
            ("N*s^2", [1, 1, 0]),
            ("1/s", [0, 0, -1]),
        ] {
            assert_eq!(Dimension::parse(unit), Some(Dimension(powers)), "{unit}");
        }
        assert_eq!(Dimension::parse("furlong"), None);
    }

    /// Of the bicycle: a radius for a height does, a mass for it and the cosine of a moment of inertia do not.
    #[test]
    fn slips_without_sense_are_told() {
        let formulas = Formulas::new(Whipple::<f64>::INFO).expect("formulas that can be read");
        let at = |name: &str| {
            let is = |own: &crate::Formula| own.subject.to_string() == name;
            formulas.formulas.iter().position(is).expect("a formula of that name")
        };
        for (name, text, expected) in [
            ("zA", "(zH*mH - rR*mF)/mA", true),
            ("zA", "(mH*mH - rR*mF)/mA", false),
            ("zA", "zH*mH - rR*mF", false),
            ("zA", "(zH*mH - cos(IAlz)*mF)/mA", false),
            ("zA", "(zH*mH - cos(lam)*rF*mF)/mA", true),
            ("zA", "0", true),
            ("mu", "c/w*sin(lam)", true),
            ("mu", "c/w*cos(IAlz)", false),
        ] {
            let text = formulas.parse(at(name), text).expect("a formula");
            assert_eq!(formulas.makes_sense(at(name), &text), expected, "{name} {text:?}");
        }
        // And all that stand there do.
        for (at, formula) in formulas.formulas.iter().enumerate() {
            assert!(
                formulas.makes_sense(at, &formulas.parse(at, formula.text).expect("a formula")),
                "{}",
                formula.subject
            );
        }
    }
}
