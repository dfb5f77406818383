//! A machine: a model that ships, or given matrices, and values of its parameters.

use std::ffi::CString;
use std::sync::{LazyLock, Mutex, PoisonError};

use carvallo::batch::Batch;
use carvallo::{Complex, CriticalDerivative, MatrixName, ModelInfo, States, SystemError};
use carvallo_design::input::{self, Request};
use carvallo_design::number::with_unit;
use carvallo_design::{Equations, MODELS, Shape, Shipped, matrices, parameter};

use crate::failure::{Failure, c_text};
use crate::types::CarvalloStatus::{Invalid, NoAnswer, UnknownName, WrongSize};
use crate::types::Stability;

/// A machine: a model that ships with values of its parameters, or matrices that are given. The parameters of the latter are
/// the entries, such as `M_12`, and `g`.
#[derive(Clone, Debug)]
pub struct Machine {
    pub(crate) model: &'static Shipped,
    pub(crate) values: Vec<f64>,
    names: Vec<CString>,
    units: Vec<CString>,
    coordinates: Vec<CString>,
}

/// The names of all models, as C has them.
pub static NAMES: LazyLock<Vec<CString>> =
    LazyLock::new(|| MODELS.iter().map(|model| c_text(model.info.name)).collect());

/// The names of what ships for each model, as C has them.
static SETS: LazyLock<Vec<Vec<CString>>> = LazyLock::new(|| {
    let of_model = |model: &Shipped| input::names(model).into_iter().map(c_text).collect();
    MODELS.iter().map(of_model).collect()
});

/// The names of what ships for a model.
pub fn sets(model: &str) -> Result<&'static [CString], Failure> {
    let model = Shipped::called(model).map_err(|message| Failure::new(UnknownName, message))?;
    let position = MODELS.iter().position(|other| other.is_called(model.info.name));
    Ok(position.map_or(&[], |position| &SETS[position]))
}

impl Machine {
    /// A model with what ships for it, or with what a file has.
    pub fn load(model: Option<&str>, parameters: Option<&str>) -> Result<Self, Failure> {
        if let Some(model) = model.filter(|name| !matrices::is_called(name)) {
            Shipped::called(model).map_err(|message| Failure::new(UnknownName, message))?;
        }
        if parameters == Some("-") {
            return Err(Failure::new(UnknownName, "`parameters` is `-`; a library does not read the standard input"));
        }
        let [model, parameters] = [model, parameters].map(|name| name.map(str::to_owned));
        let is_file = parameters.as_ref().is_some_and(|path| std::path::Path::new(path).exists());
        let request = Request { model, parameters, ..Request::default() };
        let design = input::load(&request).map_err(|failure| {
            // What is in a file is wrong, or else there is none of that name.
            Failure::new(if is_file { Invalid } else { UnknownName }, failure)
        })?;
        Ok(Self::new(design.model, design.values()))
    }

    /// Given matrices, row by row.
    pub fn of_matrices(given: &[(MatrixName, &[f64])], states: Vec<States>, gravity: f64) -> Result<Self, Failure> {
        let model = model_of_matrices(given.iter().map(|(name, _)| *name).collect(), states);
        let entries = given.iter().flat_map(|(_, entries)| entries.iter().copied());
        let machine = Self::new(model, entries.chain([gravity]).collect());
        machine.with_equations(|_| Ok(()))?;
        Ok(machine)
    }

    fn new(model: &'static Shipped, values: Vec<f64>) -> Self {
        let parameters = model.info.parameters.iter();
        let (names, units) = parameters.map(|parameter| (c_text(parameter.name), c_text(parameter.unit))).unzip();
        let coordinates = model.info.coordinates.iter().map(|coordinate| c_text(coordinate.name)).collect();
        Self { model, values, names, units, coordinates }
    }

    /// The place of a parameter.
    pub fn position(&self, name: &str) -> Result<usize, Failure> {
        parameter::find(name, self.model.info).map_err(|message| Failure::new(UnknownName, message))
    }

    /// The name and the unit of a parameter.
    pub fn parameter(&self, position: usize) -> Result<[&CString; 2], Failure> {
        let found = self.names.get(position).zip(self.units.get(position));
        found.map(|(name, unit)| [name, unit]).ok_or_else(|| {
            let count = self.names.len();
            Failure::new(WrongSize, format!("the parameter {position} is asked for; there are {count}, from 0"))
        })
    }

    /// The name of a coordinate.
    pub fn coordinate(&self, position: usize) -> Result<&CString, Failure> {
        self.coordinates.get(position).ok_or_else(|| {
            let count = self.coordinates.len();
            Failure::new(WrongSize, format!("the coordinate {position} is asked for; there are {count}, from 0"))
        })
    }

    /// Hands the equations of motion and the gravity of other values of the parameters to a function.
    pub fn with_values<T>(
        &self,
        values: &[f64],
        compute: impl FnOnce(&dyn Equations, f64) -> Result<T, Failure>,
    ) -> Result<T, Failure> {
        if matrices::is_called(self.model.info.name) {
            check_entries(self.model.info, values)?;
        }
        let gravity = self.model.info.gravity.map_or(0.0, |position| values[position]);
        let mut compute = Some(compute);
        let mut found = None;
        let visited = self.model.visit(values, &mut |equations| {
            found = compute.take().map(|compute| compute(equations, gravity));
            Ok(())
        });
        visited.map_err(|message| Failure::new(Invalid, message))?;
        found.unwrap_or_else(|| Err(Failure::new(NoAnswer, "there are no equations of motion")))
    }

