//! Eigenvalues as comma-separated values.

use std::fmt::Write as _;

use crate::analysis::Row;

/// One row a speed, under a header with the units. Each mode that has two eigenvalues has numbered columns.
pub fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "speed (m/s),castering re (1/s),castering im (1/s),capsize re (1/s),capsize im (1/s),weave 1 re (1/s),weave 1 \
         im (1/s),weave 2 re (1/s),weave 2 im (1/s)\n",
    );
    for Row { speed, values } in rows {
        // Writing to a string cannot fail.
        let _ = write!(text, "{speed:?}");
        for value in values {
            let _ = write!(text, ",{:?},{:?}", value.value.re, value.value.im);
        }
        text.push('\n');
    }
    text
}
