//! The designs that one parameter passes through.

#[cfg(feature = "full")]
use carvallo::ModelInfo;
use carvallo::ParameterInfo;

#[cfg(feature = "full")]
use crate::conventions::{Naming, Varied};
use crate::design::Design;
#[cfg(feature = "full")]
use crate::input::warning_of_varied;
#[cfg(not(feature = "full"))]
use crate::parameter::find;

/// A design, and the parameter of it that changes: one of its model, or one of any convention of bicycles.
#[derive(Clone, Debug)]
pub struct Path {
    /// The parameter.
    pub parameter: ParameterInfo,
    values: Vec<f64>,
    #[cfg(feature = "full")]
    info: &'static ModelInfo,
    #[cfg(feature = "full")]
    varied: Varied,
    #[cfg(not(feature = "full"))]
    position: usize,
}

#[cfg(feature = "full")]
impl Path {
    /// # Errors
    /// If there is no such parameter, its value was set, or the design cannot be expressed in its convention.
    pub fn new(design: &Design, name: &str) -> Result<Self, String> {
        let naming = Naming::new(design.info(), [name]);
        let varying = naming.find(name)?;
        let is_same = |set: &&String| naming.find(set).is_ok_and(|own| own.is(&varying));
        if let Some(set) = design.set.iter().find(is_same) {
            let spelled = if set == name { String::new() } else { format!(" as `{name}`") };
            return Err(format!("`{set}` is set, but varies{spelled}; leave one of them out"));
        }
        let varied = Varied::new(design, &naming, &[Some(&varying)])?;
        Ok(Self { parameter: varying.info, values: design.values(), info: design.info(), varied })
    }

    /// The parameters of the model at a value of the parameter, in declared order.
    ///
    /// # Errors
    /// If the parameter cannot have this value, or there is no such design.
    pub fn at(&self, value: f64) -> Result<Vec<f64>, String> {
        let mut values = self.values.clone();
        self.varied.put(|_| Some(value), &mut values)?;
        Ok(values)
    }

    /// A warning if a value of the parameter seems to be in another unit.
    pub fn warning(&self, value: f64) -> Option<String> {
        warning_of_varied(&self.parameter, value, self.info, &self.at(value).ok()?)
    }

    /// What of the design is kept along it, where that is not plain.
    pub fn note(&self) -> Option<String> {
        self.varied.note()
    }
}

#[cfg(not(feature = "full"))]
impl Path {
    /// # Errors
    /// If there is no such parameter.
    pub fn new(design: &Design, name: &str) -> Result<Self, String> {
        let position = find(name, design.info())?;
        Ok(Self { parameter: design.info().parameters[position], values: design.values(), position })
    }

    /// The parameters of the model at a value of the parameter, in declared order.
    ///
    /// # Errors
    /// None.
    pub fn at(&self, value: f64) -> Result<Vec<f64>, String> {
        let mut values = self.values.clone();
        values[self.position] = value;
        Ok(values)
    }
}
