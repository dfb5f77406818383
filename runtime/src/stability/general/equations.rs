//! Equations of motion of any number of coordinates along the speed, in units in which their numbers are about one.

use core::cell::Cell;

use super::combination::Combination;
use super::field::RealField;
use super::functions::{GRAVITY, ONE, OVER_SPEED, SPEED, SQUARE, Values, Variable};
use super::units::Units;
use crate::eigenvalues::{Layout, Spectrum, solve};
use crate::numeric::{DoubleDouble, Square};
use crate::system::{Coefficients, MatrixName, States, SystemError, require_finite};

/// The coefficient matrices of any number of coordinates, in the order of [`MatrixName::ALL`].
pub(crate) struct Matrices {
    pub(super) all: [Square<f64>; 8],
    pub(super) states: Vec<States>,
}

impl<const N: usize> From<&Coefficients<f64, N>> for Matrices {
    fn from(coefficients: &Coefficients<f64, N>) -> Self {
        Self::from_columns(&|name| coefficients.matrix(name).as_slice(), &coefficients.states)
    }
}

impl Matrices {
    /// Not generic, so that it is compiled once.
    fn from_columns<'a>(matrix: &dyn Fn(MatrixName) -> &'a [f64], states: &[States]) -> Self {
        let square = |name| Square::from_columns(states.len(), matrix(name));
        Self { all: MatrixName::ALL.map(square), states: states.to_vec() }
    }
}

/// What of a coordinate is a state, and by which power of s its column of the pencil is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Column {
    /// Position and rate: `s^2 M + s C + K`.
    Both,
    /// The position alone, of a coordinate of first order: `s C + K`.
    Position,
    /// The rate alone: `s M + C`.
    Rate,
    /// Neither, of a coordinate whose rate does not matter either: `M`.
    Neither,
}

/// `M q'' + (C_-1/v + C_0 + v C_1) q' + (K_c + g K_0 + v K_1 + v^2 K_2) q = 0`, in scaled units.
pub(super) struct Equations {
    pub(super) mass: Combination,
    pub(super) damping: Combination,
    pub(super) stiffness: Combination,
    pub(super) variable: Variable,
    pub(super) columns: Vec<Column>,
    layout: Layout,
    /// The transposed state matrix, where all rates are states: then no speed needs an elimination.
    solved: Option<Combination>,
    /// Eigenvalues that are zero at all speeds, of coordinates that nothing holds and that are not declared as such.
    pub(super) zeros: usize,
    pub(super) units: Units,
    /// Whether, along the speed, eigenvalues are symmetric about the imaginary axis at all speeds, since M and the stiffness are symmetric and the
    /// damping is skew.
    pub(super) is_conservative: bool,
    /// Whether transposing all matrices changes the sign of the speed, since only what is multiplied by it is skew, and all else
    /// symmetric.
    pub(super) is_reversible: bool,
    /// How many eigenvalue problems and pencils were computed, each in units of the time that it takes, about.
    effort: Cell<usize>,
}

/// The effort at which a search ends: more than ten times what any random system of the tests takes.
const MOST: usize = 40_000;

impl Equations {
    pub(super) fn new(matrices: &Matrices, gravity: f64) -> Result<Self, SystemError> {
        require_finite("gravity", gravity)?;
        for (name, matrix) in MatrixName::ALL.into_iter().zip(&matrices.all) {
            matrix.entries().iter().try_for_each(|&entry| require_finite(name.name(), entry))?;
        }
        let (units, size) = (Units::new(matrices, gravity)?, matrices.states.len());
        let [m, cm1, c0, c1, kc, k0, k1, k2] = units.scale(&matrices.all);
        let mass = Combination::new(size, [(ONE, m)]);
        let damping = Combination::new(size, [(OVER_SPEED, cm1), (ONE, c0), (SPEED, c1)]);
        let stiffness = Combination::new(size, [(ONE, kc), (GRAVITY, k0), (SPEED, k1), (SQUARE, k2)]);
        let gravity = units.scale_gravity(gravity);
        let is_loose = |j: usize| {
            let weight = stiffness.term(GRAVITY).filter(|_| gravity != 0.0);
            let others = [ONE, SPEED, SQUARE].map(|function| stiffness.term(function));
            others.into_iter().chain([weight]).flatten().all(|matrix| matrix.column(j).all(|entry| entry == 0.0))
        };
        let (columns, zeros) = columns(&matrices.states, is_loose, &damping);
        let variable = Variable::Speed { gravity };
        let (layout, effort) = (layout(&columns), Cell::new(0));
        let [is_conservative, is_reversible] = symmetries(matrices);
        let mut equations = Self {
            mass,
            damping,
            stiffness,
            variable,
            columns,
            layout,
            solved: None,
            zeros,
            units,
            is_conservative,
            is_reversible,
            effort,
        };
        if !equations.columns.contains(&Column::Position) {
            equations.solved = Some(equations.solve(gravity)?);
        }
        Ok(equations)
    }

