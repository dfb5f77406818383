//! Files that give matrices in the place of parameters: `"M": [[…, …], […, …]]`.

mod coordinates;
mod names;
mod shape;
mod text;

use carvallo::MatrixName;

use self::names::{COORDINATES, entry, is_plain, matrix, no_matrix};
use self::shape::{Given, Row, shape};
use super::document::{Document, Entry, Written};
use super::names::is_gravity;
use super::tables::{Named, Node, Value, Words};
use crate::failure::Place;
use crate::matrices::{Form, MOST, NAME, is_called};

pub use self::names::{matrix_of_rows, unknown};
pub use self::text::{is_open, list};

/// Whether a name of a file is for matrices: a matrix by its rows, unless parameters are in a group of their own, or what the
/// coordinates are.
pub fn is_part(name: &str, value: &Value, has_parameters: bool) -> bool {
    let Value::List(list) = value else { return name == COORDINATES };
    let has_rows = list.iter().any(|row| matches!(row.value, Value::List(_)));
    name == COORDINATES || !has_parameters && is_named(name, has_rows)
}

/// Whether a text under a name is a matrix, as scripts have it, or the names of the coordinates.
pub fn is_text(name: &str, text: &str) -> bool {
    text::is_list(text) && (name == COORDINATES || is_named(name, text::has_rows(text)))
}

/// Whether a list is a matrix by its name: one in lower case may be a parameter, measured several times, unless it has rows.
fn is_named(name: &str, has_rows: bool) -> bool {
    matrix(name).is_some() || has_rows && matrix_of_rows(name).is_some()
}

impl Document {
    /// Takes a matrix from the text of its rows, each at the place that belongs to the number of lines before it.
    pub fn take_matrix_text(&mut self, name: &str, text: &str, place: &dyn Fn(usize) -> Place) {
        let Some(mut value) = text::list(text, place) else {
            let message =
                format!("`{name}` cannot be read; expected a list of rows, such as [[1, 0], [0, 1]] or [1 0; 0 1]");
            return self.problem(place(0), message);
        };
        if let (COORDINATES, Value::List(rows)) = (name, &mut value)
            && rows.len() == 1
        {
            value = rows.remove(0).value;
        }
        self.parts.push(Named { name: name.to_owned(), node: Node { place: place(0), value } });
    }

    /// Takes the matrices, if there are any, for parameters of a model of their own.
    pub fn finish_matrices(&mut self, words: &Words) {
        let parts = std::mem::take(&mut self.parts);
        let is_named = self.model.as_deref().is_some_and(is_called);
        let (coordinates, lists): (Vec<Named>, Vec<Named>) =
            parts.into_iter().partition(|part| part.name == COORDINATES);
        if lists.is_empty() && !is_named && !self.has_only_numbers_for_matrices() {
            for Named { name, node } in coordinates {
                self.entries.push(Entry::new(name, node.place, node.value.written(words), None));
            }
            return;
        }
        self.model.get_or_insert_with(|| NAME.to_owned());
        let mut given = Vec::new();
        for Named { name, node: Node { place, value } } in lists {
            if let Value::List(rows) = value
                && let Some(matrix) = matrix_of_rows(&name)
                && self.is_new(matrix, &name, &place, &given)
            {
                let rows = self.rows_of(matrix, rows, words);
                given.push(Given { matrix, place, rows });
            }
        }
        // Of one coordinate a number will do; among others it has no rows.
        let is_matrix = |entry: &mut Entry| matrix(&entry.name).is_some();
        for entry in self.entries.extract_if(.., is_matrix).collect::<Vec<_>>() {
            let place = entry.place.clone();
            if let Some(matrix) = matrix(&entry.name)
                && self.is_new(matrix, &entry.name, &place, &given)
            {
                let rows = Ok(vec![Row { place: place.clone(), entries: vec![entry] }]);
                given.push(Given { matrix, place, rows });
            }
        }
        self.refuse_other_lists();
        let written: Vec<_> = self.entries.iter().filter_map(|own| entry(&own.name)).filter(|_| is_named).collect();
        let Some(count) = self.count(&given, &written) else { return };
        let has = |name: MatrixName| {
            given.iter().any(|given| given.matrix == name) || written.iter().any(|(matrix, ..)| *matrix == name)
        };
        let matrices = MatrixName::ALL.into_iter().filter(|name| *name == MatrixName::M || has(*name)).collect();
        self.form = Some(Form { matrices, coordinates: coordinates::of(self, coordinates, count) });
        for given in given {
            self.take_entries(given, count);
        }
    }

    /// Whether these can be matrices of one coordinate, each a number.
    fn has_only_numbers_for_matrices(&self) -> bool {
        let is_m = |entry: &Entry| matrix(&entry.name) == Some(MatrixName::M);
        let is_one = |entry: &Entry| matrix(&entry.name).is_some() || is_gravity(&entry.name);
        self.model.is_none() && self.entries.iter().any(is_m) && self.entries.iter().all(is_one)
    }

    /// Whether a matrix is not given already; if it has another name in the file, that is told.
    fn is_new(&mut self, matrix: MatrixName, name: &str, place: &Place, given: &[Given]) -> bool {
        if let Some(Given { place: first, .. }) = given.iter().find(|given| given.matrix == matrix) {
            let which = if name == matrix.to_string() { "" } else { &format!(" is `{matrix}`, which") };
            self.problem(place.clone(), format!("`{name}`{which} is given twice; first at {first}"));
            return false;
        }
        if is_plain(name) {
            let why = "which depends on neither gravity nor speed";
            self.notes.push(format!("{place}: `{name}` is taken for `{matrix}`, {why}"));
        } else if matrix_of_rows(name) != names::matrix(name) {
            self.notes.push(format!("{place}: `{name}` is taken for `{matrix}`, as it has rows"));
        }
        true
    }

    /// An array that is no matrix under any name would be lost.
    fn refuse_other_lists(&mut self) {
        let is_list = |entry: &mut Entry| matches!(entry.value, Written::Other("an array"));
        for Entry { name, place, .. } in self.entries.extract_if(.., is_list).collect::<Vec<_>>() {
            self.problem(place, no_matrix(&name));
        }
    }

    /// How many coordinates there are: M has a row for each. Without rows of M that is a problem, and another matrix tells.
    fn count(&mut self, given: &[Given], written: &[(MatrixName, usize, usize)]) -> Option<usize> {
        let by_entries = written.iter().map(|(_, row, column)| *row.max(column)).max();
        let rows = |given: &Given| given.rows.as_ref().ok().map(Vec::len).filter(|rows| *rows > 0);
        let mass = given.iter().find(|given| given.matrix == MatrixName::M);
        let count = mass.and_then(rows).or(by_entries).or_else(|| given.iter().find_map(rows));
        let Some(first) = given.first() else { return by_entries };
        let place = mass.unwrap_or(first).place.clone();
        match count {
            Some(count) if count > MOST => {
                self.problem(place, format!("there are {count} coordinates; there may be at most {MOST}"));
                None
            }
            None => {
                given.iter().for_each(|given| self.check_rows(given, None));
                None
            }
            Some(count) => {
                if mass.is_none() && by_entries.is_none() {
                    self.problem(place, format!("`M` is not given; expected {}", shape(count)));
                }
                Some(count)
            }
        }
    }
}
