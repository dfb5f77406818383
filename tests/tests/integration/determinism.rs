//! The same declaration gives the same bytes: run after run, among other models, and wherever it lies.

use std::fmt::Write as _;
use std::fs;
use std::path::PathBuf;

use carvallo_compiler::files::regenerate;
use carvallo_compiler::{Driver, expand};
use carvallo_tests::chain;
use quote::quote;

const SMALL: &str = "model Small { parameters { a: kg, > 0; b: kg, > 0; lam: rad; } let c = a + b^2/a; \
                     require a + b > 0; coordinates { x: m; y: m; } \
                     M = [[c, b*sin(lam)], [b*sin(lam), c^2/a]]; Kc = [[a*cos(lam)*1 [Hz^2], 0], [0, 2 [N/m]*c/b]]; }";

fn expanded(declaration: &str, driver: &Driver) -> String {
    expand(declaration.parse().expect("tokens"), driver).expect("the model compiles").to_string()
}

fn drivers() -> [Driver; 2] {
    [Driver::Macro { runtime: quote!(::carvallo) }, Driver::File]
}

#[test]
fn a_dozen_runs_among_other_models_give_the_same_code() {
    let first = drivers().map(|driver| expanded(SMALL, &driver));
    for run in 0..12 {
        // Each of the others has more names than the ones before it.
        let mut other = String::from("model Other { parameters { a: 1; lam: rad; } let d0 = a*sin(lam);");
        (1..=8 * run).for_each(|index| write!(other, "let d{index} = d{}*a + lam;", index - 1).expect("a string"));
        write!(other, "coordinates {{ x: m; }} M = [[d{}*1 [kg]]]; }}", 8 * run).expect("a string");
        assert!(!expanded(&other, &Driver::File).is_empty());
        assert_eq!(drivers().map(|driver| expanded(SMALL, &driver)), first, "run {run}");
    }
}

#[test]
fn mechanisms_among_others_give_the_same_code() {
    let source = include_str!("../../../generated/models/skateboard.rs");
    let (_, body) = source.split_once('{').expect("an opening brace");
    let (skateboard, _) = body.rsplit_once('}').expect("a closing brace");
    let run = || {
        let chain = |n| expanded(&chain::declaration(n), &Driver::File);
        [expanded(skateboard, &Driver::File), chain(3), expanded(SMALL, &Driver::File), chain(2)]
    };
    let first = run();
    (0..5).for_each(|number| assert_eq!(run(), first, "run {number}"));
}

#[test]
fn the_folder_does_not_matter() {
    let source = include_str!("../../../generated/models/whipple.rs");
    let written = ["a", "another folder"].map(|name| {
        let folder: PathBuf = std::env::temp_dir().join(format!("carvallo-{}-{name}", std::process::id()));
        fs::create_dir_all(folder.join("models")).expect("a folder for the test");
        fs::write(folder.join("models/whipple.rs"), source).expect("a file can be written");
        regenerate(&folder, false).expect("the model compiles");
        let files =
            ["mod.rs", "whipple.rs"].map(|file| fs::read(folder.join("src/models").join(file)).expect("a file"));
        fs::remove_dir_all(&folder).expect("the folder can be removed");
        files
    });
    assert_eq!(written[0], written[1]);
}

#[test]
fn a_chain_of_thousands_of_definitions_compiles() {
    let mut chain = String::from("model Chain { parameters { p: 1; q: 1; } coordinates { x: 1; } let d0 = p*q;");
    (1..4_000).for_each(|index| write!(chain, "let d{index} = sin(d{})*p + q;", index - 1).expect("a string"));
    chain.push_str("M = [[d3999*1 [kg*m^2]]]; }");
    assert_eq!(expanded(&chain, &Driver::File).matches(". sin (").count(), 3_999);
}
