//! Where the formulas of a declaration are: the right sides of definitions, and the entries of matrices.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

const MATRICES: [&str; 7] = ["M", "C0", "C1", "Kc", "K0", "K1", "K2"];

/// The formulas, and the names that they may use.
#[derive(Debug, Default)]
pub struct Formulas {
    /// Parameters and definitions, as they are declared.
    pub names: Vec<String>,
    /// The tokens of each formula.
    pub formulas: Vec<Vec<TokenTree>>,
}

/// Those of the declaration `model Name { … }`.
///
/// # Panics
/// If the declaration has no braces.
pub fn find(declaration: TokenStream) -> Formulas {
    let body = declaration.into_iter().find_map(|token| match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group.stream()),
        _ => None,
    });
    let mut found = Formulas::default();
    for statement in statements(body.expect("the braces of a model")) {
        let words: Vec<String> = statement.iter().take(3).map(ToString::to_string).collect();
        match (words.iter().map(String::as_str).collect::<Vec<_>>().as_slice(), &statement[..]) {
            (["parameters", ..], [_, TokenTree::Group(block), ..]) => {
                let parameters = statements(block.stream()).into_iter();
                found.names.extend(parameters.filter_map(|parameter| first_name(&parameter)));
            }
            (["let", name, "="], [_, _, _, formula @ ..]) => {
                found.names.push((*name).to_string());
                found.formulas.push(formula.to_vec());
            }
            // Words may stand before the name.
            (_, [.., TokenTree::Ident(name), TokenTree::Punct(_), TokenTree::Group(rows)])
                if MATRICES.iter().any(|matrix| name == matrix) =>
            {
                for row in split(rows.stream(), ',').into_iter().flatten() {
                    let TokenTree::Group(row) = row else { panic!("a row of {name} that is no list") };
                    found.formulas.extend(split(row.stream(), ','));
                }
            }
            _ => {}
        }
    }
    found
}

/// Statements end with `;` or with a block; documentation before them is left out.
fn statements(stream: TokenStream) -> Vec<Vec<TokenTree>> {
    let mut statements = Vec::new();
    for mut statement in split(stream, ';') {
        while let Some(block) = statement.iter().position(is_block) {
            let rest = statement.split_off(block + 1);
            statements.push(std::mem::replace(&mut statement, rest));
        }
        statements.push(statement);
    }
    for statement in &mut statements {
        while matches!(statement.first(), Some(TokenTree::Punct(punct)) if punct.as_char() == '#') {
            statement.drain(..2);
        }
    }
    statements
}

fn is_block(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace)
}

/// The stretches between the separators that are not empty.
fn split(stream: TokenStream, separator: char) -> Vec<Vec<TokenTree>> {
    let tokens: Vec<TokenTree> = stream.into_iter().collect();
    let is_separator = |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == separator);
    tokens.split(is_separator).filter(|part| !part.is_empty()).map(<[_]>::to_vec).collect()
}

fn first_name(statement: &[TokenTree]) -> Option<String> {
    match statement.first() {
        Some(TokenTree::Ident(name)) => Some(name.to_string()),
        _ => None,
    }
}
