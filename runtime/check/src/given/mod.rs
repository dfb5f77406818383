//! What somebody has computed of a machine.

mod contradictions;
mod reading;

use carvallo::{MatrixName, ModelInfo};
use carvallo_slips::{entry_name, indices};

pub use self::contradictions::contradictions;
pub use self::reading::{Reading, level};

/// Numbers that somebody has of a machine: any of them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Given {
    /// Matrices of the equations of motion, by their rows.
    pub matrices: Vec<(MatrixName, Rows)>,
    /// Matrices C and K of `M q'' + C q' + K q = f` at speeds.
    pub system_matrices: Vec<SystemMatrix>,
    /// Matrices A of `x' = A x` at speeds.
    pub state_matrices: Vec<StateMatrix>,
    /// Eigenvalues at speeds.
    pub eigenvalues: Vec<Eigenvalues>,
    /// Critical speeds in m/s.
    pub critical_speeds: Vec<CriticalSpeed>,
    /// Accelerations in states of motion.
    pub accelerations: Vec<Accelerations>,
    /// What is said not to be known, beside entries of matrices that are left out.
    pub unknown: Vec<String>,
}

/// The rows of a matrix; entries that are not known are left out.
pub type Rows = Vec<Vec<Option<Reading>>>;

/// The matrix C or K of `M q'' + C q' + K q = f` at a speed, with gravity and speed in it.
#[derive(Clone, Debug, PartialEq)]
pub struct SystemMatrix {
    /// In m/s.
    pub speed: f64,
    /// Whether it is K, and not C.
    pub is_stiffness: bool,
    /// With as many rows and columns as there are coordinates.
    pub rows: Rows,
}

/// The matrix A of `x' = A x` at a speed.
#[derive(Clone, Debug, PartialEq)]
pub struct StateMatrix {
    /// In m/s.
    pub speed: f64,
    /// With as many rows and columns as there are states, in any of the usual orders.
    pub rows: Rows,
}

/// Eigenvalues at a speed, all or some of them, in any order.
#[derive(Clone, Debug, PartialEq)]
pub struct Eigenvalues {
    /// In m/s.
    pub speed: f64,
    /// The real part, and the imaginary one where it is known, in 1/s.
    pub values: Vec<(Reading, Option<Reading>)>,
}

/// A critical speed.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalSpeed {
    /// What happens there; `None` where only the speed is known.
    pub kind: Option<carvallo::CriticalKind>,
    /// What it was called.
    pub name: String,
    /// In m/s.
    pub speed: Reading,
}

/// Equations that accelerations come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Those of first order about straight motion.
    Linear,
    /// The exact ones of the mechanism.
    Nonlinear,
}

/// Accelerations of coordinates in a state of motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Accelerations {
    /// By which equations; `None` where those are meant that come nearer.
    pub equations: Option<Kind>,
    /// In m/s.
    pub speed: f64,
    /// Of each coordinate, in its unit.
    pub positions: Vec<f64>,
    /// Of each coordinate, by second.
    pub rates: Vec<f64>,
    /// Of each coordinate.
    pub forces: Vec<f64>,
    /// Of each coordinate, where it is known.
    pub values: Vec<Option<Reading>>,
}

/// What a number is of. Rows, columns and others count from zero.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// An entry of a matrix.
    Entry(MatrixName, usize, usize),
    /// An entry of the damping or stiffness at a speed: which one, row, column.
    System(usize, usize, usize),
    /// An entry of a state matrix: which one, row, column.
    State(usize, usize, usize),
    /// The real part of an eigenvalue: of which set, which one.
    RealPart(usize, usize),
    /// The imaginary part.
    ImaginaryPart(usize, usize),
    /// A critical speed.
    CriticalSpeed(usize),
    /// An acceleration: in which state, of which coordinate.
    Acceleration(usize, usize),
}

