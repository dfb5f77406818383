//! The models that ship with Carvallo, without their types: whatever its number of coordinates, any of them can be chosen
//! by its name.

use std::any::Any;
use std::fmt;
use std::fmt::Debug;
use std::marker::PhantomData;

use carvallo::simulation::{LinearMotion, Machine};
use carvallo::{
    Branches, Coefficients, Complex, CoordinateInfo, CriticalDerivative, CriticalSpeed, Eigenvectors, Matrix,
    MatrixName, Model, ModelInfo, ParameterStability, Sensitivity, SensitivityError, Stability, StateSpace, States,
    SystemError,
};
use carvallo_models::Whipple;

use crate::matrices::dependent_column;
use crate::number::with_unit;

/// A model that ships with Carvallo.
#[derive(Clone, Copy, Debug)]
pub struct Shipped {
    /// What the model tells about itself.
    pub info: &'static ModelInfo,
    derivation: &'static dyn Derivation,
}

/// All of them.
#[cfg(feature = "full")]
pub static MODELS: &[Shipped] = &carvallo_models::each_model!(Shipped::of);

/// Some of bicycles with two coordinates: without the feature `full` there are no others.
#[cfg(not(feature = "full"))]
pub static MODELS: &[Shipped] = &[
    Shipped::of::<2, carvallo_models::BalanceAssist>(),
    Shipped::of::<2, carvallo_models::RearSteered>(),
    WHIPPLE,
    Shipped::of::<2, carvallo_models::WhippleMechanism>(),
    Shipped::of::<2, carvallo_models::WhippleSprung>(),
];

/// The model that is meant unless another one is named: that of the shipped bicycles.
pub const WHIPPLE: Shipped = Shipped::of::<2, Whipple>();

/// What makes equations of motion from parameters, which are in declared order.
pub(crate) trait Derivation: Debug + Sync {
    /// The equations of motion, or which of the parameters cannot be.
    fn equations(&self, parameters: &[f64]) -> Result<Box<dyn Equations>, String>;

    /// Hands the equations of motion to a visitor, where they need no place of their own in memory.
    fn visit(&self, parameters: &[f64], visitor: Visitor) -> Result<(), String>;

    /// Hands what the nonlinear equations of motion are of to a visitor; whether there are any.
    fn with_machine(&self, parameters: &[f64], visitor: MachineVisitor) -> Result<bool, String> {
        let _ = (parameters, visitor);
        Ok(false)
    }

    /// Stability along the parameter at a position, over a range and at a speed.
    fn along(
        &self,
        parameters: &[f64],
        position: usize,
        range: [f64; 2],
        speed: f64,
    ) -> Result<ParameterStability, String>;

    /// How the equations of motion change with the parameters.
    fn sensitivity(&self, parameters: &[f64]) -> Result<Box<dyn Sensitive>, String>;
}

/// What does something with a machine that moves.
pub type MachineVisitor<'a> = &'a mut dyn FnMut(&dyn Machine);

/// What looks at equations of motion, and may say what is wrong with them.
pub type Visitor<'a> = &'a mut dyn FnMut(&dyn Equations) -> Result<(), String>;

