//! What stands beside a declaration in its file and defines a name that it defines too.
//!
//! Of two structs of one name rustc reports every implementation, on hundreds of lines. A macro sees its own tokens only,
//! but it can read the file that they stand in. Only what is certain is reported: what neither a `cfg` nor another macro can
//! take away, in the same module or block. Whatever else clashes is left to rustc.

use std::fmt;

use proc_macro2::{Delimiter, Group, LineColumn, TokenStream, TokenTree};

use crate::emit::{DERIVATIVES, MATRICES, MOTION, find_defined_names};
use crate::model::Model;

/// A name that is defined twice.
#[derive(Debug, PartialEq)]
pub struct Clash {
    name: String,
    /// What defines it beside the model.
    by: String,
}

/// Reads as a message at the name of the model.
impl fmt::Display for Clash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, by } = self;
        write!(f, "`{name}` is defined twice: by this model, and by {by}; expected another name for one of them")
    }
}

/// Finds the first name that a model and something beside it define. Of two models the later one has the clash.
pub fn find_clash(model: &Model) -> Option<Clash> {
    let span = model.name.span();
    let text = std::fs::read_to_string(span.local_file()?).ok()?;
    find_in(&text, span.start(), &model.name.to_string(), &find_defined_names(model))
}

/// Stands for the name of the model that is asked for.
const MARK: &str = "__the_model_itself";

/// In the text of a file; the name of the model is `at` its place, and it defines the names.
fn find_in(text: &str, at: LineColumn, model: &str, names: &[String]) -> Option<Clash> {
    let line: usize = text.split_inclusive('\n').take(at.line.checked_sub(1)?).map(str::len).sum();
    let (column, _) = text.get(line..)?.char_indices().nth(at.column)?;
    let (before, rest) = text.split_at(line + column);
    // The tokens of a text have no places, so the place is marked in it.
    let marked = format!("{before}{MARK}{}", rest.strip_prefix(model)?);
    let (tokens, position) = find_siblings(marked.parse().ok()?)?;
    let found: Vec<(String, String)> =
        (0..tokens.len()).flat_map(|index| find_definitions(&tokens, index, index < position)).collect();
    let of_name = |name: &String| found.iter().find(|(known, _)| known == name);
    names.iter().find_map(of_name).map(|(name, by)| Clash { name: name.clone(), by: by.clone() })
}

/// The tokens among which the marked model is declared, and where.
fn find_siblings(tokens: TokenStream) -> Option<(Vec<TokenTree>, usize)> {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (index, token) in tokens.iter().enumerate() {
        let TokenTree::Group(group) = token else { continue };
        let before = &tokens[..index];
        if find_declared(before, group).is_some_and(|name| name == MARK) {
            return Some((tokens, index));
        }
        // What a macro makes of its tokens is not known.
        let is_block = group.delimiter() == Delimiter::Brace && !is_of_macro(before);
        if let Some(found) = is_block.then(|| find_siblings(group.stream())).flatten() {
            return Some(found);
        }
    }
    None
}

fn is_of_macro(before: &[TokenTree]) -> bool {
    matches!(before, [.., TokenTree::Punct(mark)] if mark.as_char() == '!')
        || matches!(before, [.., TokenTree::Punct(mark), TokenTree::Ident(_)] if mark.as_char() == '!')
}

/// The name of the model that a group declares, if it is what `model!` is called with.
fn find_declared(before: &[TokenTree], group: &Group) -> Option<String> {
    let [.., TokenTree::Ident(word), TokenTree::Punct(mark)] = before else { return None };
    if word != "model" || mark.as_char() != '!' {
        return None;
    }
    let tokens: Vec<TokenTree> = group.stream().into_iter().collect();
    // Attributes, documentation and visibility come before it.
    tokens.windows(2).find_map(|pair| match pair {
        [TokenTree::Ident(keyword), TokenTree::Ident(name)] if keyword == "model" => Some(name.to_string()),
        _ => None,
    })
}

/// The names that what ends at a position surely defines, each with what that is.
fn find_definitions(tokens: &[TokenTree], index: usize, is_above: bool) -> Vec<(String, String)> {
    let before = &tokens[..index];
    match (before, &tokens[index]) {
        (_, TokenTree::Group(group)) if is_above && is_kept(before) => {
            let Some(model) = find_declared(before, group) else { return Vec::new() };
            let asks = |statement: &str| group.stream().into_iter().any(|token| asks_for(&token, statement));
            let optional = [("derivatives", DERIVATIVES), ("nonlinear", MOTION)];
            let optional = optional.into_iter().filter(|(statement, _)| asks(statement)).map(|(_, suffix)| suffix);
            let suffixes = ["", MATRICES].into_iter().chain(optional);
            suffixes.map(|suffix| (format!("{model}{suffix}"), format!("the model `{model}` above"))).collect()
        }
        ([.., TokenTree::Ident(keyword)], TokenTree::Ident(name)) if is_kept(before) => {
            let by = match &*keyword.to_string() {
                "struct" => "a struct",
                "enum" => "an enum",
                "union" => "a union",
                "trait" => "a trait",
                "type" => "a type",
                "mod" => "a module",
                _ => return Vec::new(),
            };
            vec![(name.to_string(), format!("{by} beside it"))]
        }
        _ => Vec::new(),
    }
}