impl Given {
    /// All numbers one after the other, those of matrices first.
    pub fn numbers(&self) -> Vec<(Quantity, &Reading)> {
        let mut numbers = Vec::new();
        for (matrix, rows) in &self.matrices {
            numbers.extend(entries(rows).map(|(row, column, entry)| (Quantity::Entry(*matrix, row, column), entry)));
        }
        for (at, system) in self.system_matrices.iter().enumerate() {
            let entries = entries(&system.rows);
            numbers.extend(entries.map(|(row, column, entry)| (Quantity::System(at, row, column), entry)));
        }
        for (at, state) in self.state_matrices.iter().enumerate() {
            let entries = entries(&state.rows);
            numbers.extend(entries.map(|(row, column, entry)| (Quantity::State(at, row, column), entry)));
        }
        for (at, eigenvalues) in self.eigenvalues.iter().enumerate() {
            for (index, (re, im)) in eigenvalues.values.iter().enumerate() {
                numbers.push((Quantity::RealPart(at, index), re));
                numbers.extend(im.iter().map(|im| (Quantity::ImaginaryPart(at, index), im)));
            }
        }
        let critical = self.critical_speeds.iter().enumerate();
        numbers.extend(critical.map(|(at, critical)| (Quantity::CriticalSpeed(at), &critical.speed)));
        for (at, accelerations) in self.accelerations.iter().enumerate() {
            let known = accelerations.values.iter().enumerate();
            numbers.extend(known.filter_map(|(of, value)| Some((Quantity::Acceleration(at, of), value.as_ref()?))));
        }
        numbers
    }

    /// What is not known, by its names: entries of matrices, then all others.
    pub fn unknown(&self, info: &ModelInfo) -> Vec<String> {
        let matrices = self
            .matrices
            .iter()
            .flat_map(|(matrix, rows)| left_out(rows).map(move |(row, column)| Quantity::Entry(*matrix, row, column)));
        let systems = self
            .system_matrices
            .iter()
            .enumerate()
            .flat_map(|(at, own)| left_out(&own.rows).map(move |(row, column)| Quantity::System(at, row, column)));
        let states = self
            .state_matrices
            .iter()
            .enumerate()
            .flat_map(|(at, own)| left_out(&own.rows).map(move |(row, column)| Quantity::State(at, row, column)));
        let entries = matrices.chain(systems).chain(states).map(|own| self.name(own, info));
        entries.chain(self.unknown.iter().cloned()).collect()
    }

    /// The speeds in m/s that numbers are of, each once.
    pub fn speeds(&self) -> Vec<f64> {
        let mut all: Vec<f64> = self.system_matrices.iter().map(|own| own.speed).collect();
        all.extend(self.state_matrices.iter().map(|own| own.speed));
        all.extend(self.eigenvalues.iter().map(|own| own.speed));
        all.extend(self.accelerations.iter().map(|own| own.speed));
        all.sort_by(f64::total_cmp);
        all.dedup();
        all
    }

    /// Lets each number be changed, in the order of [`Self::numbers`].
    pub fn each_reading(&mut self, change: &mut dyn FnMut(&mut Reading)) {
        let rows = self.matrices.iter_mut().map(|(_, rows)| rows);
        let rows = rows.chain(self.system_matrices.iter_mut().map(|own| &mut own.rows));
        let rows = rows.chain(self.state_matrices.iter_mut().map(|own| &mut own.rows));
        rows.flatten().flatten().flatten().for_each(&mut *change);
        for (re, im) in self.eigenvalues.iter_mut().flat_map(|own| &mut own.values) {
            change(re);
            im.iter_mut().for_each(&mut *change);
        }
        self.critical_speeds.iter_mut().for_each(|own| change(&mut own.speed));
        self.accelerations.iter_mut().flat_map(|own| &mut own.values).flatten().for_each(change);
    }

    /// The same with those numbers cut off, not rounded, that are chosen by their place in [`Self::numbers`].
    pub fn cut_off(&self, is_cut: &mut dyn FnMut(usize) -> bool) -> Self {
        let mut own = self.clone();
        let mut place = 0;
        own.each_reading(&mut |reading| {
            if let Some(cut) = reading.cut_off().filter(|_| is_cut(place)) {
                *reading = cut;
            }
            place += 1;
        });
        own
    }

    /// The same with every number so that it agrees with whatever it agrees with rounded or cut off.
    pub fn in_any_way(&self) -> Self {
        let mut own = self.clone();
        own.each_reading(&mut |reading| {
            if let Some(cut) = reading.cut_off() {
                let value = (reading.value + cut.value) / 2.0;
                *reading = Reading { value, tolerance: 2.0 * reading.tolerance, ..cut };
            }
        });
        own
    }