    /// Along a parameter: from the coefficients of Chebyshev's polynomials of M, C and K.
    pub(super) fn along_parameter(coefficients: [&[Square<f64>]; 3], states: &[States]) -> Result<Self, SystemError> {
        let size = states.len();
        let largest = coefficients.map(|terms| {
            let size_at = |i: usize, j: usize| terms.iter().fold(0.0, |size: f64, term| size.max(term[i][j].abs()));
            Square::from_fn(size, size_at)
        });
        let zero = || Square::filled(size, 0.0);
        let [m, c, k] = largest;
        let sizes = Matrices { all: [m, zero(), c, zero(), k, zero(), zero(), zero()], states: states.to_vec() };
        let units = Units::new(&sizes, 0.0)?;
        let mut orders = [2, 1, 0].into_iter();
        let [mass, damping, stiffness] = coefficients.map(|terms| {
            let order = orders.next().unwrap_or(0);
            let scaled = terms.iter().enumerate().map(|(k, term)| (k, units.scale_matrix(term, order)));
            Combination::new(size, scaled)
        });
        let (columns, zeros) = columns(states, |j| stiffness.has_zero_column(j), &damping);
        let degree = coefficients.iter().map(|terms| terms.len()).max().unwrap_or(0);
        let (variable, layout) = (Variable::Parameter { degree }, layout(&columns));
        let effort = Cell::new(0);
        Ok(Self {
            mass,
            damping,
            stiffness,
            variable,
            columns,
            layout,
            solved: None,
            zeros,
            units,
            is_conservative: false,
            is_reversible: false,
            effort,
        })
    }

    /// What has to be regular: the columns of M, or of the damping for coordinates of first order.
    pub(super) fn leading(&self, v: f64) -> Square<f64> {
        let values = self.values(v);
        let [m, c] = [&self.mass, &self.damping].map(|matrix| matrix.at(&values));
        Square::from_fn(m.size(), |i, j| if self.columns[j] == Column::Position { c[i][j] } else { m[i][j] })
    }

    /// The transposed state matrix, from a mass matrix that does not depend on the speed.
    fn solve(&self, gravity: f64) -> Result<Combination, SystemError> {
        const FUNCTIONS: [usize; 4] = [OVER_SPEED, ONE, SPEED, SQUARE];
        let size = self.columns.len();
        let term = |combination: &Combination, function: usize| match combination.term(function) {
            Some(matrix) => matrix.map(|entry| -entry),
            None => Square::filled(size, 0.0),
        };
        let mut sides = [&self.damping, &self.stiffness].map(|sum| FUNCTIONS.map(|function| term(sum, function)));
        let static_stiffness = sides[1][ONE].entries_mut().iter_mut();
        static_stiffness.zip(term(&self.stiffness, GRAVITY).entries()).for_each(|(k, k0)| *k += gravity * k0);
        solve(self.mass.at(&self.values(1.0)), sides.as_flattened_mut())?;
        let transposed = |function: usize| {
            let one = if function == ONE { 1.0 } else { 0.0 };
            (function, self.layout.transposed(&sides[1][function], &sides[0][function], one))
        };
        Ok(Combination::new(self.layout.states(), FUNCTIONS.map(transposed)))
    }

    /// Counts what is computed.
    pub(super) fn tally(&self, effort: usize) {
        self.effort.set(self.effort.get() + effort);
    }

