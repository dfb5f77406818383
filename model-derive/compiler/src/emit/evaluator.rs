//! The struct of the matrices, and the straight-line function that computes them.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::body::Body;
use super::fields::{field_docs, field_name};
use super::names::GeneratedNames;
use super::{derive, docs, states};
use crate::derivatives::entry_names;
use crate::matrix_name::MatrixName;
use crate::model::{Model, Origin, Requirement};
use crate::program::{Counts, Instruction, Program, Value};

pub fn emit(model: &Model, names: &GeneratedNames, program: Option<&Program>) -> TokenStream {
    let GeneratedNames { runtime, model: name, matrices, scalar, .. } = names;
    let visibility = &model.visibility;
    let n = model.coordinates.len();
    let allow = names.allow();
    let fields = fields(model);
    let field_docs = model.matrices.iter().map(|(matrix, _)| {
        let proved = if model.symmetric.contains(matrix) { " Symmetric, proved." } else { "" };
        docs(&format!("{}{proved}", field_docs(*matrix)))
    });
    let struct_docs = docs(&format!(
        "The coefficient matrices of [`{name}`], each {n} x {n} and row by row, in SI units.\n\n\
         Matrices that are not among them are zero.",
    ));
    let size = Literal::usize_unsuffixed(n);
    let counts = program.map(|program| format!("\n{}", Counts::of(program))).unwrap_or_default();
    let function_docs = docs(&format!(
        "The coefficient matrices, from one straight-line program:{counts}.\n\n\
         The parameters are not validated.{}",
        needs(model),
    ));
    let body = match program {
        Some(program) => matrices_body(model, names, program),
        // Beside a mistake in the declaration: nothing ever runs it.
        None => quote!(loop {}),
    };
    let derive = derive();
    quote! {
        #struct_docs
        #allow
        #derive
        #visibility struct #matrices<#scalar = ::core::primitive::f64> {
            #(#field_docs pub #fields: #runtime::Rows<#scalar, #size>,)*
        }

        #allow
        impl<#scalar: #runtime::Number> #name<#scalar> {
            #function_docs
            // Lanes are fast only inside the function that was compiled for them.
            #[inline(always)]
            #[must_use]
            pub fn matrices(&self) -> #matrices<#scalar> {
                #body
            }
        }
    }
}

