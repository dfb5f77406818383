//! What `model!` says of mistakes, and where it says it: one declaration for each in `tests/ui/`, beside it the message.
//!
//! After a change of a message: `TRYBUILD=overwrite cargo test -p carvallo-tests ui`, then read what it changed.

#[test]
fn mistakes_are_reported_where_they_are() {
    trybuild::TestCases::new().compile_fail("tests/ui/*/*.rs");
}