    /// Whether so much was computed that the search ends here.
    pub(super) fn is_exhausted(&self) -> bool {
        self.effort.get() >= MOST
    }

    pub(super) fn is_along_speed(&self) -> bool {
        matches!(self.variable, Variable::Speed { .. })
    }

    /// Whether damping is divided by the speed.
    pub(super) fn excludes_rest(&self) -> bool {
        self.is_along_speed() && self.damping.term(OVER_SPEED).is_some()
    }

    /// Whether eigenvalues are algebraic in nothing but the coefficients: then what is made of them symmetrically is a
    /// polynomial in v and 1/v.
    pub(super) fn is_polynomial(&self) -> bool {
        self.solved.is_some()
    }

    /// The number of states.
    pub(super) fn states(&self) -> usize {
        self.layout.states()
    }

    pub(super) fn values<R: RealField>(&self, v: R) -> Values<R> {
        self.variable.values(v)
    }

    /// The eigenvalues at a scaled speed, of the states alone, by the QR algorithm.
    pub(super) fn spectrum(&self, v: f64) -> Result<Spectrum, SystemError> {
        self.tally(1);
        let values = self.values(v);
        let rows = match &self.solved {
            Some(rows) => rows.at(&values),
            None => {
                let [m, c, k] = [&self.mass, &self.damping, &self.stiffness].map(|matrix| matrix.at(&values));
                let is_first_order = |column: usize| self.columns[column] == Column::Position;
                let leading = |i: usize, j: usize| if is_first_order(j) { c[i][j] } else { m[i][j] };
                let leading = Square::from_fn(m.size(), leading);
                let mut sides = [c, k].map(|matrix| matrix.map(|entry| -entry));
                solve(leading, &mut sides)?;
                let [damping, stiffness] = &sides;
                self.layout.transposed(stiffness, damping, 1.0)
            }
        };
        let spectrum = Spectrum::of(rows, self.layout.reduced_columns())?;
        if spectrum.values.iter().any(|value| !value.re.is_finite() || !value.im.is_finite()) {
            return Err(SystemError::OutOfRange { quantity: "an eigenvalue" });
        }
        Ok(spectrum)
    }

    /// A scaled speed in m/s.
    pub(super) fn speed(&self, scaled: DoubleDouble) -> f64 {
        self.units.speed(scaled.to_f64())
    }
}

/// Whether matrices are symmetric and skew so that the equations are conservative, and that they are reversible.
fn symmetries(Matrices { all, .. }: &Matrices) -> [bool; 2] {
    let holds = |matrix: &Square<f64>, sign: f64| {
        (0..matrix.size()).all(|i| (0..=i).all(|j| matrix[i][j] == sign * matrix[j][i]))
    };
    // In the order M, C-1, C0, C1, Kc, K0, K1 and K2.
    let signs = [[1.0, -1.0, -1.0, -1.0, 1.0, 1.0, 1.0, 1.0], [1.0, -1.0, 1.0, -1.0, 1.0, 1.0, -1.0, 1.0]];
    signs.map(|signs| all.iter().zip(signs).all(|(matrix, sign)| holds(matrix, sign)))
}

/// What of each coordinate is a state, and how many eigenvalues are zero everywhere though nobody said so.
fn columns(states: &[States], is_loose: impl Fn(usize) -> bool, damping: &Combination) -> (Vec<Column>, usize) {
    let mut zeros = 0;
    let column = |(j, states): (usize, &States)| match states {
        States::Position => Column::Position,
        declared => {
            zeros += usize::from(*declared == States::Both && is_loose(j));
            if !is_loose(j) {
                Column::Both
            } else if damping.has_zero_column(j) {
                zeros += 1;
                Column::Neither
            } else {
                Column::Rate
            }
        }
    };
    (states.iter().enumerate().map(column).collect(), zeros)
}

fn layout(columns: &[Column]) -> Layout {
    let has = |column: &Column, with: Column| *column == Column::Both || *column == with;
    Layout::new(columns.iter().map(|column| [Column::Position, Column::Rate].map(|with| has(column, with))))
}
