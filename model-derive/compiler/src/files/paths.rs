//! Paths as people write them.
//!
//! Generated code reaches everything by its full path, since the macro leaves it among a user's items, which can have any
//! name. A file of its own has `use` lines instead.

use std::collections::{BTreeSet, HashSet};

use proc_macro2::{Group, Ident, Spacing, TokenStream, TokenTree};
use quote::{format_ident, quote};

/// What every file of Rust knows by its last name.
const PRELUDE: [&str; 17] = [
    "Clone",
    "Copy",
    "Debug",
    "Default",
    "Err",
    "FnMut",
    "From",
    "None",
    "Ok",
    "Option",
    "PartialEq",
    "Result",
    "Some",
    "f32",
    "f64",
    "str",
    "usize",
];

/// The names that a file imports from the runtime.
pub struct Imports {
    imported: BTreeSet<String>,
    /// Names of the file's own types, which nothing imported may have.
    declared: HashSet<String>,
}

impl Imports {
    pub fn new(file: &syn::File) -> Self {
        let declared = file.items.iter().filter_map(|item| match item {
            syn::Item::Struct(item) => Some(item.ident.to_string()),
            _ => None,
        });
        Self { imported: BTreeSet::new(), declared: declared.collect() }
    }

    /// The same code with short names, which are imported from now on.
    pub fn shorten(&mut self, code: TokenStream) -> TokenStream {
        let tokens: Vec<TokenTree> = code.into_iter().collect();
        let mut short = TokenStream::new();
        let mut rest = &tokens[..];
        while let Some((first, others)) = rest.split_first() {
            if let Some((path, behind)) = absolute(rest) {
                short.extend(self.shortened(&path));
                rest = behind;
                continue;
            }
            short.extend([match first {
                TokenTree::Group(group) => Group::new(group.delimiter(), self.shorten(group.stream())).into(),
                token => token.clone(),
            }]);
            rest = others;
        }
        short
    }

    /// A path without what a reader knows or finds in the `use` lines. Functions keep the name of their crate: a variable
    /// could be called like one.
    fn shortened(&mut self, path: &[Ident]) -> TokenStream {
        let names: Vec<String> = path.iter().map(ToString::to_string).collect();
        let free = |name: &String| !self.declared.contains(name);
        let start = match &names[..] {
            [krate, name, ..] if krate == RUNTIME && name.starts_with(char::is_uppercase) && free(name) => {
                self.imported.insert(name.clone());
                1
            }
            _ => names.iter().rposition(|name| PRELUDE.contains(&&**name) && free(name)).unwrap_or(0),
        };
        let path = &path[start..];
        quote!(#(#path)::*)
    }

    /// The line that imports them.
    pub fn declaration(&self) -> TokenStream {
        let (runtime, names) = (format_ident!("{RUNTIME}"), self.imported.iter().map(|name| format_ident!("{name}")));
        quote!(use #runtime::{#(#names),*};)
    }
}

const RUNTIME: &str = "carvallo";

/// The names of a path from the root of a crate, if the tokens begin with one, and what is behind it.
fn absolute(tokens: &[TokenTree]) -> Option<(Vec<Ident>, &[TokenTree])> {
    let mut path = Vec::new();
    let mut rest = tokens;
    while let [TokenTree::Punct(colon), TokenTree::Punct(_), TokenTree::Ident(name), behind @ ..] = rest
        && colon.as_char() == ':'
        && colon.spacing() == Spacing::Joint
    {
        path.push(name.clone());
        rest = behind;
    }
    let krate = path.first()?.to_string();
    ["core", RUNTIME].contains(&&*krate).then_some((path, rest))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shortened(code: &str) -> [String; 2] {
        let file = syn::parse_file("pub struct Model; pub struct Option;").expect("a file");
        let mut imports = Imports::new(&file);
        let short = imports.shorten(code.parse().expect("tokens"));
        [short, imports.declaration()].map(|tokens| tokens.to_string().replace(' ', ""))
    }

    #[test]
    fn paths_into_the_runtime_are_imported_and_those_into_the_prelude_are_known() {
        let code = "x(::carvallo::Rate::new(::core::result::Result::Ok(<T as ::carvallo::Scalar>::from_f64(0.0))))";
        assert_eq!(shortened(code), ["x(Rate::new(Ok(<TasScalar>::from_f64(0.0))))", "usecarvallo::{Rate,Scalar};"]);
    }

    #[test]
    fn functions_keep_their_crate() {
        let code = "(::core::array::from_fn(f), ::carvallo::rows(&entries, 4))";
        assert_eq!(shortened(code)[0], "(core::array::from_fn(f),carvallo::rows(&entries,4))");
    }

    #[test]
    fn names_that_the_file_declares_are_not_taken_for_others() {
        let code = "(::carvallo::Model::INFO, ::core::option::Option::None, ::core::option::Option<f64>)";
        assert_eq!(shortened(code), ["(carvallo::Model::INFO,None,core::option::Option<f64>)", "usecarvallo::{};"]);
    }

    #[test]
    fn paths_that_go_on_behind_a_type_stay() {
        assert_eq!(shortened("<[_]>::len(x) + Type::<f64>::Ok")[0], "<[_]>::len(x)+Type::<f64>::Ok");
    }
}