/// Whether these are the braces of a model, with a statement of this one word.
fn asks_for(braces: &TokenTree, statement: &str) -> bool {
    let TokenTree::Group(statements) = braces else { return false };
    let mut statements = statements.stream().into_iter();
    statements.any(|token| matches!(token, TokenTree::Ident(word) if word == statement))
}

/// Attributes that take nothing away.
const HARMLESS: [&str; 11] =
    ["allow", "default", "deny", "deprecated", "derive", "doc", "expect", "must_use", "non_exhaustive", "repr", "warn"];

/// Whether the item that begins with the last of these tokens has no other attributes than such.
fn is_kept(before: &[TokenTree]) -> bool {
    let mut rest = before;
    // Back over visibility, path and keyword.
    while let [head @ .., last] = rest {
        match last {
            TokenTree::Punct(mark) if mark.as_char() == ';' => break,
            TokenTree::Group(group) if group.delimiter() != Delimiter::Parenthesis => break,
            _ => rest = head,
        }
    }
    while let [head @ .., TokenTree::Punct(mark), TokenTree::Group(attribute)] = rest {
        if mark.as_char() != '#' {
            break;
        }
        match attribute.stream().into_iter().next() {
            Some(TokenTree::Ident(name)) if HARMLESS.contains(&&*name.to_string()) => rest = head,
            _ => return false,
        }
    }
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What is found for the model in a text that is called so and has a space in its braces.
    fn find(text: &str, model: &str) -> Option<String> {
        let offset = text.rfind(&format!("model {model} {{ ")).expect("it is there") + "model ".len();
        let before = &text[..offset];
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count();
        let names = ["", "Matrices", "Derivatives"].map(|suffix| format!("{model}{suffix}"));
        find_in(text, LineColumn { line, column }, model, &names).map(|clash| clash.name)
    }

    #[test]
    fn names_that_are_defined_in_the_same_place_clash() {
        let cases = [
            ("model! { pub model A {} }\ncarvallo::model! { model A { } }", "A", "A"),
            (
                "model! { /// λ\n model A {} } model! { #[derive(Debug)] pub(crate) model AMatrices { } }",
                "AMatrices",
                "AMatrices",
            ),
            ("model! { model AMatrices {} } model! { model A { } }", "A", "AMatrices"),
            ("model! { model A { derivatives; } } model! { model ADerivatives { } }", "ADerivatives", "ADerivatives"),
            ("model! { model A { nonlinear; } } model! { model AMotion { } }", "AMotion", "AMotion"),
            ("/* λ { */ model! { model A { } } pub(crate) struct AMatrices;", "A", "AMatrices"),
            ("mod m { #[derive(Debug)] /// One.\n pub enum A { B } model! { model A { } } }", "A", "A"),
            ("fn f() { let s = '{'; type A = f64; model! { model A { } } }", "A", "A"),
        ];
        for (text, model, name) in cases {
            assert_eq!(find(text, model).as_deref(), Some(name), "{text}");
        }
    }

    #[test]
    fn names_elsewhere_and_names_that_may_not_be_there_do_not() {
        let cases = [
            "mod m { model! { model A {} } } model! { model A { } }",
            "struct A; mod m { model! { model A { } } }",
            "#[cfg(test)] model! { model A {} } #[cfg(not(test))] carvallo::model! { model A { } }",
            "#[cfg(test)] #[derive(Debug)] pub struct A; model! { model A { } }",
            "macro_rules! a { () => { struct A; } } model! { model A { } }",
            "a! { struct A; model! { model A { } } }",
            "fn f() { struct A; } const A: f64 = 1.0; model! { model A { } }",
            "model! { model B { derivative of A } } model! { model A { } }",
            "model! { model B {} } model! { model BDerivatives { } }",
            // The later one reports it.
            "model! { model A { } } model! { model A {} }",
        ];
        for text in cases {
            let model = if text.contains("BDerivatives") { "BDerivatives" } else { "A" };
            assert_eq!(find(text, model), None, "{text}");
        }
    }

    #[test]
    fn a_place_that_the_file_does_not_have_says_nothing() {
        for (line, column) in [(0, 0), (1, 0), (1, 900), (9, 0), (2, 1)] {
            let names = ["A".to_string()];
            assert_eq!(find_in("struct A;\nmodel! { model A { } }", LineColumn { line, column }, "A", &names), None);
        }
    }
}
