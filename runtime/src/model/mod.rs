//! What a compiled model is: its traits, what it tells about itself, and what can be wrong with its parameters.

#[cfg(feature = "derive")]
mod declare;
mod derivatives;
mod domain;
mod error;
mod formula;
mod info;
mod motion_formulas;
mod nonlinear;
mod parameters_text;
mod rate;
mod sets;
mod traits;

pub use derivatives::{Differentiable, EvaluatorWithDerivatives, Partial, write_now};
pub use domain::{Bound, Domain};
pub use error::{LengthError, ParameterError};
pub use formula::{FormulaInfo, FormulaSubject};
pub use info::{CoordinateInfo, EntryInfo, ModelInfo, ParameterInfo, RequirementInfo, SetInfo};
pub use motion_formulas::MotionFormulas;
pub use nonlinear::Nonlinear;
pub use rate::Rate;
pub use traits::{Evaluator, Model, WithDerivatives};
