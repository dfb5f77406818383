//! Branches of eigenvalues that are shown together: those that are pairs at some speed.

use carvallo::{Mode, ModeValue, sort_by};

use crate::analysis::{Eigenvalues, Row};

/// Some branches, two of a pair or one that is always real, or more where pairs part and others form.
pub struct Strand {
    /// Ascending.
    pub branches: Vec<usize>,
    /// Their names, each once, as far as they have any at the speeds of the rows.
    pub modes: Vec<Mode>,
    /// What it is called: by the names, or by a number.
    pub title: String,
}

/// All strands, in the order of their first branches.
pub fn strands(rows: &[Row<Eigenvalues>]) -> Vec<Strand> {
    let count = rows.first().map_or(0, |row| row.values.values.len());
    // The first branch of the strand that each belongs to.
    let mut heads: Vec<usize> = (0..count).collect();
    for Row { values, .. } in rows {
        for (branch, value) in values.values.iter().enumerate() {
            if let Some(other) = partner(&values.values, value) {
                let (one, two) = (heads[branch].min(heads[other]), heads[branch].max(heads[other]));
                heads.iter_mut().filter(|head| **head == two).for_each(|head| *head = one);
            }
        }
    }
    let mut firsts = heads.clone();
    sort_by(&mut firsts, usize::cmp);
    firsts.dedup();
    let strand = |(number, first): (usize, usize)| {
        let branches: Vec<usize> = (0..count).filter(|&branch| heads[branch] == first).collect();
        let all = rows.iter().flat_map(|row| branches.iter().map(|&branch| row.values.values[branch].mode));
        let mut modes: Vec<Mode> = all.filter(|mode| !matches!(mode, Mode::Real | Mode::Oscillatory)).collect();
        sort_by(&mut modes, Mode::cmp);
        modes.dedup();
        let names: Vec<String> = modes.iter().map(ToString::to_string).collect();
        let title = if names.is_empty() { format!("mode {}", number + 1) } else { names.join("/") };
        Strand { branches, modes, title }
    };
    firsts.into_iter().enumerate().map(strand).collect()
}

/// The branch of the conjugate of an eigenvalue with a positive imaginary part, unless another one is at the same place.
fn partner(values: &[ModeValue], ModeValue { value, .. }: &ModeValue) -> Option<usize> {
    let is_conjugate = |other: &ModeValue| other.value.re == value.re && other.value.im == -value.im;
    let mut places = (0..values.len()).filter(|&place| value.im > 0.0 && is_conjugate(&values[place]));
    let first = places.next();
    first.filter(|_| places.next().is_none())
}
