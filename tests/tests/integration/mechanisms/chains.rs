//! Chains of one to eight links against the textbook.

use carvallo_compiler::compile;
use carvallo_tests::chain::declaration;
use carvallo_tests::textbook::pendulum::{Link, standing_at_hinges};

use super::{assert_close, interpreted};

/// Links of which no two are alike.
fn link(index: usize) -> Link {
    let index = index as f64;
    Link { l: 0.4 + 0.1 * index, a: 0.25 - 0.02 * index, m: 1.5 + 0.3 * index, i: 0.02 + 0.01 * index * index }
}

fn check<const N: usize>() {
    let links: [Link; N] = std::array::from_fn(link);
    let compiled = compile(declaration(N).parse().expect("tokens")).expect("the chain compiles");
    let parameters: Vec<f64> = links.iter().flat_map(|link| [link.l, link.a, link.m, link.i]).chain([9.81]).collect();
    let names: Vec<&str> = compiled.model.matrices.iter().map(|(name, _)| name.name()).collect();
    assert_eq!(names, ["M", "K0"], "{N} links");
    assert_close(&interpreted(&compiled, &parameters), &standing_at_hinges(links), 1e-14, &format!("{N} links"));
}

#[test]
fn one_to_eight_links_are_the_textbooks() {
    check::<1>();
    check::<2>();
    check::<3>();
    check::<4>();
    check::<5>();
    check::<6>();
    check::<7>();
    check::<8>();
}
