//! Integration tests: results of generated code and of the runtime against facts from outside of both.

mod along_parameter;
mod batch;
mod batch_cores;
mod batch_derivatives;
mod batch_eigenvalues;
mod batch_motion;
mod batch_stability;
mod bicycles;
mod c;
#[cfg(feature = "compiler")]
mod chosen_derivatives;
#[cfg(feature = "compiler")]
mod claims;
#[cfg(feature = "compiler")]
mod compared;
mod critical_speeds;
mod derivatives;
mod designs;
#[cfg(feature = "compiler")]
mod determinism;
mod eigenvalues;
#[cfg(feature = "compiler")]
mod enormous;
mod events;
#[cfg(feature = "compiler")]
mod explained;
mod fast_stability;
#[cfg(feature = "compiler")]
mod formulas;
#[cfg(feature = "compiler")]
mod generation;
#[cfg(feature = "compiler")]
mod kept;
mod machines;
mod many_coordinates;
mod mechanisms;
mod modes;
mod motion;
mod multibody;
#[cfg(feature = "compiler")]
mod mutants;
mod operations;
mod parameters;
#[cfg(feature = "compiler")]
mod proved_states;
mod published;
mod published_speeds;
mod random_systems;
#[cfg(feature = "compiler")]
mod regenerate;
mod rounding;
mod rows;
mod sensitivity;
mod serialization;
mod simulation;
mod single_precision;
mod some_derivatives;
mod spread_eigenvalues;
mod stability;
mod state_space;
mod states;
mod textbook;
mod trigonometry;
#[cfg(feature = "compiler")]
mod without_derivatives;
mod wrong_attributes;
mod wrong_motion;