    /// Hands its equations of motion to a function.
    pub fn with_equations<T>(&self, compute: impl FnOnce(&dyn Equations) -> Result<T, Failure>) -> Result<T, Failure> {
        self.with_values(&self.values, |equations, _| compute(equations))
    }

    /// One of its matrices, row by row.
    pub fn matrix(&self, name: &str) -> Result<Vec<f64>, Failure> {
        let is_called = |matrix: &MatrixName| matrix.name() == name || format!("{matrix:?}") == name;
        let Some(asked) = MatrixName::ALL.into_iter().find(is_called) else {
            let names = MatrixName::ALL.map(MatrixName::name).join(", ");
            return Err(Failure::new(UnknownName, format!("there is no matrix `{name}`; the matrices are {names}")));
        };
        self.with_equations(|equations| {
            let all = equations.matrices();
            Ok(all.into_iter().filter(|(name, _)| *name == asked).flat_map(|(_, rows)| rows.concat()).collect())
        })
    }

    /// The eigenvalues at a speed.
    pub fn eigenvalues(&self, speed: f64) -> Result<Vec<Complex<f64>>, Failure> {
        self.with_values(&self.values, |equations, gravity| Ok(equations.eigenvalues(speed, gravity)?))
    }

    /// The eigenvalues at speeds, one after the other: of two coordinates in the lanes of the processor.
    pub fn eigenvalues_along(&self, speeds: &[f64]) -> Result<Vec<Complex<f64>>, Failure> {
        let at = |speed: f64| {
            move |error: SystemError| Failure::new(NoAnswer, format!("at a speed of {speed} m/s: {error}"))
        };
        self.with_values(&self.values, |equations, gravity| {
            let mut values = Vec::with_capacity(speeds.len() * self.model.eigenvalues());
            if let Some(coefficients) = equations.of_two() {
                let mut found = vec![Ok([Complex::default(); 4]); speeds.len()];
                let along = Batch::new().eigenvalues_along(coefficients, gravity, speeds, &mut found);
                along.map_err(|error| Failure::new(WrongSize, error))?;
                for (speed, found) in speeds.iter().zip(found) {
                    values.extend(found.map_err(at(*speed))?);
                }
            } else {
                for speed in speeds {
                    values.extend(equations.eigenvalues(*speed, gravity).map_err(at(*speed))?);
                }
            }
            Ok(values)
        })
    }

    /// The eigenvectors of eigenvalues at a speed.
    pub fn eigenvectors(&self, speed: f64, values: &[Complex<f64>]) -> Result<Vec<Shape>, Failure> {
        self.with_values(&self.values, |equations, gravity| Ok(equations.eigenvectors(speed, gravity, values)?))
    }

    /// The matrices A and B of the state-space form at a speed, row by row.
    pub fn state_space(&self, speed: f64) -> Result<[Vec<f64>; 2], Failure> {
        self.with_values(&self.values, |equations, gravity| Ok(equations.state_space(speed, gravity)?))
    }

    /// The critical speeds and stable ranges.
    pub fn stability(&self) -> Result<Stability, Failure> {
        let found = self.with_values(&self.values, |equations, gravity| Ok(equations.stability(gravity)?))?;
        Ok(Stability::new(self.model, self.values.clone(), found))
    }
}

impl Stability {
    /// The derivatives of a critical speed, by its index, with respect to each parameter.
    pub fn derivatives(&self, index: usize) -> Result<Vec<f64>, Failure> {
        let critical = self.found.critical_speeds.get(index).ok_or_else(|| {
            let count = self.found.critical_speeds.len();
            Failure::new(WrongSize, format!("the critical speed {index} is asked for; there are {count}, from 0"))
        })?;
        let no_answer = |message: String| Failure::new(NoAnswer, message);
        let sensitivity = self.model.sensitivity(&self.values).map_err(no_answer)?;
        match sensitivity.critical_speed(critical)? {
            CriticalDerivative::Smooth { speed, .. } => Ok(speed),
            CriticalDerivative::None(reason) => {
                Err(no_answer(format!("the critical speed {} m/s has no derivatives: {reason}", critical.speed)))
            }
        }
    }
}

/// Models that ship look at their parameters themselves; of given matrices nobody has.
fn check_entries(info: &ModelInfo, values: &[f64]) -> Result<(), Failure> {
    let wrong = info.parameters.iter().zip(values).find(|(parameter, value)| !parameter.domain.contains(**value));
    let Some((parameter, value)) = wrong else { return Ok(()) };
    let (name, required) = (parameter.name, parameter.domain);
    Err(Failure::new(Invalid, format!("`{name}` is {}; it must be {required}", with_unit(*value, parameter.unit))))
}

/// The form of given matrices: which there are, and which states the coordinates have.
type Form = (Vec<MatrixName>, Vec<States>);

/// Models of matrices stay as long as the program runs; so there is one for each form, and not for each machine. They are few, and
/// in a list valgrind finds them all.
static OF_MATRICES: Mutex<Vec<(Form, &'static Shipped)>> = Mutex::new(Vec::new());

fn model_of_matrices(names: Vec<MatrixName>, states: Vec<States>) -> &'static Shipped {
    let mut known = OF_MATRICES.lock().unwrap_or_else(PoisonError::into_inner);
    let form = (names, states);
    if let Some((_, model)) = known.iter().find(|(known, _)| *known == form) {
        return model;
    }
    let coordinates = form.1.iter().enumerate();
    let coordinates =
        coordinates.map(|(index, &states)| matrices::Coordinate { name: format!("q{}", index + 1), states });
    let coordinates = coordinates.collect();
    let model = matrices::model(&matrices::Form { matrices: form.0.clone(), coordinates });
    known.push((form, model));
    model
}