    /// What a state matrix is called: `A at 5 m/s`, or `A no. 2 at 5 m/s` where several are of one speed.
    pub fn state_name(&self, at: usize) -> String {
        let speed = self.state_matrices[at].speed;
        let of_speed = self.state_matrices.iter().filter(|own| own.speed == speed).count();
        let which = if of_speed > 1 { format!(" no. {}", at + 1) } else { String::new() };
        format!("A{which} at {speed} m/s")
    }

    /// What a number is called: `M_12`, or `Re s2 at 5 m/s`.
    pub fn name(&self, quantity: Quantity, info: &ModelInfo) -> String {
        let part = |part: &str, at: usize, index: usize| {
            format!("{part} s{} at {} m/s", index + 1, self.eigenvalues[at].speed)
        };
        match quantity {
            Quantity::Entry(matrix, row, column) => entry_name(matrix, row, column),
            Quantity::System(at, row, column) => {
                let own = &self.system_matrices[at];
                let letter = if own.is_stiffness { "K" } else { "C" };
                format!("{letter}{} at {} m/s", indices(row, column), own.speed)
            }
            Quantity::State(at, row, column) => {
                let (own, entry) = (self.state_name(at), format!("A{}", indices(row, column)));
                if own.starts_with("A no.") { format!("{entry} of {own}") } else { own.replacen('A', &entry, 1) }
            }
            Quantity::RealPart(at, index) => part("Re", at, index),
            Quantity::ImaginaryPart(at, index) => part("Im", at, index),
            Quantity::CriticalSpeed(at) => self.critical_speeds[at].name.clone(),
            Quantity::Acceleration(at, of) => {
                let speed = self.accelerations[at].speed;
                format!("{}'' in state {} at {speed} m/s", info.coordinates[of].name, at + 1)
            }
        }
    }
}

/// The places of entries that are not known.
fn left_out(rows: &Rows) -> impl Iterator<Item = (usize, usize)> {
    let of_row = |(row, entries): (usize, &Vec<Option<Reading>>)| -> Vec<(usize, usize)> {
        (0..entries.len()).filter(|column| entries[*column].is_none()).map(|column| (row, column)).collect()
    };
    rows.iter().enumerate().flat_map(of_row)
}

fn entries(rows: &Rows) -> impl Iterator<Item = (usize, usize, &Reading)> {
    rows.iter().enumerate().flat_map(|(row, entries)| {
        entries.iter().enumerate().filter_map(move |(column, entry)| Some((row, column, entry.as_ref()?)))
    })
}

impl Given {
    /// Whether a model has what the numbers are of.
    ///
    /// # Errors
    /// What does not fit: matrices with other than as many rows and columns as there are coordinates or states.
    pub fn fits(&self, info: &ModelInfo) -> Result<(), String> {
        if self.numbers().is_empty() {
            return Err("there are no numbers to check".to_owned());
        }
        let square = |name: &str, rows: &Rows, count: usize, of: &str| {
            let columns = rows.iter().map(Vec::len).enumerate().find(|(_, columns)| *columns != count);
            match (rows.len(), columns) {
                (found, None) if found == count => Ok(()),
                (_, Some((row, found))) => {
                    let is_each = rows.iter().all(|own| own.len() == found);
                    let which = if is_each { "a row".to_owned() } else { format!("row {}", row + 1) };
                    let s = if found == 1 { "" } else { "s" };
                    Err(format!("{which} of {name} has {found} number{s}; expected {count}, one for each {of}"))
                }
                (found, None) => Err(format!("{name} has {found} rows; expected {count}, one for each {of}")),
            }
        };
        let (coordinates, states) = (info.coordinates.len(), crate::states::states(info).len());
        self.matrices.iter().try_for_each(|(name, rows)| square(name.name(), rows, coordinates, "coordinate"))?;
        let system =
            |own: &SystemMatrix| square(if own.is_stiffness { "K" } else { "C" }, &own.rows, coordinates, "coordinate");
        self.system_matrices.iter().try_for_each(system)?;
        let state = |own: &StateMatrix| {
            square("A", &own.rows, states, "state").map_err(|found| format!("{found}: {}", crate::states::words(info)))
        };
        self.state_matrices.iter().try_for_each(state)?;
        for Eigenvalues { speed, values } in &self.eigenvalues {
            let count = values.len();
            if count > states {
                return Err(format!("there are {count} eigenvalues at {speed} m/s; the model has {states}"));
            }
        }
        Ok(())
    }
}
