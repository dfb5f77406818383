//! Prints how many operations each program of each shipped model takes, as the table that a test compares with.
//!
//! `cargo run -p carvallo-tools --no-default-features --bin operations > tests/data/operations.tsv`

use carvallo_tests::operations::{COLUMNS, shipped};

fn main() {
    println!("{COLUMNS}");
    for (program, operations) in shipped() {
        println!("{program}\t{operations}");
    }
}
