//! What a convention calls its parameters, and their values.

use std::f64::consts::PI;

use carvallo::{Bound, Domain};

use super::dual::Dual;

/// A parameter of a convention.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Name {
    /// What it is called.
    pub name: &'static str,
    /// What else it is called.
    pub others: &'static [&'static str],
    /// Its unit, as `kg*m^2`.
    pub unit: &'static str,
    /// The unit in which it is usually printed, if that is another one.
    pub printed: Option<&'static str>,
    /// What it is.
    pub docs: &'static str,
    /// The values that it can have.
    pub domain: Domain,
    /// Whether a file must have it.
    pub need: Need,
}

/// Whether a file must have a parameter, and what becomes of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Need {
    /// It must be there.
    Required,
    /// It may be missing.
    Optional,
    /// Files carry it along, and nothing depends on it: why, as the end of a sentence.
    Ignored(&'static str),
    /// It must be zero: why, as the end of a sentence.
    Zero(&'static str),
    /// It must equal another one: which, and why, as the end of a sentence.
    Equal(&'static str, &'static str),
}

/// Of what stands beside the plane of symmetry.
pub const SYMMETRIC: Need = Need::Zero("the bicycle is laterally symmetric");

/// Why the radial moments of inertia of a wheel are one.
pub const AXISYMMETRIC: &str = "wheels are axisymmetric";

impl Name {
    /// One that must be there.
    pub const fn new(name: &'static str, unit: &'static str, docs: &'static str) -> Self {
        Self { name, others: &[], unit, printed: None, docs, domain: Domain::FINITE, need: Need::Required }
    }

    /// The same, which may be missing.
    pub const fn optional(self) -> Self {
        Self { need: Need::Optional, ..self }
    }

    /// The same with other names.
    pub const fn or(self, others: &'static [&'static str]) -> Self {
        Self { others, ..self }
    }

    /// The same, which is not negative.
    pub const fn not_negative(self) -> Self {
        Self { domain: Domain::NONNEGATIVE, ..self }
    }

    /// The same, which is more than zero.
    pub const fn positive(self) -> Self {
        Self { domain: Domain::POSITIVE, ..self }
    }

    /// The same, which is an angle between the ground and an axis that rises.
    pub const fn rising(self) -> Self {
        Self { domain: Domain::between(Bound::Open(0.0), Bound::Open(PI)), ..self }
    }

    /// The same, as it is usually printed.
    pub const fn printed(self, unit: &'static str) -> Self {
        Self { printed: Some(unit), ..self }
    }

    /// What files carry along beside the parameters.
    pub const fn extra(name: &'static str, unit: &'static str, need: Need) -> Self {
        Self { need, ..Self::new(name, unit, "") }
    }

    /// Whether it is a parameter, and not what files carry along.
    pub fn is_parameter(&self) -> bool {
        matches!(self.need, Need::Required | Need::Optional)
    }

    /// Whether it is called so; underscores do not count.
    pub fn is_called(&self, name: &str) -> bool {
        let short = |name: &str| name.chars().filter(|&sign| sign != '_').collect::<String>();
        let name = short(name);
        [self.name].iter().chain(self.others).any(|own| short(own) == name)
    }
}

/// Values by the names of their parameters.
#[derive(Clone, Debug, Default)]
pub struct Values(Vec<(&'static str, Dual)>);

impl Values {
    /// The value of a parameter, if it is given.
    pub fn get(&self, name: &str) -> Option<Dual> {
        self.0.iter().find(|(own, _)| *own == name).map(|(_, value)| *value)
    }

    /// The values of several; zero for one that is not given.
    pub fn all<const N: usize>(&self, names: [&str; N]) -> [Dual; N] {
        names.map(|name| self.get(name).unwrap_or_default())
    }

    /// One more.
    pub fn push(&mut self, name: &'static str, value: Dual) {
        self.0.push((name, value));
    }

    /// Several more.
    pub fn extend<const N: usize>(&mut self, names: [&'static str; N], values: [Dual; N]) {
        self.0.extend(names.into_iter().zip(values));
    }

    /// The same under another name, where it is given.
    pub fn copy(&mut self, name: &'static str, other: &Self, from: &str) {
        self.0.extend(other.get(from).map(|value| (name, value)));
    }

    /// The same under the same names, where they are given.
    pub fn keep(&mut self, other: &Self, names: &[&'static str]) {
        names.iter().for_each(|name| self.copy(name, other, name));
    }

    /// Replaces the value of the one at a position.
    pub fn set(&mut self, position: usize, value: f64) {
        self.0[position].1 = value.into();
    }

    /// In the order in which they were pushed.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, Dual)> {
        self.0.iter().copied()
    }

    /// With the one at a position varied.
    pub fn varied(&self, position: usize) -> Self {
        let vary = |(at, (name, value)): (usize, &(&'static str, Dual))| {
            (*name, Dual { slope: f64::from(u8::from(at == position)), ..*value })
        };
        Self(self.0.iter().enumerate().map(vary).collect())
    }
}
