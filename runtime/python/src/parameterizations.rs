//! One design in the names and axes of others, and as a file.

use carvallo_design::conventions::{Convention, Form, convert, left_out, write};
use carvallo_design::units::Units;
use carvallo_design::{Design, Failure, file};
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::About;
use crate::words::in_python;

/// The forms of files by their names.
const FORMS: [(&str, Form); 7] = [
    ("toml", Form::Toml),
    ("json", Form::Json),
    ("yaml", Form::Yaml),
    ("csv", Form::Csv),
    ("python", Form::Python),
    ("matlab", Form::Matlab),
    ("text", Form::Text),
];

fn form(name: &str) -> Result<Form, Failure> {
    let found = FORMS.iter().find(|(own, _)| own.eq_ignore_ascii_case(name.trim()));
    let names = FORMS.map(|(own, _)| own).join(", ");
    let unknown = || Failure::usage(format!("`form` is `{name}`; expected one of {names}"));
    found.map(|(_, form)| *form).ok_or_else(unknown)
}

/// The contents of a file, and what has no place in it.
fn text(design: &Design, parameterization: &str, form: Form, units: &str) -> Result<(String, Vec<String>), Failure> {
    let units = Units::parse(units)?;
    if !form.has_units() && !units.is_si() {
        return Err(Failure::usage("this form has no place for `units`; toml, json, yaml and csv have"));
    }
    let convention = Convention::called(parameterization)?;
    let plain = |comment: &str| comment.to_owned();
    // A file of the paper's parameters has a place for everything, and for every model.
    if convention.name == "paper" && form == Form::Toml {
        return Ok((file::write_in(design, &|declared| units.of(declared), &plain), Vec::new()));
    }
    let converted = convert(design, convention)?;
    let notes = left_out(design, &converted, form).iter().map(|note| in_python(note)).collect();
    Ok((write(&converted, form, &units, &plain), notes))
}

#[pymethods]
impl Designs {
    /// The names of the parameters in a parameterization, with their values in SI units.
    fn parameterized(&self, py: Python<'_>, about: About, name: &str) -> PyResult<Vec<(&'static str, f64)>> {
        let convention = Convention::called(name).map_err(raise)?;
        let design = self.described(py, about)?.build().map_err(raise)?;
        let converted = convert(&design, convention).map_err(raise)?;
        Ok(converted.parameters.iter().map(|parameter| (parameter.name.name, parameter.given.value)).collect())
    }

    /// The contents of a file in some form, in a parameterization and units, and what has no place in it.
    fn text(
        &self,
        py: Python<'_>,
        about: About,
        parameterization: &str,
        written: &str,
        units: &str,
    ) -> PyResult<(String, Vec<String>)> {
        let design = self.described(py, about)?.build().map_err(raise)?;
        form(written).and_then(|form| text(&design, parameterization, form, units)).map_err(raise)
    }
}