impl Shipped {
    /// A model by its type.
    pub const fn of<const N: usize, M: Model<N, Scalar = f64> + 'static>() -> Self {
        Self { info: Compiled::<N, M>::INFO, derivation: &Compiled::<N, M>(PhantomData) }
    }

    /// A model by what it tells about itself and what makes its equations of motion.
    pub(crate) const fn new(info: &'static ModelInfo, derivation: &'static dyn Derivation) -> Self {
        Self { info, derivation }
    }

    /// The model called so, in letters of either case.
    ///
    /// # Errors
    /// If there is none: that, the one that was probably meant, and those that there are.
    pub fn called(name: &str) -> Result<&'static Self, String> {
        if let Some(model) = MODELS.iter().find(|model| model.is_called(name)) {
            return Ok(model);
        }
        let names: Vec<&str> = MODELS.iter().map(|model| model.info.name).collect();
        let hint = crate::nearest::nearest(name, names.iter().copied());
        let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
        Err(format!("there is no model `{name}`{hint}\nthe models are {}", names.join(", ")))
    }

    /// Whether that is its name, in letters of either case.
    pub fn is_called(&self, name: &str) -> bool {
        self.info.name.eq_ignore_ascii_case(name)
    }

    /// Whether its parameters are those of the shipped bicycles.
    pub fn is_whipple(&self) -> bool {
        self.is_called(WHIPPLE.info.name)
    }

    /// The equations of motion for parameters in declared order.
    ///
    /// # Errors
    /// The first of them, or of the model's requirements, that does not hold.
    pub fn equations(&self, parameters: &[f64]) -> Result<Box<dyn Equations>, String> {
        self.derivation.equations(parameters)
    }

    /// Hands the equations of motion for parameters in declared order to a visitor: the way for many designs, since it
    /// allocates nothing.
    ///
    /// # Errors
    /// The first of them, or of the model's requirements, that does not hold; or what the visitor says.
    pub fn visit(&self, parameters: &[f64], visitor: Visitor) -> Result<(), String> {
        self.derivation.visit(parameters, visitor)
    }

    /// Hands the machine that the nonlinear equations of motion are of to a visitor, for parameters in declared order; whether
    /// there are any.
    ///
    /// # Errors
    /// The first of the parameters, or of the model's requirements, that does not hold.
    pub fn with_machine(&self, parameters: &[f64], visitor: MachineVisitor) -> Result<bool, String> {
        self.derivation.with_machine(parameters, visitor)
    }

    /// Stability along the parameter at a position, over a range and at a speed in m/s.
    ///
    /// # Errors
    /// A value at which a parameter or a requirement of the model does not hold; or that there is no answer.
    pub fn along(
        &self,
        parameters: &[f64],
        position: usize,
        range: [f64; 2],
        speed: f64,
    ) -> Result<ParameterStability, String> {
        self.derivation.along(parameters, position, range, speed)
    }

    /// How the equations of motion change with parameters in declared order.
    ///
    /// # Errors
    /// The first of them, or of the model's requirements, that does not hold; that the model was compiled without
    /// derivatives; or that one is not finite.
    pub fn sensitivity(&self, parameters: &[f64]) -> Result<Box<dyn Sensitive>, String> {
        self.derivation.sensitivity(parameters)
    }

    /// How many eigenvalues there are: one for each state.
    pub fn eigenvalues(&self) -> usize {
        let states = |coordinate: &CoordinateInfo| if coordinate.states == States::Both { 2 } else { 1 };
        self.info.coordinates.iter().map(states).sum()
    }

    /// Whether critical speeds are the roots of polynomials with coefficients that are known: of two coordinates, with their
    /// positions and rates for states, and without C-1 and K1.
    pub fn has_known_polynomials(&self) -> bool {
        let odd = [MatrixName::Cm1, MatrixName::K1];
        self.eigenvalues() == 4
            && self.info.coordinates.len() == 2
            && !odd.iter().any(|matrix| self.info.matrices.contains(matrix))
    }

    /// Whether the equations of motion depend on the speed.
    pub fn depends_on_speed(&self) -> bool {
        self.info.depends_on_speed()
    }
}

/// The functions that a declaration was compiled to.
struct Compiled<const N: usize, M>(PhantomData<fn() -> M>);

impl<const N: usize, M: Model<N, Scalar = f64>> Compiled<N, M> {
    /// The formulas are for `equations`, and many times as long as all else.
    const INFO: &'static ModelInfo = if cfg!(feature = "full") { M::INFO } else { &M::INFO.without_formulas() };
}

impl<const N: usize, M: Model<N, Scalar = f64>> Derivation for Compiled<N, M> {
    fn equations(&self, parameters: &[f64]) -> Result<Box<dyn Equations>, String> {
        Ok(Box::new(valid::<N, M>(parameters)?.coefficients()))
    }

    fn visit(&self, parameters: &[f64], visitor: Visitor) -> Result<(), String> {
        visitor(&valid::<N, M>(parameters)?.coefficients())
    }

    fn with_machine(&self, parameters: &[f64], visitor: MachineVisitor) -> Result<bool, String> {
        let model = valid::<N, M>(parameters)?;
        let machine = model.nonlinear();
        machine.iter().for_each(|machine| visitor(machine));
        Ok(machine.is_some())
    }

    fn along(
        &self,
        parameters: &[f64],
        position: usize,
        range: [f64; 2],
        speed: f64,
    ) -> Result<ParameterStability, String> {
        if !cfg!(feature = "full") {
            return Err(NOT_BUILT.to_owned());
        }
        let mut parameters = parameters.to_vec();
        let system = |value: f64| {
            parameters[position] = value;
            let gravity = M::INFO.gravity.map_or(0.0, |position| parameters[position]);
            let coefficients = valid::<N, M>(&parameters)?.coefficients();
            coefficients.at(speed, gravity).map_err(|error| error.to_string())
        };
        ParameterStability::new(range, system).map_err(|error| error.to_string())
    }

    fn sensitivity(&self, parameters: &[f64]) -> Result<Box<dyn Sensitive>, String> {
        if !cfg!(feature = "full") {
            return Err(NOT_BUILT.to_owned());
        }
        let sensitivity = Sensitivity::<N>::of_any(&valid::<N, M>(parameters)?).map_err(|error| error.to_string())?;
        Ok(Box::new(sensitivity))
    }
}

