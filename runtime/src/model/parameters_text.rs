//! Parameters as text.

use core::fmt;

use super::info::{ModelInfo, ParameterInfo};
use crate::number::Scalar;

impl ModelInfo {
    /// Writes `values`, in declared order, one parameter a line with its name and its unit:
    ///
    /// ```text
    /// w    = 1.02 m
    /// lam  = 0.3141592653589793 rad
    /// IBxx = 9.2 kg*m^2
    /// ```
    ///
    /// Each value has as many digits as tell it from all others, or those of the precision, as in `{:.3}`. The alternate
    /// form, `{:#}`, begins with the name of the model and says behind `#` what each parameter is, its symbol first. Both
    /// are parameter files of the command line.
    ///
    /// It is what `Display` of a model is made of.
    ///
    /// # Errors
    /// Those of the formatter.
    pub fn write_parameters<T: Scalar>(&self, values: &[T], f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let length = |parameter: &ParameterInfo| parameter.name.chars().count();
        let width = self.parameters.iter().map(length).max().unwrap_or(0);
        if f.alternate() {
            write!(f, "# {}", self.name)?;
            self.docs.lines().next().map_or(Ok(()), |line| write!(f, ": {line}"))?;
        }
        for (index, (parameter, value)) in self.parameters.iter().zip(values).enumerate() {
            if index > 0 || f.alternate() {
                f.write_str("\n")?;
            }
            write!(f, "{:width$} = ", parameter.name)?;
            // Unlike `Display` of a number, `Debug` has an exponent where there would be many zeros.
            match f.precision() {
                Some(precision) => write!(f, "{value:.precision$?}")?,
                None => write!(f, "{value:?}")?,
            }
            if parameter.unit != "1" {
                write!(f, " {}", parameter.unit)?;
            }
            if f.alternate() {
                write_meaning(parameter, f)?;
            }
        }
        Ok(())
    }
}

/// A comment with the symbol and the first line of the documentation, of what there is.
fn write_meaning(parameter: &ParameterInfo, f: &mut fmt::Formatter<'_>) -> fmt::Result {
    let &ParameterInfo { name, symbol, docs, .. } = parameter;
    match (symbol == name, docs.lines().next()) {
        (true, None) => Ok(()),
        (true, Some(line)) => write!(f, "  # {line}"),
        (false, None) => write!(f, "  # {symbol}"),
        (false, Some(line)) => write!(f, "  # {symbol}: {line}"),
    }
}
