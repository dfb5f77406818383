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
    /// Adds equations, each to be solved for one of the unknowns that it `may` be solved for. `name` makes a name for an
    /// entry of the unknown that its equation is solved for. Returns what is left of equations that have no such unknown,
    /// with their positions.
    ///
    /// An unknown that few others of the equations hold comes first (Markowitz), then one with a simple factor: so the
    /// joint of a single wheel is what that wheel determines, and no wheel divides by its distance from another one that
    /// may be beside it.
    pub fn add(
        &mut self,
        rows: Vec<(Row, &[usize])>,
        formulas: &mut Formulas<'_>,
        name: impl Fn(usize, usize) -> String,
    ) -> Vec<(usize, Row)> {
        let mut open: Vec<(usize, Row, &[usize])> = Vec::new();
        for (position, (mut row, may)) in rows.into_iter().enumerate() {
            for (unknown, known) in &self.rows {
                let factor = row[*unknown].clone();
                add(&mut row, &factor, known);
            }
            open.push((position, row, may));
        }
        while let Some((equation, pivot)) = best(&open, formulas) {
            let (_, mut row, _) = open.remove(equation);
            // In the words of the model: where it is zero there is no value, and that must be said.
            let divisor = -&formulas.opened(&row[pivot]);
            for (column, entry) in row.iter_mut().enumerate() {
                let solved = if column == pivot { Form::number(-1) } else { entry.over(&divisor) };
                *entry = formulas.name(name(pivot, column), &solved);
            }
            for (_, other, _) in &mut open {
                let factor = other[pivot].clone();
                add(other, &factor, &row);
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
        }
        open.into_iter().map(|(position, row, _)| (position, row)).collect()
    }

    /// What is known of an unknown.
    pub fn get(&self, unknown: usize) -> Option<&Row> {
        self.rows.iter().find(|(known, _)| *known == unknown).map(|(_, row)| row)
    }
}

/// The next equation to be solved, and the unknown it is solved for.
fn best(open: &[(usize, Row, &[usize])], formulas: &Formulas<'_>) -> Option<(usize, usize)> {
    let holders = |unknown: usize| open.iter().filter(|(_, row, _)| !row[unknown].is_nothing()).count();
    let candidates = open.iter().enumerate().flat_map(|(equation, (_, row, may))| {
        let divisors = may.iter().copied().filter(|unknown| formulas.is_divisor(&row[*unknown]));
        divisors.map(move |unknown| (equation, unknown, row[unknown].operations()))
    });
    let best = candidates.min_by_key(|(_, unknown, operations)| (holders(*unknown), *operations));
    best.map(|(equation, unknown, _)| (equation, unknown))
}

fn add(row: &mut Row, factor: &Form, other: &Row) {
    if factor.is_nothing() {
        return;
    }
    for (entry, other) in row.iter_mut().zip(other) {
        *entry = (&*entry + &(factor * other)).simplest();
    }
}
