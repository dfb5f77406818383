//! What the compiler says of mistakes, and where it says it: every declaration in `tests/ui/` at the root against the text
//! beside it, as rustc shows it. Some of them go through rustc itself, by `tests/ui/rustc.rs`.
//!
//! `cargo messages` runs this alone; after a change of a message `UPDATE=1 cargo messages`, then read what it changed.

use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};

/// What only rustc can show: a call as a whole, tokens from a macro of the user's, lines that it cuts off, and what is said
/// of other items in the file.
const BY_RUSTC_ALONE: [&str; 8] = [
    "empty/nothing",
    "empty/visibility_alone",
    "together/from_a_macro",
    "formulas/nested_too_deeply",
    "numbers/too_many_digits",
    "clashes/two_models_of_one_name",
    "clashes/matrices_of_another_model",
    "clashes/beside_a_struct",
];

#[test]
fn mistakes_are_reported_where_they_are() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/ui");
    let update = std::env::var_os("UPDATE").is_some_and(|value| value == "1");
    let mut differences = String::new();
    for case in cases(&folder) {
        let [source, expected] = ["rs", "stderr"].map(|end| folder.join(format!("{case}.{end}")));
        let text = fs::read_to_string(source).unwrap_or_else(|error| panic!("{case}.rs: {error}"));
        let wanted = fs::read_to_string(&expected).unwrap_or_default().replace("\r\n", "\n");
        match std::panic::catch_unwind(|| messages(&text, &format!("{case}.rs"))) {
            Ok(found) if found == wanted => {}
            Ok(found) if update => {
                fs::write(&expected, found).unwrap_or_else(|error| panic!("{case}.stderr: {error}"));
            }
            Ok(found) => differences += &format!("\n--- {case}: expected\n{wanted}--- found\n{found}"),
            Err(_) => differences += &format!("\n--- {case}: a panic, whose message stands above\n"),
        }
    }
    let mend = "if this is what should be said, run `UPDATE=1 cargo messages` and read what it changes";
    assert!(differences.is_empty(), "messages differ: {mend}\n{differences}");
}

/// Every pair of a source and its text, as `folder/name`; half a pair is one, too, and then differs.
fn cases(folder: &Path) -> Vec<String> {
    let entries = |path: PathBuf| fs::read_dir(path).expect("a folder").map(|entry| entry.expect("an entry").path());
    let files = entries(folder.into()).filter(|path| path.is_dir()).flat_map(entries);
    let names = files.map(|path| {
        let name = path.with_extension("");
        name.strip_prefix(folder).expect("it lies there").to_string_lossy().replace('\\', "/")
    });
    let mut cases: Vec<String> = names.collect();
    cases.sort();
    cases.dedup();
    let by_rustc = fs::read_to_string(folder.join("Cargo.toml")).expect("the list of what goes through rustc");
    for case in BY_RUSTC_ALONE {
        assert!(by_rustc.contains(&format!("path = \"{case}.rs\"")), "{case} is in neither of the tests");
        let position = cases.iter().position(|name| name == case);
        cases.remove(position.unwrap_or_else(|| panic!("there is no case {case}")));
    }
    assert!(!cases.is_empty(), "there are no cases in {}", folder.display());
    cases
}

/// All that is said of a file, of which at least something has to be said.
fn messages(text: &str, name: &str) -> String {
    let mut declarations = Vec::new();
    collect(text.parse().unwrap_or_else(|error| panic!("{name}: {error}")), &mut declarations);
    assert_eq!(declarations.len(), 1, "{name}: expected one `model! {{ … }}`");
    let compiled = declarations.into_iter().map(carvallo_compiler::compile);
    let errors = compiled.filter_map(Result::err).flatten();
    let shown: Vec<String> = errors.map(|error| show(&error, name, text)).collect();
    assert!(!shown.is_empty(), "nothing is said of {name}");
    shown.join("\n")
}

/// The contents of all calls `model! { … }`, wherever they stand.
fn collect(tokens: TokenStream, declarations: &mut Vec<TokenStream>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (index, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else { continue };
        match &tokens[..index] {
            [.., TokenTree::Ident(name), TokenTree::Punct(mark)] if name == "model" && mark.as_char() == '!' => {
                declarations.push(group.stream());
            }
            _ => collect(group.stream(), declarations),
        }
    }
}

/// An error as rustc shows it.
fn show(error: &syn::Error, name: &str, text: &str) -> String {
    let (start, end) = (error.span().start(), error.span().end());
    assert!(start.line > 0 && start.line == end.line, "{name}: not in one line, which only rustc can show: {error}");
    let line = text.lines().nth(start.line - 1).unwrap_or_default();
    let number = start.line.to_string();
    let margin = " ".repeat(number.len());
    let (pad, mark) = (" ".repeat(start.column), "^".repeat((end.column - start.column).max(1)));
    let place = format!("{name}:{number}:{}", start.column + 1);
    format!("error: {error}\n{margin}--> {place}\n{margin} |\n{number} | {line}\n{margin} | {pad}{mark}\n")
}
