//! A compiled model as Python sees it: what it tells about itself, and designs by columns.

use carvallo::{CoordinateInfo, MatrixName, ModelInfo, Notation, ParameterInfo, States};
use carvallo_design::{Shipped, feedback, input, nearest};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::columns::{self, Column};
use crate::designs::Designs;
use crate::loaded::{Loaded, raise};

/// A compiled model.
#[pyclass(frozen, module = "carvallo._carvallo")]
#[derive(Clone, Copy, Debug)]
pub struct Kernel {
    pub(crate) model: &'static Shipped,
}

impl Kernel {
    /// Of a model as the command line has it.
    pub const fn new(model: &'static Shipped) -> Self {
        Self { model }
    }

    fn info(&self) -> &'static ModelInfo {
        self.model.info
    }
}

/// A parameter: its name, unit, documentation and the values that it can have, in words.
type Parameter = (&'static str, &'static str, &'static str, String);

/// A coordinate: its name, label, unit, documentation, and whether its position and its rate are states.
type Coordinate = (&'static str, &'static str, &'static str, &'static str, bool, bool);

#[pymethods]
impl Kernel {
    #[getter]
    fn name(&self) -> &'static str {
        self.info().name
    }

    #[getter]
    fn docs(&self) -> &'static str {
        self.info().docs
    }

    #[getter]
    fn source(&self) -> &'static str {
        self.info().source
    }

    #[getter]
    fn parameters(&self) -> Vec<Parameter> {
        let of =
            |ParameterInfo { name, unit, docs, domain, .. }: &ParameterInfo| (*name, *unit, *docs, domain.to_string());
        self.info().parameters.iter().map(of).collect()
    }

    #[getter]
    fn coordinates(&self) -> Vec<Coordinate> {
        let of = |CoordinateInfo { name, label, docs, unit, states }: &CoordinateInfo| {
            (*name, *label, *unit, *docs, *states != States::Rate, *states != States::Position)
        };
        self.info().coordinates.iter().map(of).collect()
    }

    #[getter]
    fn matrices(&self) -> Vec<&'static str> {
        self.info().matrices.iter().map(|matrix| MatrixName::name(*matrix)).collect()
    }

    #[getter]
    fn sets(&self) -> Vec<&'static str> {
        input::names(self.model)
    }

    #[getter]
    fn default_set(&self) -> Option<&'static str> {
        input::default_name(self.model)
    }

    #[getter]
    fn gravity(&self) -> Option<&'static str> {
        self.info().gravity.map(|position| self.info().parameters[position].name)
    }

    #[getter]
    fn depends_on_speed(&self) -> bool {
        self.model.depends_on_speed()
    }

    /// The equations of motion as `text`, `latex` or `typst`.
    fn equations(&self, notation: &str) -> PyResult<String> {
        let notation = match notation {
            "text" => Notation::Text,
            "latex" => Notation::Latex,
            "typst" => Notation::Typst,
            other => {
                let message = format!("`notation` is `{other}`; expected text, latex or typst");
                return Err(PyValueError::new_err(message));
            }
        };
        Ok(self.info().equations(notation))
    }

    /// A design by the name of what ships, or by the path of a file.
    fn load(&self, name: &str) -> PyResult<Loaded> {
        input::load_for(self.model, name).map(Loaded::from).map_err(raise)
    }

    /// A design by names and values, as they would stand in a file; `label` stands for it in messages.
    fn given(&self, label: &str, values: Vec<(String, String)>) -> PyResult<Loaded> {
        input::given(self.model, label, values).map(Loaded::from).map_err(raise)
    }

    /// The position of the parameter that is meant by a name.
    fn position(&self, name: &str) -> PyResult<usize> {
        let info = self.info();
        input::position(name, info).ok_or_else(|| {
            let hint = nearest(name, info.parameters.iter().map(|parameter| parameter.name));
            let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
            PyValueError::new_err(format!("`{name}` is not a parameter of {}{hint}", info.name))
        })
    }

    /// The value of the text of a parameter, in its unit.
    fn evaluate(&self, position: usize, text: &str) -> PyResult<f64> {
        let parameter = &self.info().parameters[position];
        input::evaluated(text, parameter)
            .map_err(|found| PyValueError::new_err(format!("`{}` is {found}", parameter.name)))
    }

    /// The model with laws of feedback, in the place of what it may have had.
    fn with_feedback(&self, laws: Vec<String>) -> PyResult<Self> {
        let laws = feedback::laws(&laws, self.info()).map_err(raise)?;
        Ok(Self::new(self.model.with_feedback(&laws)))
    }

    fn designs(&self, py: Python<'_>, values: Vec<Bound<'_, PyAny>>, shape: Vec<usize>) -> PyResult<Designs> {
        let columns = values.iter().map(Column::of).collect::<PyResult<Vec<_>>>()?;
        let count = columns::count(py, &columns)?;
        Designs::new(self.model, columns, count, shape)
    }

    fn __repr__(&self) -> String {
        format!("Kernel({})", self.info().name)
    }
}
