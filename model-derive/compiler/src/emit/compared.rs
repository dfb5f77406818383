//! Tests of the user's crate, in which functions by hand stand beside the generated code.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote, quote_spanned};

use crate::model::Model;
use crate::syntax::Compared;

/// A test for each function that is named; nothing for a model that names none.
pub fn emit(model: &Model) -> Option<TokenStream> {
    let tests = model.compared.iter().map(|Compared { function, name, only_double }| {
        let (model, scalar) = (&model.name, only_double.then(|| quote!(: f64)));
        let module = format_ident!("{}_{}", in_small_letters(model), name, span = name.span());
        // Where the crate is no dependency, that is said at the function.
        let library = quote_spanned!(name.span()=> ::carvallo_compare);
        quote! {
            #[cfg(test)]
            #library::test!(#module: #model, #function #scalar);
        }
    });
    (!model.compared.is_empty()).then(|| tests.collect())
}

/// `RollingDisc` as `rolling_disc`.
fn in_small_letters(name: &Ident) -> String {
    let mut letters = String::new();
    for letter in name.to_string().trim_start_matches("r#").chars() {
        if letter.is_uppercase() && !letters.is_empty() {
            letters.push('_');
        }
        letters.extend(letter.to_lowercase());
    }
    letters
}
