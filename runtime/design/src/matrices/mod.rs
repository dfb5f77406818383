//! Matrices that are given themselves, as a model with their entries for parameters.

mod check;

use std::array;
use std::sync::{Mutex, PoisonError};

use carvallo::{
    Coefficients, CoordinateInfo, Domain, Matrix, MatrixName, ModelInfo, ParameterInfo, ParameterStability, States,
};

use self::check::check;
pub use self::check::{dependent_column, free};
use crate::feedback::{Gain, close};
use crate::model::{Derivation, Equations, NOT_BUILT, Sensitive, Shipped, Visitor, sensitive};
use crate::path::Path;

/// What the model of given matrices is called.
pub const NAME: &str = "Matrices";

/// What it was called where all matrices were given; files may still say so.
const FORMER_NAME: &str = "AllMatrices";

/// Why nothing goes along a parameter of theirs.
pub const NO_PARAMETERS: &str =
    "matrices that are given themselves have no parameters but their entries, which `carvallo sweep --vary` goes along";

/// The most coordinates that given matrices may have: 12, or 2 without the feature `full`.
pub const MOST: usize = if cfg!(feature = "full") { 12 } else { 2 };

/// What matrices are given, without their entries.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Form {
    /// The first one is M.
    pub matrices: Vec<MatrixName>,
    /// One for each row, from 1 to [`MOST`] of them.
    pub coordinates: Vec<Coordinate>,
}

/// A coordinate of given matrices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coordinate {
    /// What it is called.
    pub name: String,
    /// What of it is a state.
    pub states: States,
}

/// Whether that is the name of the model of given matrices, in letters of either case.
pub fn is_called(name: &str) -> bool {
    [NAME, FORMER_NAME].iter().any(|own| own.eq_ignore_ascii_case(name))
}

/// What an entry of a matrix is called as a parameter: `M_12`, and with more than nine rows `M_1_12`. Both count from zero.
pub fn entry_name(matrix: MatrixName, row: usize, column: usize, count: usize) -> String {
    let between = if count > 9 { "_" } else { "" };
    format!("{matrix}_{}{between}{}", row + 1, column + 1)
}

/// The model of given matrices. It stays as long as the program runs, as other models do; there is one for each form.
pub fn model(form: &Form) -> &'static Shipped {
    static MODELS: Mutex<Vec<(Form, &Shipped)>> = Mutex::new(Vec::new());
    let mut models = MODELS.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((_, model)) = models.iter().find(|(own, _)| own == form) {
        return model;
    }
    let model = made(form);
    models.push((form.clone(), model));
    model
}

fn made(form: &Form) -> &'static Shipped {
    macro_rules! model_of {
        ($($n:literal)+) => {
            match form.coordinates.len() {
                $($n => of::<$n>(form),)+
                count => unreachable!("{count} coordinates are not from 1 to {MOST}"),
            }
        };
    }
    #[cfg(feature = "full")]
    return model_of!(1 2 3 4 5 6 7 8 9 10 11 12);
    #[cfg(not(feature = "full"))]
    model_of!(1 2)
}

fn of<const N: usize>(form: &Form) -> &'static Shipped {
    let info = info(form);
    Box::leak(Box::new(Shipped::new(info, Box::leak(Box::new(Given::<N> { info })))))
}

fn info(form: &Form) -> &'static ModelInfo {
    let count = form.coordinates.len();
    let coordinates: Vec<CoordinateInfo> = form
        .coordinates
        .iter()
        .map(|Coordinate { name, states }| CoordinateInfo::new(leak(name.clone()), "1").states(*states))
        .collect();
    let mut parameters: Vec<ParameterInfo> = Vec::new();
    for matrix in &form.matrices {
        for (row, column) in (0..count * count).map(|index| (index / count, index % count)) {
            parameters.push(ParameterInfo::new(leak(entry_name(*matrix, row, column, count)), "1", Domain::FINITE));
        }
    }
    let gravity = Some(parameters.len());
    let g = ParameterInfo::new("g", "N/kg", Domain::NONNEGATIVE).docs("Gravitational field strength.");
    parameters.push(if form.matrices.contains(&MatrixName::K0) { g } else { g.unused() });
    Box::leak(Box::new(ModelInfo {
        name: NAME,
        docs: "Matrices that are given themselves.",
        source: "",
        parameters: Vec::leak(parameters),
        coordinates: Vec::leak(coordinates),
        forces: &[],
        matrices: Vec::leak(form.matrices.clone()),
        entries: &[],
        sets: &[],
        requirements: &[],
        formulas: &[],
        attributes: &[],
        motion: None,
        gravity,
    }))
}

fn leak(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}

/// Matrices whose entries, row by row, are the parameters.
#[derive(Debug)]
struct Given<const N: usize> {
    info: &'static ModelInfo,
}

impl<const N: usize> Given<N> {
    /// The matrices with these entries; those that are not given are zero.
    fn coefficients(&self, entries: &[f64]) -> Result<Coefficients<f64, N>, String> {
        let states = array::from_fn(|index| self.info.coordinates[index].states);
        let mut coefficients = Coefficients::<f64, N> { states, ..Default::default() };
        for (name, entries) in self.info.matrices.iter().zip(entries.chunks_exact(N * N)) {
            *coefficients.matrix_mut(*name) = Matrix::from_row_slice(entries);
        }
        check(&MatrixName::ALL.map(|name| (name, coefficients.matrix(name).as_slice())), self.info)?;
        Ok(coefficients)
    }
}

impl<const N: usize> Derivation for Given<N> {
    fn equations(&self, parameters: &[f64], gains: &[Gain]) -> Result<Box<dyn Equations>, String> {
        Ok(Box::new(close(self.coefficients(parameters)?, gains)))
    }

    fn visit(&self, parameters: &[f64], gains: &[Gain], visitor: Visitor) -> Result<(), String> {
        visitor(&close(self.coefficients(parameters)?, gains))
    }

    fn along(&self, _: &Path, _: &[Gain], _: [f64; 2], _: f64) -> Result<ParameterStability, String> {
        Err(NO_PARAMETERS.to_owned())
    }

    /// Each entry by itself: one, where the parameter is it, in the matrix of the derivatives by it.
    fn sensitivity(&self, parameters: &[f64], gains: &[Gain]) -> Result<Box<dyn Sensitive>, String> {
        if !cfg!(feature = "full") {
            return Err(NOT_BUILT.to_owned());
        }
        let coefficients = self.coefficients(parameters)?;
        let place = |index: usize| (index / (N * N), index / N % N, index % N);
        let by_entry = |index: usize| {
            let (matrix, row, column) = place(index);
            let mut derivative = Coefficients { states: coefficients.states, ..Default::default() };
            derivative.matrix_mut(self.info.matrices[matrix])[(row, column)] = 1.0;
            derivative
        };
        let mut derivatives: Vec<_> = (0..N * N * self.info.matrices.len()).map(by_entry).collect();
        // Gravity, the last parameter, is in no matrix.
        let gravity = derivatives.len();
        derivatives.push(Coefficients { states: coefficients.states, ..Default::default() });
        sensitive(coefficients, &derivatives, gains, (parameters[gravity], Some(gravity)))
    }
}
