//! Files that give matrices instead of parameters: `"M": [[…, …], […, …]]`.

use carvallo::MatrixName;

use super::document::{Document, Entry, Written};
use crate::failure::Place;
use crate::matrices::{MATRICES, names as entry_names};
use crate::model::Shipped;
use crate::nearest::nearest;

/// A list as it was written, or what stands in the place of one.
pub type Rows = Vec<Vec<Written>>;

/// The matrix of a name: `C1` by `C1` and `C_1`.
pub fn name(name: &str) -> Option<MatrixName> {
    let short = name.replace('_', "");
    MatrixName::ALL.into_iter().find(|matrix| matrix.to_string() == short)
}

impl Document {
    /// Takes a matrix by its entries.
    pub fn take_matrix(&mut self, matrix: MatrixName, place: &Place, rows: Option<Rows>) {
        let entries: Option<Vec<Written>> = rows.and_then(|rows| {
            let is_two = rows.len() == 2 && rows.iter().all(|row| row.len() == 2);
            is_two.then(|| rows.into_iter().flatten().collect())
        });
        let Some(entries) = entries else {
            return self.problem(place.clone(), format!("`{matrix}` must have two rows of two numbers"));
        };
        for (name, value) in entry_names(matrix).into_iter().zip(entries) {
            self.entries.push(Entry { name: name.to_owned(), place: place.clone(), value, deviation: None });
        }
    }

    /// Chooses the model for the matrices, if there are any: what is not given of them is zero.
    pub fn finish_matrices(&mut self) {
        let has = |matrix: MatrixName| {
            let [first, ..] = entry_names(matrix);
            self.entries.iter().any(|entry| entry.name == first)
        };
        let given = MatrixName::ALL.map(|matrix| (matrix, has(matrix)));
        let is_any = given.iter().any(|(_, is_given)| *is_given);
        if !is_any {
            return;
        }
        self.refuse_other_arrays();
        if self.model.is_some() {
            return;
        }
        let holds =
            |model: &&Shipped| given.iter().all(|(matrix, is_given)| !is_given || model.info.matrices.contains(matrix));
        let Some(model) = MATRICES.into_iter().find(holds) else { return };
        self.model = Some(model.info.name.to_owned());
        let place = self.entries[0].place.clone();
        let absent = given.iter().filter(|(matrix, is_given)| !is_given && model.info.matrices.contains(matrix));
        for (matrix, _) in absent.filter(|(matrix, _)| *matrix != MatrixName::M) {
            let zero = || vec![vec![Written::Text("0".to_owned()), Written::Text("0".to_owned())]; 2];
            self.take_matrix(*matrix, &place, Some(zero()));
        }
    }

    /// A matrix under a name that is none would become zero, and so would one that is no array.
    fn refuse_other_arrays(&mut self) {
        let is_matrix =
            |entry: &mut Entry| matches!(entry.value, Written::Other("an array")) || name(&entry.name).is_some();
        for Entry { name: found, place, .. } in self.entries.extract_if(.., is_matrix).collect::<Vec<_>>() {
            if let Some(matrix) = name(&found) {
                self.take_matrix(matrix, &place, None);
                continue;
            }
            let names = MatrixName::ALL.map(|matrix| matrix.to_string());
            let hint = nearest(&found, names.iter().map(String::as_str));
            let hint = hint.map(|name| format!("; did you mean `{name}`?")).unwrap_or_default();
            self.problem(place, format!("`{found}` is no matrix; expected `{}`{hint}", names.join("`, `")));
        }
    }
}
