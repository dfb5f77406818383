//! What rustc shows of mistakes, for one case of each kind of span; what is said is tested in the compiler, for all cases.
//!
//! After a change of these: `TRYBUILD=overwrite cargo test -p carvallo-ui`, then read what it changed.

/// The cases, and above them what rustc has to do there.
const CASES: [&str; 13] = [
    // The whole call, in one line and in several.
    "empty/nothing.rs",
    "empty/visibility_alone.rs",
    // Tokens that a macro of the user's hands over.
    "together/from_a_macro.rs",
    "together/in_a_function.rs",
    // Lines and marks that rustc cuts off.
    "formulas/nested_too_deeply.rs",
    "numbers/too_many_digits.rs",
    // One token, a stretch of several, the brace behind what is missing; several mistakes in their order.
    "together/one_of_each_kind.rs",
    "together/syntax_and_meaning.rs",
    // Letters beyond ASCII before the mistake.
    "names/sets_of_one_constant.rs",
    // A mistake that another line of the declaration proves.
    "claims/true_beyond_the_known_rules.rs",
    // Nothing is said of what uses the model.
    "rest_of_the_file/keeps_its_types.rs",
    "rest_of_the_file/with_statements_half_written.rs",
    "rest_of_the_file/after_the_symbolic_stage.rs",
];

#[test]
fn mistakes_are_shown_where_they_are() {
    let cases = trybuild::TestCases::new();
    CASES.iter().for_each(|case| cases.compile_fail(case));
}
