//! Which derivatives are asked for, and the functions that give those with respect to one parameter.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::names::GeneratedNames;
use super::{docs, evaluator};
use crate::matrix_name::MatrixName;
use crate::model::{AskedDerivatives, Model};

/// Which derivatives are asked for, if not all.
pub fn tell_asked(model: &Model, asked: &AskedDerivatives) -> String {
    if asked.is_all(model) {
        return String::new();
    }
    let matrices = model.matrices.iter().map(|(matrix, _)| *matrix).filter(|matrix| asked.has(*matrix));
    let matrices: Vec<&str> = matrices.map(MatrixName::name).collect();
    let parameters = model.parameters.iter().zip(&asked.parameters).filter(|(_, asked)| **asked);
    let parameters: Vec<String> = parameters.map(|(parameter, _)| format!("`{}`", parameter.name)).collect();
    format!("\n\nAsked for are those of {} with respect to {}.", matrices.join(", "), parameters.join(", "))
}

/// Whether what is asked for are not those with respect to the parameter at the position `parameter`, as a condition.
fn is_not_asked(asked: &AskedDerivatives, parameter: &Ident) -> TokenStream {
    if asked.parameters.iter().all(|asked| *asked) {
        let parameters = Literal::usize_unsuffixed(asked.parameters.len());
        return quote!(#parameter >= #parameters);
    }
    let positions = (0..asked.parameters.len()).filter(|index| asked.parameters[*index]);
    let positions = positions.map(Literal::usize_unsuffixed);
    quote!(!::core::matches!(#parameter, #(#positions)|*))
}

/// All matrices derived with respect to one parameter.
pub fn with_respect_to(model: &Model, asked: &AskedDerivatives, names: &GeneratedNames, count: usize) -> TokenStream {
    let GeneratedNames { runtime, matrices: all, derivatives, scalar, .. } = names;
    let parameter = format_ident!("parameter");
    let [matrices, position, partial, matrix, zero] =
        ["matrices", "position", "partial", "matrix", "zero"].map(|name| names.variable(name));
    let [n, count] = [model.coordinates.len(), count].map(Literal::usize_unsuffixed);
    let is_not_asked = is_not_asked(asked, &parameter);
    let function_docs = docs(match asked.is_all(model) {
        true => {
            "The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing\n\
             if there is no such parameter."
        }
        false => {
            "The derivatives of all matrices with respect to the parameter at a position, with the zeros filled in; nothing\n\
             if those are not asked for."
        }
    });
    let fields = evaluator::fields(model);
    let arms = model.matrices.iter().zip(&fields).map(|((matrix, _), field)| {
        let matrix = format_ident!("{}", matrix.identifier());
        quote!(#runtime::MatrixName::#matrix => &mut #matrices.#field,)
    });
    let rest = (model.matrices.len() < MatrixName::ALL.len()).then(|| quote!(_ => continue,));
    quote! {
        #function_docs
        #[must_use]
        pub fn with_respect_to(
            &self,
            #parameter: ::core::primitive::usize,
        ) -> ::core::option::Option<#all<#scalar>> {
            if #is_not_asked {
                return ::core::option::Option::None;
            }
            let #zero = <#scalar as #runtime::Scalar>::from_f64(0.0);
            let mut #matrices = #all { #(#fields: #runtime::Rows([[#zero; #n]; #n]),)* };
            for #position in 0..#count {
                let #partial = <#derivatives>::PARTIALS[#position];
                if #partial.parameter != #parameter {
                    continue;
                }
                let #matrix = match #partial.matrix { #(#arms)* #rest };
                #matrix[#partial.row][#partial.column] = #runtime::Partial::of(&#partial, &self.values);
            }
            ::core::option::Option::Some(#matrices)
        }
    }
}

/// One matrix derived with respect to one parameter, where not all are.
pub fn matrix_with_respect_to(
    model: &Model,
    asked: &AskedDerivatives,
    names: &GeneratedNames,
    count: usize,
) -> TokenStream {
    let GeneratedNames { runtime, derivatives, scalar, .. } = names;
    let parameter = format_ident!("parameter");
    let [matrix, rows, position, partial, zero] =
        ["matrix", "rows", "position", "partial", "zero"].map(|name| names.variable(name));
    let [n, count] = [model.coordinates.len(), count].map(Literal::usize_unsuffixed);
    let is_not_asked = is_not_asked(asked, &parameter);
    let matrices = model.matrices.iter().filter(|(matrix, _)| asked.has(*matrix));
    let matrices = matrices.map(|(matrix, _)| format_ident!("{}", matrix.identifier()));
    quote! {
        /// The derivatives of a matrix with respect to the parameter at a position, row by row, with the zeros filled in;
        /// nothing if those are not asked for.
        #[must_use]
        pub fn matrix_with_respect_to(
            &self,
            #matrix: #runtime::MatrixName,
            #parameter: ::core::primitive::usize,
        ) -> ::core::option::Option<[[#scalar; #n]; #n]> {
            if !::core::matches!(#matrix, #(#runtime::MatrixName::#matrices)|*) || #is_not_asked {
                return ::core::option::Option::None;
            }
            let #zero = <#scalar as #runtime::Scalar>::from_f64(0.0);
            let mut #rows = [[#zero; #n]; #n];
            for #position in 0..#count {
                let #partial = <#derivatives>::PARTIALS[#position];
                if #partial.parameter == #parameter && #partial.matrix == #matrix {
                    #rows[#partial.row][#partial.column] = #runtime::Partial::of(&#partial, &self.values);
                }
            }
            ::core::option::Option::Some(#rows)
        }
    }
}
