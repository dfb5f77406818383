//! The shipped models, in a table.

use carvallo_design::Shipped;

use crate::output::models::{sentence, sets};
use crate::output::typeset::{Cell, Column, Document, Table};

/// With what they are, and their parameter sets.
pub fn of_models(models: &[Shipped]) -> Document {
    let row = |model: &Shipped| {
        let info = model.info;
        vec![
            Cell::words(info.name),
            Cell::number(info.coordinates.len().to_string()),
            Cell::number(info.parameters.len().to_string()),
            Cell::words(sets(model)),
            Cell::words(sentence(info.docs)),
            Cell::words(info.source),
        ]
    };
    let table = Table {
        title: String::new(),
        columns: vec![
            Column::left("model"),
            Column::right("coordinates"),
            Column::right("parameters"),
            Column::left("sets"),
            Column::left("what it is"),
            Column::left("source"),
        ],
        rows: models.iter().map(row).collect(),
        notes: Vec::new(),
    };
    Document { title: "Models".to_owned(), about: Vec::new(), tables: vec![table] }
}