/// What is said in the place of what a program was built without.
pub(crate) const NOT_BUILT: &str = "this program was built without what goes along parameters";

impl<const N: usize, M> Debug for Compiled<N, M> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(std::any::type_name::<M>())
    }
}

/// The model with parameters in declared order.
fn valid<const N: usize, M: Model<N, Scalar = f64>>(parameters: &[f64]) -> Result<M, String> {
    let model = M::from_slice(parameters).map_err(|error| error.to_string())?;
    model.validate().map_err(|error| {
        let value = with_unit(error.value, error.unit);
        format!("`{}` is {value}; it must be {}", error.subject, error.required)
    })?;
    Ok(model)
}

/// What is of any number of coordinates, as what is of two, for which there is more to be had; `None` if it is of another
/// number. The types differ with the number, and only their identity tells whether it is two; it is known when the program
/// is compiled, so that nothing is left of the question.
fn as_of_two<T: Any, Two: Any>(value: &T) -> Option<&Two> {
    (value as &dyn Any).downcast_ref()
}

/// The right and the left eigenvector of an eigenvalue, by coordinate.
#[derive(Clone, Debug)]
pub struct Shape {
    /// As [`Eigenvectors`] has it.
    pub right: Vec<Complex<f64>>,
    /// As [`Eigenvectors`] has it.
    pub left: Vec<Complex<f64>>,
}

/// The linearized equations of motion for any number of coordinates.
pub trait Equations: Debug {
    /// All matrices, with their rows.
    fn matrices(&self) -> [(MatrixName, Vec<Vec<f64>>); 8];

    /// The eigenvalues in 1/s at a speed in m/s and a gravitational field strength in N/kg, sorted by real part, then by
    /// imaginary part.
    ///
    /// # Errors
    /// If there are none, as for a singular mass matrix.
    fn eigenvalues(&self, speed: f64, gravity: f64) -> Result<Vec<Complex<f64>>, SystemError>;

    /// The motion at a speed in m/s and a gravitational field strength in N/kg.
    ///
    /// # Errors
    /// If there is none, as for a singular mass matrix.
    fn motion(&self, speed: f64, gravity: f64) -> Result<LinearMotion, SystemError>;

    /// The matrices M, C and K at a speed in m/s and a gravitational field strength in N/kg, row by row.
    ///
    /// # Errors
    /// If there are none, as at rest with a C-1.
    fn system(&self, speed: f64, gravity: f64) -> Result<[Vec<f64>; 3], SystemError>;

    /// The matrices A and B of the state-space form `x' = A x + B f` at a speed in m/s and a gravitational field strength in
    /// N/kg, row by row. The states x are the positions that are states, then the rates; the inputs f are the forces of all
    /// coordinates.
    ///
    /// # Errors
    /// If there are none, as for a singular mass matrix.
    fn state_space(&self, speed: f64, gravity: f64) -> Result<[Vec<f64>; 2], SystemError>;

    /// The eigenvectors of all eigenvalues at a speed, given in any order, in the same order.
    ///
    /// # Errors
    /// If one leaves the range of doubles.
    fn eigenvectors(&self, speed: f64, gravity: f64, values: &[Complex<f64>]) -> Result<Vec<Shape>, SystemError>;

    /// The critical speeds and stable ranges at a gravitational field strength in N/kg.
    ///
    /// # Errors
    /// If there are none, as for a singular mass matrix.
    fn stability(&self, gravity: f64) -> Result<Stability, SystemError>;

    /// The eigenvalues followed one by one over a range of speeds in m/s, at a gravitational field strength in N/kg, with names
    /// from critical speeds; as those of a machine that leans and steers, or of any other.
    ///
    /// # Errors
    /// If there are none at some speed in the range.
    fn branches(
        &self,
        gravity: f64,
        critical_speeds: &[CriticalSpeed],
        range: [f64; 2],
        is_bicycle: bool,
    ) -> Result<Branches, SystemError>;

    /// The coefficients of exactly two coordinates, for which there is more to be had: without C-1 and K1, and with
    /// positions and rates for states.
    fn of_two(&self) -> Option<&Coefficients<f64, 2>>;

    /// Why there are no equations of motion at rest, if there are none, as the end of a sentence.
    fn without_rest(&self) -> Option<&'static str>;
}

/// How the equations of motion change with the parameters, for any number of coordinates.
pub trait Sensitive: Debug {
    /// The derivatives of a critical speed.
    ///
    /// # Errors
    /// If one leaves the range of doubles.
    fn critical_speed(&self, critical: &CriticalSpeed) -> Result<CriticalDerivative, SystemError>;

    /// The standard deviations of the entries of the matrices, from those of the parameters in their order.
    ///
    /// # Errors
    /// If one leaves the range of doubles.
    fn matrix_deviations(&self, deviations: &[f64]) -> Result<Box<dyn Equations>, SensitivityError>;
}