/// How the struct of the matrices comes from their entries, which of these differ, and what it is among all matrices that
/// there can be.
pub fn emit_conversions(model: &Model, names: &GeneratedNames, program: Option<&Program>) -> TokenStream {
    let GeneratedNames { runtime, matrices, scalar, .. } = names;
    let allow = names.allow();
    let [entries, all] = ["entries", "matrices"].map(|name| names.variable(name));
    let fields = fields(model);
    let n = model.coordinates.len();
    let count = Literal::usize_unsuffixed(fields.len() * n * n);
    let distinct = program.map(self::entries).unwrap_or_default().into_iter().map(|(_, places)| {
        let field = &fields[places[0] / (n * n)];
        let [row, column] = [places[0] / n % n, places[0] % n].map(Literal::usize_unsuffixed);
        quote!(self.#field[#row][#column])
    });
    let distinct: Vec<TokenStream> = distinct.collect();
    let distinct_count = Literal::usize_unsuffixed(distinct.len());
    let firsts = (0..fields.len()).map(|matrix| Literal::usize_unsuffixed(matrix * n * n));
    let size = Literal::usize_unsuffixed(n);
    let zeros = names.variable("zeros");
    let coefficients = states::complete(quote!(#runtime::Coefficients::from_rows(#all.rows())), model, names);
    let set_entry = model.derivatives.is_some().then(|| set_entry(model, names, program));
    let rows = MatrixName::ALL.map(|matrix| {
        let field = field(matrix, model);
        if fields.contains(&field) { quote!(self.#field.0) } else { quote!(#zeros) }
    });
    let zeros = (fields.len() < rows.len()).then(|| {
        let zero = names.call("like", &quote!(self.m.0[0][0]), Some(&quote!(0.0)));
        quote!(let #zeros = [[#zero; #size]; #size];)
    });
    quote! {
        #allow
        impl<#scalar: #runtime::Number> #matrices<#scalar> {
            /// From the entries of one matrix after the other, each row by row.
            #[inline(always)]
            fn from_entries(#entries: [#scalar; #count]) -> Self {
                Self { #(#fields: #runtime::rows(&#entries, #firsts),)* }
            }

            /// Those entries that differ and are not always zero.
            #[inline(always)]
            fn distinct_entries(&self) -> [#scalar; #distinct_count] {
                [#(#distinct),*]
            }

            #set_entry

            /// The rows of M, C-1, C0, C1, Kc, K0, K1 and K2.
            #[inline(always)]
            fn rows(&self) -> [[[#scalar; #size]; #size]; 8] {
                #zeros
                [#(#rows),*]
            }
        }

        #allow
        impl<#scalar: #runtime::Scalar> ::core::convert::From<#matrices<#scalar>> for #runtime::Coefficients<#scalar, #size> {
            fn from(#all: #matrices<#scalar>) -> Self {
                #coefficients
            }
        }
    }
}

/// A function that sets one of the entries that differ, wherever it stands.
fn set_entry(model: &Model, names: &GeneratedNames, program: Option<&Program>) -> TokenStream {
    let [position, entry] = ["position", "entry"].map(|name| names.variable(name));
    let (fields, n, scalar) = (fields(model), model.coordinates.len(), &names.scalar);
    let arms = program.map(self::entries).unwrap_or_default().into_iter().enumerate().map(|(number, (_, places))| {
        let number = Literal::usize_unsuffixed(number);
        let places = places.iter().map(|place| {
            let [row, column] = [place / n % n, place % n].map(Literal::usize_unsuffixed);
            let field = &fields[place / (n * n)];
            quote!(self.#field[#row][#column] = #entry;)
        });
        quote!(#number => { #(#places)* })
    });
    quote! {
        /// Sets the entry at a position among those that differ, wherever it stands.
        #[inline(always)]
        fn set_entry(&mut self, #position: ::core::primitive::usize, #entry: #scalar) {
            match #position {
                #(#arms)*
                _ => {}
            }
        }
    }
}

/// What the matrices divide by and take the root of, where the domains alone do not make sure that it can be done.
fn needs(model: &Model) -> String {
    let needs = model.requirements.iter().filter(|requirement| requirement.origin == Origin::Matrices);
    let lines: Vec<String> = needs
        .map(|Requirement { text, domain, .. }| match domain.nonzero {
            true => format!("- divides by `{text}`, which the declared domains do not keep from zero"),
            false => {
                format!("- takes the root of `{text}`, which the declared domains do not keep from being negative")
            }
        })
        .collect();
    if lines.is_empty() {
        return String::new();
    }
    format!(
        " Beside what is outside the domains, `validate` refuses what has no value here, for it\n{}.",
        lines.join(";\n")
    )
}

/// The fields of the struct of the matrices.
pub fn fields(model: &Model) -> Vec<Ident> {
    model.matrices.iter().map(|(matrix, _)| field(*matrix, model)).collect()
}

/// The field of a matrix, at the span of its declaration.
fn field(matrix: MatrixName, model: &Model) -> Ident {
    let declared = model.references.matrices.iter().find(|(name, _)| *name == matrix);
    Ident::new(field_name(matrix), declared.map_or(Span::call_site(), |(_, span)| *span))
}

fn matrices_body(model: &Model, names: &GeneratedNames, program: &Program) -> TokenStream {
    let body = Body::new(program, model, names, &results(model, program));
    let statements = body.statements();
    let matrices = literal(&body, &program.outputs, model, names);
    quote! { #statements #matrices }
}

/// The struct of the matrices, whose entries are the first of the outputs.
pub fn literal(body: &Body, outputs: &[Value], model: &Model, names: &GeneratedNames) -> TokenStream {
    let matrices = &names.matrices;
    let entries = model.matrices.len() * model.coordinates.len().pow(2);
    let values = outputs[..entries].iter().map(|value| &body.values[*value]);
    quote!(#matrices::from_entries([#(#values),*]))
}

/// The entries of the matrices by name, which are the first of the outputs of a program.
pub fn results(model: &Model, program: &Program) -> Vec<(Value, String)> {
    program.outputs.iter().copied().zip(entry_names(model)).collect()
}

/// The values of a program that differ and are not always zero, each with the outputs that it is.
pub fn entries(program: &Program) -> Vec<(Value, Vec<usize>)> {
    let mut entries: Vec<(Value, Vec<usize>)> = Vec::new();
    for (place, value) in program.outputs.iter().enumerate() {
        if program.instructions[*value] == Instruction::Constant(0.0) {
            continue;
        }
        match entries.iter_mut().find(|(known, _)| known == value) {
            Some((_, places)) => places.push(place),
            None => entries.push((*value, vec![place])),
        }
    }
    entries
}
