//! The models that ship with Carvallo, any of which can be chosen by its name.

use std::marker::PhantomData;
use std::sync::{Mutex, PoisonError};

use carvallo::{CoordinateInfo, MatrixName, Model, ModelInfo, ParameterStability, States};
use carvallo_models::Whipple;

use super::derivation::{Compiled, Derivation, MachineVisitor, Visitor};
use super::equations::Equations;
use super::sensitive::Sensitive;
use crate::feedback::{Gain, Law};
use crate::path::Path;

/// A model that ships with Carvallo.
#[derive(Clone, Copy, Debug)]
pub struct Shipped {
    /// What the model tells about itself.
    pub info: &'static ModelInfo,
    /// The same without feedback.
    pub(crate) open: &'static ModelInfo,
    derivation: &'static dyn Derivation,
    gains: &'static [Gain],
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

impl Shipped {
    /// A model by its type.
    pub const fn of<const N: usize, M: Model<N, Scalar = f64> + 'static>() -> Self {
        Self::new(Compiled::<N, M>::INFO, &Compiled::<N, M>(PhantomData))
    }

    /// A model by what it tells about itself and what makes its equations of motion.
    pub(crate) const fn new(info: &'static ModelInfo, derivation: &'static dyn Derivation) -> Self {
        Self { info, open: info, derivation, gains: &[] }
    }

    /// The same model with feedback, in the place of what it may have had. It stays as long as the program runs, as other models
    /// do, and there is one for each choice of gains. Without laws it is the model itself.
    #[must_use]
    pub fn with_feedback(&'static self, laws: &[Law]) -> &'static Self {
        let gains: Vec<Gain> = laws.iter().flat_map(|law| &law.gains).copied().collect();
        if gains.is_empty() && self.gains.is_empty() {
            return self;
        }
        static CLOSED: Mutex<Vec<&Shipped>> = Mutex::new(Vec::new());
        let mut closed = CLOSED.lock().unwrap_or_else(PoisonError::into_inner);
        let is_same = |other: &&&Self| std::ptr::eq(other.open, self.open) && other.gains == gains;
        if let Some(model) = closed.iter().find(is_same) {
            return model;
        }
        let has =
            |name: &MatrixName| self.open.matrices.contains(name) || gains.iter().any(|gain| gain.matrix == *name);
        let matrices: Vec<MatrixName> = MatrixName::ALL.into_iter().filter(has).collect();
        let info = Box::leak(Box::new(ModelInfo { matrices: Vec::leak(matrices), ..*self.open }));
        let model = Box::leak(Box::new(Self { info, gains: Vec::leak(gains), ..*self }));
        closed.push(model);
        model
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
        self.derivation.equations(parameters, self.gains)
    }

    /// Hands the equations of motion for parameters in declared order to a visitor: the way for many designs, since it
    /// allocates nothing.
    ///
    /// # Errors
    /// The first of them, or of the model's requirements, that does not hold; or what the visitor says.
    pub fn visit(&self, parameters: &[f64], visitor: Visitor) -> Result<(), String> {
        self.derivation.visit(parameters, self.gains, visitor)
    }

    /// Hands the machine that the nonlinear equations of motion are of to a visitor, for parameters in declared order; whether
    /// there are any. It has no feedback.
    ///
    /// # Errors
    /// The first of the parameters, or of the model's requirements, that does not hold.
    pub fn with_machine(&self, parameters: &[f64], visitor: MachineVisitor) -> Result<bool, String> {
        self.derivation.with_machine(parameters, visitor)
    }

    /// The generalized forces on the coordinates that a force of one makes, by its place among the
    /// [forces](carvallo::ModelInfo::forces) of the model, for parameters in declared order; nothing if there is no such force.
    pub fn shares(&self, parameters: &[f64], force: usize) -> Option<Vec<f64>> {
        self.derivation.shares(parameters, force)
    }

    /// Stability along a path through the parameters, over a range of what changes along it and at a speed in m/s.
    ///
    /// # Errors
    /// A value at which a parameter or a requirement of the model does not hold; or that there is no answer.
    pub fn along(&self, path: &Path, range: [f64; 2], speed: f64) -> Result<ParameterStability, String> {
        self.derivation.along(path, self.gains, range, speed)
    }

    /// How the equations of motion change with parameters in declared order.
    ///
    /// # Errors
    /// The first of them, or of the model's requirements, that does not hold; that the model was compiled without
    /// derivatives; or that one is not finite.
    pub fn sensitivity(&self, parameters: &[f64]) -> Result<Box<dyn Sensitive>, String> {
        self.derivation.sensitivity(parameters, self.gains)
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
