//! How much of each mode inputs excite, and outputs show.

use carvallo::{Complex, States};
use carvallo_design::number::shortest;
use carvallo_design::{Design, Failure, Place, Shape};

use crate::ports::{Output, Ports};
use crate::state_space::StateSpace;

/// Of one mode: by its left eigenvector w and its right eigenvector x, in the states of the state space, in SI units.
///
/// A mode of a simple eigenvalue is out of reach of an input, and the test of Popov, Belevitch and Hautus fails, exactly where
/// `w^H b` is zero; and an output tells nothing of it where `c x` is. The cosines say how far from that it is (Hamdan & Nayfeh
/// 1989, Journal of Guidance, Control, and Dynamics 12, 421-428); they depend on the units of states.
#[derive(Clone, Debug, PartialEq)]
pub struct ModalMeasures {
    /// In 1/s.
    pub eigenvalue: Complex<f64>,
    /// `|w^H b| / (|w| |b|)` of each input, from 0 to 1.
    pub controllability: Vec<f64>,
    /// `|c x| / (|c| |x|)` of each output, from 0 to 1.
    pub observability: Vec<f64>,
    /// `w^H b` of each input, by how much an impulse excites the mode, with `w^H x = 1` where the eigenvalue is simple.
    pub excitation: Vec<Complex<f64>>,
    /// `c x` of each output, where the largest of the coordinates in x is 1.
    pub share: Vec<Complex<f64>>,
}

/// The modes of a design at speeds, between inputs and outputs.
#[derive(Clone, Debug)]
pub struct ModalAnalysis<'a> {
    design: &'a Design,
    inputs: Vec<usize>,
    outputs: Vec<Output>,
    states: Vec<States>,
}

impl<'a> ModalAnalysis<'a> {
    /// Between some of the [inputs](Ports::inputs) of a design, by their places, and outputs.
    pub fn new(design: &'a Design, inputs: Vec<usize>, outputs: Vec<Output>) -> Self {
        Self { design, inputs, outputs, states: Ports::of(design).states }
    }

    /// The measures of the modes of given eigenvalues, in any order, at a speed in m/s; in the same order.
    ///
    /// # Errors
    /// If there are no equations of motion at the speed, if an output is the integral of its rate, or if an eigenvector leaves the
    /// range of doubles.
    pub fn at(&self, speed: f64, eigenvalues: &[Complex<f64>]) -> Result<Vec<ModalMeasures>, Failure> {
        let space = StateSpace::new(self.design, speed, &self.inputs, &self.outputs)?;
        if let Some(integral) = space.states.get(self.count()) {
            let message = format!("`{0}` is an integral, which no mode is of; its rate is `{0}_rate`", integral.name);
            return Err(Failure::at(Place::Option(format!("--outputs {}", integral.name)), message));
        }
        let gravity = self.design.gravity().unwrap_or(0.0);
        let fail = |error| Failure::Run(format!("{} at {} m/s: {error}", self.design.title(), shortest(speed)));
        let shapes = self.design.equations.eigenvectors(speed, gravity, eigenvalues).map_err(fail)?;
        let leading = self.leading(self.design.equations.system(speed, gravity).map_err(fail)?);
        let measures = eigenvalues.iter().zip(&shapes);
        Ok(measures.map(|(&eigenvalue, shape)| self.measures(&space, &leading, eigenvalue, shape)).collect())
    }

    /// How many states there are without integrals.
    fn count(&self) -> usize {
        self.states.iter().map(|states| if *states == States::Both { 2 } else { 1 }).sum()
    }

    /// What multiplies the highest derivatives, row by row: M, with columns of C for coordinates of first order.
    fn leading(&self, [m, c, _]: [Vec<f64>; 3]) -> Vec<f64> {
        let count = self.states.len();
        let of = |(place, mass): (usize, f64)| {
            if self.states[place % count] == States::Position { c[place] } else { mass }
        };
        m.into_iter().enumerate().map(of).collect()
    }

    fn measures(&self, space: &StateSpace, leading: &[f64], eigenvalue: Complex<f64>, shape: &Shape) -> ModalMeasures {
        let (left, right) = (self.left(space, leading, eigenvalue, shape), self.right(eigenvalue, shape));
        let along = |entries: &mut dyn Iterator<Item = &f64>, vector: &[Complex<f64>]| -> Complex<f64> {
            entries.zip(vector).map(|(entry, part)| part * *entry).sum()
        };
        let norm = |vector: &[Complex<f64>]| vector.iter().map(Complex::norm_sqr).sum::<f64>().sqrt();
        let cosine = |value: Complex<f64>, sizes: f64| if sizes > 0.0 { (value.norm() / sizes).min(1.0) } else { 0.0 };
        let excitation: Vec<Complex<f64>> =
            space.b.column_iter().map(|column| along(&mut column.iter(), &left)).collect();
        let share: Vec<Complex<f64>> = space.c.row_iter().map(|row| along(&mut row.iter(), &right)).collect();
        let of_inputs = excitation.iter().zip(space.b.column_iter());
        let of_outputs = share.iter().zip(space.c.row_iter());
        ModalMeasures {
            eigenvalue,
            controllability: of_inputs.map(|(value, b)| cosine(*value, norm(&left) * b.norm())).collect(),
            observability: of_outputs.map(|(value, c)| cosine(*value, norm(&right) * c.norm())).collect(),
            excitation,
            share,
        }
    }

    /// The states of the mode: a position and its rate, or the one of them that is a state.
    fn right(&self, eigenvalue: Complex<f64>, shape: &Shape) -> Vec<Complex<f64>> {
        let parts = || self.states.iter().zip(&shape.right);
        let positions = parts().filter(|(states, _)| **states != States::Rate).map(|(_, part)| *part);
        let rates = parts().filter(|(states, _)| **states != States::Position).map(|(states, part)| match states {
            States::Both => eigenvalue * part,
            _ => *part,
        });
        positions.chain(rates).collect()
    }

    /// The conjugate of w, of which `w^H A = s w^H`: in the rows that are solved equations of motion it is y^H times what is
    /// solved for there, and the columns of rates say what it is at positions.
    fn left(&self, space: &StateSpace, leading: &[f64], eigenvalue: Complex<f64>, shape: &Shape) -> Vec<Complex<f64>> {
        let count = self.states.len();
        let solved: Vec<Complex<f64>> = (0..count)
            .map(|column| (0..count).map(|row| shape.left[row].conj() * leading[row * count + column]).sum())
            .collect();
        let positions: Vec<usize> = (0..count).filter(|&place| self.states[place] != States::Rate).collect();
        let rates: Vec<usize> = (0..count).filter(|&place| self.states[place] != States::Position).collect();
        // The rows of A that are solved, each with its part.
        let of_positions = positions.iter().enumerate().filter(|(_, place)| self.states[**place] == States::Position);
        let of_rates = rates.iter().enumerate().map(|(row, place)| (positions.len() + row, place));
        let rows: Vec<(usize, Complex<f64>)> =
            of_positions.chain(of_rates).map(|(row, place)| (row, solved[*place])).collect();
        let mut left = vec![Complex::new(0.0, 0.0); space.states.len()];
        rows.iter().for_each(|&(row, part)| left[row] = part);
        for (row, place) in positions.iter().enumerate().filter(|(_, place)| self.states[**place] == States::Both) {
            let column = positions.len() + rates.iter().position(|rate| rate == place).unwrap_or(0);
            let returned: Complex<f64> = rows.iter().map(|&(row, part)| part * space.a[(row, column)]).sum();
            left[row] = eigenvalue * solved[*place] - returned;
        }
        left
    }
}
