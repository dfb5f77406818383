//! Linear equations in formulas, solved for some of their unknowns.

use super::formulas::Formulas;
use crate::symbolic::Form;

/// An equation: the sum of its entries, each times its unknown, is zero.
pub type Row = Vec<Form>;

/// Equations, each solved for an unknown that occurs in no other one.
#[derive(Clone, Default)]
pub struct Solved {
    /// Each with its unknown, whose own entry is -1: the others say what it is.
    pub rows: Vec<(usize, Row)>,
}

impl Solved {
    /// Adds an equation, to be solved for one of the unknowns that `may` be eliminated, the first ones if there is a
    /// choice of equally simple ones. `name` makes a name for an entry of the unknown it is solved for.
    ///
    /// # Errors
    /// What is left of the equation if it holds none of these unknowns.
    pub fn add(
        &mut self,
        mut row: Row,
        may: &[usize],
        formulas: &mut Formulas<'_>,
        name: impl Fn(usize, usize) -> String,
    ) -> Result<(), Row> {
        for (unknown, known) in &self.rows {
            let factor = row[*unknown].clone();
            add(&mut row, &factor, known);
        }
        let candidates = may.iter().copied().filter(|unknown| formulas.is_divisor(&row[*unknown]));
        let Some(pivot) = candidates.min_by_key(|unknown| row[*unknown].operations()) else {
            return Err(row);
        };
        let divisor = -&row[pivot];
        for (column, entry) in row.iter_mut().enumerate() {
            let solved = if column == pivot { Form::number(-1) } else { entry.over(&divisor) };
            *entry = formulas.name(name(pivot, column), &solved);
        }
        for (unknown, known) in &mut self.rows {
            let factor = known[pivot].clone();
            if factor.is_nothing() {
                continue;
            }
            add(known, &factor, &row);
            for (column, entry) in known.iter_mut().enumerate() {
                *entry = formulas.name(name(*unknown, column), entry);
            }
        }
        self.rows.push((pivot, row));
        Ok(())
    }
}

fn add(row: &mut Row, factor: &Form, other: &Row) {
    if factor.is_nothing() {
        return;
    }
    for (entry, other) in row.iter_mut().zip(other) {
        *entry = (&*entry + &(factor * other)).simplest();
    }
}
