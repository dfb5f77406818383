//! The bicycle from its bodies and Appendix A are the same formulas, for all parameters.

use carvallo_compiler::model::Model;
use carvallo_compiler::symbolic::{Depth, Proof, prove_equal};
use carvallo_compiler::{Equations, check};
use carvallo_tests::fractions;
use num_bigint::BigInt;
use num_rational::BigRational;
use proc_macro2::TokenStream;
use proptest::prelude::*;

use super::declaration;

/// The model of a source.
fn model(source: &str) -> Model {
    let tokens: TokenStream = declaration(source).parse().expect("tokens");
    check(tokens).expect("a model without mistakes")
}

fn written() -> Model {
    model(include_str!("../../../../generated/models/whipple.rs"))
}

fn derived() -> Model {
    model(include_str!("../../../../generated/models/whipple_mechanism.rs"))
}

fn names(model: &Model) -> Vec<String> {
    model.parameters.iter().map(|parameter| parameter.name.to_string()).collect()
}

#[test]
fn every_entry_is_proved_to_be_that_of_appendix_a() {
    let (written, derived) = (written(), derived());
    assert_eq!(names(&written), names(&derived), "the parameters have the same order");
    // The definitions of the one behind those of the other.
    let count = written.definitions.len();
    let new: Vec<usize> = (count..count + derived.definitions.len()).collect();
    let behind = derived.formulas_of_definitions().map(|formula| formula.renumbered(&new));
    let definitions: Vec<_> = written.formulas_of_definitions().cloned().chain(behind).collect();
    let mut pairs = Vec::new();
    let mut places = Vec::new();
    assert_eq!(written.matrices.len(), derived.matrices.len());
    for ((name, rows), (same, others)) in written.matrices.iter().zip(&derived.matrices) {
        assert_eq!(name, same);
        for (row, (entries, others)) in rows.iter().zip(others).enumerate() {
            for (column, (entry, other)) in entries.iter().zip(others).enumerate() {
                let sides = vec![entry.clone(), other.renumbered(&new)];
                pairs.push(Equations::of_formulas(written.parameters.len(), &definitions, sides));
                places.push(format!("{}, row {row}, column {column}", name.name()));
            }
        }
    }
    assert_eq!(pairs.len(), 16, "four matrices of four entries");
    let found = prove_equal(pairs, Depth::Formulas).expect("the engine works");
    for (proof, place) in found.into_iter().zip(places) {
        assert_eq!(proof, Proof::Found, "{place}");
    }
}

#[test]
fn an_entry_that_differs_is_not_proved() {
    let written = written();
    let [(_, mass), .., (_, speed)] = &written.matrices[..] else { panic!("four matrices") };
    let sides = vec![mass[0][0].clone(), speed[0][1].clone()];
    let pair = Equations::of_formulas(written.parameters.len(), written.formulas_of_definitions(), sides);
    assert_ne!(prove_equal(vec![pair], Depth::Formulas).expect("the engine works"), [Proof::Found]);
}

/// Fractions of both signs, none of them zero: no divisor is, and an angle stands for the tangent of its half.
fn fraction() -> impl Strategy<Value = BigRational> {
    let part = 1_i64..1_000_000;
    (part.clone(), part, any::<bool>()).prop_map(|(above, below, negative)| {
        BigRational::new(BigInt::from(if negative { -above } else { above }), BigInt::from(below))
    })
}

#[test]
fn both_are_equal_in_exact_fractions_at_a_hundred_random_designs() {
    let (written, derived) = (written(), derived());
    let count = written.parameters.len();
    let designs = proptest::collection::vec(fraction(), count);
    let config = carvallo_tests::designs::config(100);
    let cases = config.cases;
    let mut runner = proptest::test_runner::TestRunner::new(config);
    let compared = std::cell::Cell::new(0);
    let same = runner.run(&designs, |design| {
        let both = [&written, &derived].map(|model| fractions::matrices(model, &design));
        prop_assert_eq!(&both[0], &both[1]);
        compared.set(compared.get() + 1);
        Ok(())
    });
    same.expect("equal fractions");
    assert_eq!(compared.get(), cases);
}