impl<const N: usize> Sensitive for Sensitivity<N> {
    fn critical_speed(&self, critical: &CriticalSpeed) -> Result<CriticalDerivative, SystemError> {
        Sensitivity::critical_speed(self, critical)
    }

    fn matrix_deviations(&self, deviations: &[f64]) -> Result<Box<dyn Equations>, SensitivityError> {
        Ok(Box::new(Sensitivity::matrix_deviations(self, deviations)?))
    }
}

impl<const N: usize> Equations for Coefficients<f64, N> {
    fn matrices(&self) -> [(MatrixName, Vec<Vec<f64>>); 8] {
        let rows = |matrix: &Matrix<f64, N>| matrix.row_iter().map(|row| row.iter().copied().collect()).collect();
        MatrixName::ALL.map(|name| (name, rows(self.matrix(name))))
    }

    fn eigenvalues(&self, speed: f64, gravity: f64) -> Result<Vec<Complex<f64>>, SystemError> {
        self.at(speed, gravity)?.eigenvalues()
    }

    fn motion(&self, speed: f64, gravity: f64) -> Result<LinearMotion, SystemError> {
        LinearMotion::new(&self.at(speed, gravity)?)
    }

    fn system(&self, speed: f64, gravity: f64) -> Result<[Vec<f64>; 3], SystemError> {
        let system = self.at(speed, gravity)?;
        Ok([&system.m, &system.c, &system.k].map(|matrix| matrix.transpose().as_slice().to_vec()))
    }

    fn state_space(&self, speed: f64, gravity: f64) -> Result<[Vec<f64>; 2], SystemError> {
        let StateSpace { stiffness, damping, input, states } = self.at(speed, gravity)?.state_space()?;
        let positions = (0..N).filter(|&index| states[index] != States::Rate);
        let rates = (0..N).filter(|&index| states[index] != States::Position);
        let [mut a, mut b] = [Vec::new(), Vec::new()];
        let solved = |row: usize, a: &mut Vec<f64>, b: &mut Vec<f64>| {
            a.extend(positions.clone().map(|column| stiffness[(row, column)]));
            a.extend(rates.clone().map(|column| damping[(row, column)]));
            b.extend(input.row(row).iter());
        };
        for row in positions.clone() {
            if states[row] == States::Position {
                solved(row, &mut a, &mut b);
                continue;
            }
            a.extend(positions.clone().map(|_| 0.0));
            a.extend(rates.clone().map(|column| if column == row { 1.0 } else { 0.0 }));
            b.extend([0.0; N]);
        }
        rates.clone().for_each(|row| solved(row, &mut a, &mut b));
        Ok([a, b])
    }

    fn eigenvectors(&self, speed: f64, gravity: f64, values: &[Complex<f64>]) -> Result<Vec<Shape>, SystemError> {
        let vectors = self.at(speed, gravity)?.eigenvectors(values)?;
        // Adding zero turns -0 into 0.
        let positive_zeros = |entry: &Complex<f64>| Complex::new(entry.re + 0.0, entry.im + 0.0);
        let shape = |vectors: Eigenvectors<N>| Shape {
            right: vectors.right.iter().map(positive_zeros).collect(),
            left: vectors.left.iter().map(positive_zeros).collect(),
        };
        Ok(vectors.into_iter().map(shape).collect())
    }

    fn stability(&self, gravity: f64) -> Result<Stability, SystemError> {
        Stability::new(self, gravity)
    }

    fn branches(
        &self,
        gravity: f64,
        critical_speeds: &[CriticalSpeed],
        range: [f64; 2],
        is_bicycle: bool,
    ) -> Result<Branches, SystemError> {
        Branches::new(self, gravity, critical_speeds, range, is_bicycle)
    }

    fn of_two(&self) -> Option<&Coefficients<f64, 2>> {
        let is_zero = |matrix: &Matrix<f64, N>| matrix.iter().all(|&entry| entry == 0.0);
        let has_both = self.states.iter().all(|states| *states == States::Both);
        as_of_two(self).filter(|_| has_both && is_zero(&self.cm1) && is_zero(&self.k1))
    }

    fn without_rest(&self) -> Option<&'static str> {
        if self.cm1.iter().any(|&entry| entry != 0.0) {
            return Some("C-1 is divided by the speed");
        }
        let mut leading = self.m;
        for (column, _) in self.states.iter().enumerate().filter(|(_, states)| **states == States::Position) {
            leading.set_column(column, &self.c0.column(column));
        }
        let is_singular =
            self.states.contains(&States::Position) && dependent_column(leading.as_slice(), N, |_| true).is_some();
        is_singular.then_some("the rate of a coordinate of first order is multiplied by the speed alone")
    }
}
