//! What makes equations of motion from parameters: the functions that a declaration was compiled to, without its type.

use std::borrow::Cow;
use std::fmt;
use std::fmt::Debug;
use std::marker::PhantomData;

use carvallo::simulation::Machine;
use carvallo::{
    Coefficients, Model, ModelInfo, ParameterError, ParameterStability, Sensitivity, SensitivityError, System,
};

use super::equations::Equations;
use super::sensitive::Sensitive;
use crate::feedback::{Gain, Input, close, on_coordinates};
use crate::number::with_unit;
use crate::path::Path;

/// What makes equations of motion from parameters, which are in declared order, with a loop that is closed by gains, if there
/// are any.
pub(crate) trait Derivation: Debug + Sync {
    /// The equations of motion, or which of the parameters cannot be.
    fn equations(&self, parameters: &[f64], gains: &[Gain]) -> Result<Box<dyn Equations>, String>;

    /// Hands the equations of motion to a visitor, where they need no place of their own in memory.
    fn visit(&self, parameters: &[f64], gains: &[Gain], visitor: Visitor) -> Result<(), String>;

    /// Hands what the nonlinear equations of motion are of to a visitor; whether there are any.
    fn with_machine(&self, parameters: &[f64], visitor: MachineVisitor) -> Result<bool, String> {
        let _ = (parameters, visitor);
        Ok(false)
    }

    /// The generalized forces on the coordinates that a force of one of the mechanism makes, by its place among those of the model.
    fn shares(&self, parameters: &[f64], force: usize) -> Option<Vec<f64>> {
        let _ = (parameters, force);
        None
    }

    /// Stability along a path through the parameters, over a range and at a speed.
    fn along(&self, path: &Path, gains: &[Gain], range: [f64; 2], speed: f64) -> Result<ParameterStability, String>;

    /// How the equations of motion change with the parameters.
    fn sensitivity(&self, parameters: &[f64], gains: &[Gain]) -> Result<Box<dyn Sensitive>, String>;
}

/// What does something with a machine that moves.
pub type MachineVisitor<'a> = &'a mut dyn FnMut(&dyn Machine);

/// What looks at equations of motion, and may say what is wrong with them.
pub type Visitor<'a> = &'a mut dyn FnMut(&dyn Equations) -> Result<(), String>;

/// The functions that a declaration was compiled to.
pub(super) struct Compiled<const N: usize, M>(pub(super) PhantomData<fn() -> M>);

impl<const N: usize, M: Model<N, Scalar = f64>> Compiled<N, M> {
    /// The formulas are for `equations`, and many times as long as all else.
    pub(super) const INFO: &'static ModelInfo =
        if cfg!(feature = "full") { M::INFO } else { &M::INFO.without_formulas() };
}

impl<const N: usize, M: Model<N, Scalar = f64>> Derivation for Compiled<N, M> {
    fn equations(&self, parameters: &[f64], gains: &[Gain]) -> Result<Box<dyn Equations>, String> {
        let model = valid::<N, M>(parameters)?;
        Ok(Box::new(close(model.coefficients(), &acting(&model, gains))))
    }

    fn visit(&self, parameters: &[f64], gains: &[Gain], visitor: Visitor) -> Result<(), String> {
        let model = valid::<N, M>(parameters)?;
        visitor(&close(model.coefficients(), &acting(&model, gains)))
    }

    fn with_machine(&self, parameters: &[f64], visitor: MachineVisitor) -> Result<bool, String> {
        let model = valid::<N, M>(parameters)?;
        let machine = model.nonlinear();
        machine.iter().for_each(|machine| visitor(machine));
        Ok(machine.is_some())
    }

    fn shares(&self, parameters: &[f64], force: usize) -> Option<Vec<f64>> {
        valid::<N, M>(parameters).ok()?.shares(force).map(|shares| shares.to_vec())
    }

    fn along(&self, path: &Path, gains: &[Gain], range: [f64; 2], speed: f64) -> Result<ParameterStability, String> {
        if !cfg!(feature = "full") {
            return Err(NOT_BUILT.to_owned());
        }
        let mut system = |value: f64| {
            let parameters = path.at(value)?;
            let gravity = M::INFO.gravity.map_or(0.0, |position| parameters[position]);
            let model = valid::<N, M>(&parameters)?;
            at(model.coefficients(), &acting(&model, gains), speed, gravity)
        };
        // Of one type for all models of so many coordinates.
        let system: &mut dyn FnMut(f64) -> Result<System<N>, String> = &mut system;
        ParameterStability::new(range, system).map_err(|error| error.to_string())
    }

    fn sensitivity(&self, parameters: &[f64], gains: &[Gain]) -> Result<Box<dyn Sensitive>, String> {
        if !cfg!(feature = "full") {
            return Err(NOT_BUILT.to_owned());
        }
        let model = valid::<N, M>(parameters)?;
        if let Some(Gain { input: Input::Applied(force), .. }) = gains.iter().find(|gain| is_applied(gain)) {
            return Err(format!(
                "there are no derivatives with feedback of `{0}`, which acts on no coordinate: how `{0}` moves them changes with \
                 parameters; expected forces on the coordinates",
                M::INFO.forces[*force].name
            ));
        }
        let without = SensitivityError::WithoutDerivatives { model: M::INFO.name };
        let (coefficients, derivatives) = model.derivatives().ok_or_else(|| without.to_string())?;
        let gravity = (Model::gravity(&model).unwrap_or(0.0), M::INFO.gravity);
        sensitive(coefficients, derivatives.as_ref(), gains, gravity)
    }
}

fn is_applied(gain: &Gain) -> bool {
    matches!(gain.input, Input::Applied(_))
}

/// Gains on coordinates alone, at the parameters of a model.
fn acting<'a, const N: usize, M: Model<N, Scalar = f64>>(model: &M, gains: &'a [Gain]) -> Cow<'a, [Gain]> {
    if !cfg!(feature = "full") || !gains.iter().any(is_applied) {
        return Cow::Borrowed(gains);
    }
    Cow::Owned(on_coordinates(gains, |force| model.shares(force).map_or(Vec::new(), |shares| shares.to_vec())))
}

/// The equations of motion of a closed loop at a speed and a gravity.
fn at<const N: usize>(
    coefficients: Coefficients<f64, N>,
    gains: &[Gain],
    speed: f64,
    gravity: f64,
) -> Result<System<N>, String> {
    close(coefficients, gains).at(speed, gravity).map_err(|error| error.to_string())
}

/// How those of a closed loop change with the parameters, of which one is the gravity. Gains are numbers: the derivatives are
/// those of the open loop.
pub(crate) fn sensitive<const N: usize>(
    coefficients: Coefficients<f64, N>,
    derivatives: &[Coefficients<f64, N>],
    gains: &[Gain],
    (gravity, parameter): (f64, Option<usize>),
) -> Result<Box<dyn Sensitive>, String> {
    let sensitivity = Sensitivity::new(&close(coefficients, gains), derivatives, gravity, parameter);
    Ok(Box::new(sensitivity.map_err(|error| error.to_string())?))
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
    model.validate().map_err(refusal)?;
    Ok(model)
}

fn refusal(error: ParameterError) -> String {
    let value = with_unit(error.value, error.unit);
    format!("`{}` is {value}; it must be {}", error.subject, error.required)
}
