//! Chains of one to eight links against the textbook.

use carvallo::Coefficients;
use carvallo_compiler::compile;
use carvallo_tests::chain::{declaration, hanging_points};
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

/// Many links, of point masses and of links with inertia: rounding must not be taken for a mass that is missing.
#[test]
fn long_chains_are_the_textbooks() {
    check::<22>();
    // Where each mass is at the end of its link.
    let links: [Link; 18] = std::array::from_fn(|index| Link { a: link(index).l, i: 0.0, ..link(index) });
    let compiled = compile(hanging_points(18).parse().expect("tokens")).expect("the chain compiles");
    let parameters: Vec<f64> = links.iter().flat_map(|link| [link.l, link.m]).chain([9.81]).collect();
    let standing = standing_at_hinges(links);
    let hanging = Coefficients { k0: -standing.k0, ..standing };
    assert_close(&interpreted(&compiled, &parameters), &hanging, 1e-14, "18 point masses");
}
