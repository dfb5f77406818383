//! Units that are written in a declaration to dimensions and sizes.

use super::dimension::Dimension;
use super::known;
use crate::nearest::ask_for;
use crate::report::{Report, error};
use crate::syntax::{Declaration, Direction, Expression, Factor, Kind, Parameter, Unit, constant};

/// A unit that is known.
#[derive(Debug)]
pub struct Quantity {
    pub dimension: Dimension,
    /// The sizes of its factors that are not of the SI, as formulas, each with its exponent.
    sizes: Vec<(Expression, i32)>,
}

impl Quantity {
    /// What a unit means.
    ///
    /// # Errors
    /// The first name that is not known, or exponents beyond all use.
    pub fn new(unit: &Unit) -> syn::Result<Self> {
        let mut quantity = Self { dimension: Dimension::NUMBER, sizes: Vec::new() };
        for (name, exponent) in &unit.factors {
            let Some(known) = known::find(&name.to_string()) else { return Err(unknown(name)) };
            let product = known.dimension.power(*exponent).and_then(|power| quantity.dimension.times(power));
            let Some(dimension) = product else {
                return Err(error(unit.region, "a unit beyond all use: expected smaller exponents"));
            };
            quantity.dimension = dimension;
            if let Some(size) = known.size {
                quantity.sizes.push((constant(size)?, *exponent));
            }
        }
        Ok(quantity)
    }

    /// A number in this unit as a formula in those of the SI.
    pub fn formula(self, number: Expression) -> Expression {
        if self.sizes.is_empty() {
            return number;
        }
        let region = number.region;
        let power = |(size, n): (Expression, i32)| Expression { kind: Kind::Power(Box::new(size), n), region };
        let factors = std::iter::once(number).chain(self.sizes.into_iter().map(power));
        let kind = Kind::Product(factors.map(|value| Factor { inverse: false, value }).collect());
        Expression { kind, region }
    }
}

fn unknown(name: &proc_macro2::Ident) -> syn::Error {
    let hint = known::find_meant(&name.to_string()).map(|meant| ask_for(&meant));
    let hint = hint.unwrap_or_else(|| format!(" ({}, and their products and powers)", known::names()));
    error(name, format!("unknown unit `{name}`: expected a unit of mechanics{hint}"))
}

/// The dimensions that a declaration gives; none where its unit is a mistake.
#[derive(Clone, Debug)]
pub struct Dimensions {
    /// Behind those of the parameters that of the speed, where it has a name.
    pub parameters: Vec<Option<Dimension>>,
    pub coordinates: Vec<Option<Dimension>>,
    /// Whether directions are declared, so that formulas must mirror right.
    pub mirrored: bool,
}

impl Dimensions {
    pub fn new(declaration: &Declaration, report: &mut Report) -> Self {
        let parameters = declaration.parameters.iter();
        let mut parameters: Vec<_> =
            parameters.map(|p| coherent(p.unit.as_ref()?, report).map(|unit| unit.directed(p.direction))).collect();
        parameters.extend(declaration.speed.as_ref().map(|speed| speed_dimension(speed, report)));
        let coordinates = declaration.coordinates.iter().zip(declaration.of_first_order());
        let coordinates = coordinates.map(|(coordinate, is_held)| {
            let unit = coordinate.unit.as_ref()?;
            let dimension = coherent(unit, report)?;
            // What a filter or an actuator holds may be in any unit.
            if !is_held && !dimension.is_number() && !dimension.same_unit(Dimension::new([0, 1, 0])) {
                let message = format!(
                    "a coordinate {}: expected an angle (`rad`) or a length (`m`), or `only position` behind it, if it is one \
                     of first order",
                    dimension.place()
                );
                report.error(unit.region, message);
                return None;
            }
            Some(dimension.directed(coordinate.direction))
        });
        let mirrored = declaration.parameters.iter().any(|p| p.direction.is_some())
            || declaration.coordinates.iter().any(|c| c.direction.is_some());
        Self { parameters, coordinates: coordinates.collect(), mirrored }
    }
}

/// A speed is in m/s and forward, along x.
fn speed_dimension(speed: &Parameter, report: &mut Report) -> Option<Dimension> {
    let forward = Some(Direction::Along([true, false, false]));
    let unit = speed.unit.as_ref()?;
    let dimension = coherent(unit, report)?;
    if !dimension.same_unit(Dimension::new([0, 1, -1])) {
        let message = format!("`{}`, the speed, is {}: expected `m/s`", speed.name, dimension.place());
        report.error(unit.region, message);
        return None;
    }
    if speed.direction.is_some_and(|direction| Some(direction) != forward) {
        report.error(&speed.name, format!("`{}`, the speed, is forward: expected `along x`, or nothing", speed.name));
    }
    Some(dimension.directed(forward))
}

/// The dimension of a unit that formulas calculate in.
fn coherent(unit: &Unit, report: &mut Report) -> Option<Dimension> {
    let quantity = Quantity::new(unit).map_err(|error| report.push(error)).ok()?;
    if quantity.sizes.is_empty() {
        return Some(quantity.dimension);
    }
    let expected = if quantity.dimension.is_number() { "rad".into() } else { quantity.dimension.to_string() };
    let message = format!(
        "`{0}` is not a unit that formulas calculate in: expected `{expected}`; a value may be given in `{0}`",
        unit.text,
    );
    report.error(unit.region, message);
    None
}
