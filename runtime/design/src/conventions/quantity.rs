//! Something that is known of a design by a name: a parameter of its model, or one of a convention that follows from these.

use carvallo::{ModelInfo, ParameterInfo};

use super::Convention;
use super::dual::Dual;
use super::name::{Name, Values};
use super::read::has_paper;
use super::recognise::only;
use super::source::parameter;
use crate::failure::Place;
use crate::input::{Entry, position};

/// What a name means that is known of a design.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quantity {
    /// What it is.
    pub info: ParameterInfo,
    of: Of,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Of {
    Model(usize),
    Convention(&'static Convention, &'static Name),
}

impl Quantity {
    /// What a name means: a parameter of the model; or one of a convention, which may be that of others beside it, or else the
    /// only one that has it. `None` if it means nothing, or several things.
    pub fn called(name: &str, info: &ModelInfo, beside: Option<&'static Convention>) -> Option<Self> {
        if let Some(at) = position(name, info) {
            return Some(Self { info: info.parameters[at], of: Of::Model(at) });
        }
        if !has_paper(info) {
            return None;
        }
        let alone = || only(&[Entry::from_text(name, Place::Nowhere, "0")]);
        let convention = beside.filter(|convention| convention.parameter(name).is_some()).or_else(alone)?;
        let known = convention.parameter(name)?;
        Some(Self { info: parameter(known), of: Of::Convention(convention, known) })
    }

    /// Where it is among the parameters of the model, if it is one of them.
    pub fn position(&self) -> Option<usize> {
        match self.of {
            Of::Model(at) => Some(at),
            Of::Convention(..) => None,
        }
    }

    /// Its value, from those of the parameters of the model; `None` if they do not tell it.
    pub fn value(&self, model: &ModelInfo, of: &dyn Fn(usize) -> Dual) -> Option<Dual> {
        let (convention, name) = match self.of {
            Of::Model(at) => return Some(of(at)),
            Of::Convention(convention, name) => (convention, name.name),
        };
        let mut paper = Values::default();
        model.parameters.iter().enumerate().for_each(|(at, parameter)| paper.push(parameter.name, of(at)));
        convention.tell(name, &paper, &Values::default())
    }

    /// Its derivatives by the parameters of the model.
    pub fn gradient(&self, model: &ModelInfo, values: &[f64]) -> Option<Vec<f64>> {
        let by = |varied: usize| {
            let of = |at: usize| Dual { value: values[at], slope: if at == varied { 1.0 } else { 0.0 } };
            Some(self.value(model, &of)?.slope)
        };
        (0..values.len()).map(by).collect()
    }
}
