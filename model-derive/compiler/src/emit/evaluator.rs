//! The struct of the matrices, and the straight-line function that computes them.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::{Names, allow, docs, number};
use crate::model::Model;
use crate::program::{Counts, Instruction, Program, Value};

pub fn emit(model: &Model, names: &Names, program: &Program) -> TokenStream {
    let Names { model: name, matrices, scalar } = names;
    let visibility = &model.visibility;
    let n = model.coordinates.len();
    let allow = allow();
    let fields: Vec<Ident> = model.matrices.iter().map(|(matrix, _)| format_ident!("{}", matrix.field())).collect();
    let field_docs = model.matrices.iter().map(|(matrix, _)| docs(matrix.docs()));
    let struct_docs = docs(&format!(
        "The coefficient matrices of [`{name}`], each {n} x {n} and row by row, in SI units.\n\n\
         Matrices that the model does not declare are zero and left out.",
    ));
    let size = proc_macro2::Literal::usize_unsuffixed(n);
    let function_docs = docs(&format!(
        "The coefficient matrices, from one straight-line program.\n\n\
         It takes {}. The parameters are not validated.",
        Counts::of(program),
    ));
    let body = Body::new(program, model, scalar);
    let statements = &body.statements;
    let rows = (0..model.matrices.len()).map(|matrix| {
        let rows = (0..n).map(|row| {
            let first = (matrix * n + row) * n;
            let entries = program.outputs[first..first + n].iter().map(|value| &body.values[*value]);
            quote! { [#(#entries),*] }
        });
        quote! { [#(#rows),*] }
    });
    quote! {
        #struct_docs
        #allow
        #[derive(::core::clone::Clone, ::core::marker::Copy, ::core::fmt::Debug, ::core::cmp::PartialEq)]
        #visibility struct #matrices<#scalar = ::core::primitive::f64> {
            #(#field_docs pub #fields: [[#scalar; #size]; #size],)*
        }

        #allow
        impl<#scalar: ::carvallo::Scalar> #name<#scalar> {
            #function_docs
            #[inline]
            #[must_use]
            pub fn matrices(&self) -> #matrices<#scalar> {
                #(#statements)*
                #matrices { #(#fields: #rows,)* }
            }
        }
    }
}

/// A program as statements, and each value as an expression.
pub struct Body {
    pub statements: Vec<TokenStream>,
    pub values: Vec<TokenStream>,
}

impl Body {
    pub fn new(program: &Program, model: &Model, scalar: &Ident) -> Self {
        let mut body = Self { statements: Vec::new(), values: Vec::new() };
        // Sine and cosine of one angle come from one call.
        let partner = |wanted: Instruction| program.instructions.iter().position(|i| *i == wanted);
        let mut paired: Vec<Option<TokenStream>> = vec![None; program.instructions.len()];
        for (value, instruction) in program.instructions.iter().enumerate() {
            let at = |value: Value| body.values[value].clone();
            let expression = match *instruction {
                Instruction::Parameter(index) => {
                    let name = &model.parameters[index].name;
                    body.values.push(quote!(self.#name));
                    continue;
                }
                Instruction::Constant(c) => {
                    let c = number(c);
                    quote!(<#scalar as ::carvallo::Scalar>::from_f64(#c))
                }
                Instruction::Sin(a) | Instruction::Cos(a) => {
                    if let Some(name) = &paired[value] {
                        body.values.push(name.clone());
                        continue;
                    }
                    let angle = at(a);
                    let sine = matches!(instruction, Instruction::Sin(_));
                    let other = partner(if sine { Instruction::Cos(a) } else { Instruction::Sin(a) });
                    if let Some(other) = other {
                        let [first, second] = [value, other].map(|value| format_ident!("t{value}"));
                        paired[other] = Some(quote!(#second));
                        let (s, c) = if sine { (&first, &second) } else { (&second, &first) };
                        body.statements.push(quote! { let (#s, #c) = ::carvallo::Scalar::sin_cos(#angle); });
                        body.values.push(quote!(#first));
                        continue;
                    }
                    if sine { quote!(::carvallo::Scalar::sin(#angle)) } else { quote!(::carvallo::Scalar::cos(#angle)) }
                }
                Instruction::Add(a, b) => binary(at(a), quote!(+), at(b)),
                Instruction::Sub(a, b) => binary(at(a), quote!(-), at(b)),
                Instruction::Mul(a, b) => binary(at(a), quote!(*), at(b)),
                Instruction::Div(a, b) => binary(at(a), quote!(/), at(b)),
                Instruction::Square(a) => binary(at(a), quote!(*), at(a)),
                Instruction::Neg(a) => {
                    let a = at(a);
                    quote!(-#a)
                }
                Instruction::Reciprocal(a) => {
                    let a = at(a);
                    quote!(<#scalar as ::carvallo::Scalar>::from_f64(1.0) / #a)
                }
                Instruction::Sqrt(a) => {
                    let a = at(a);
                    quote!(::carvallo::Scalar::sqrt(#a))
                }
                Instruction::Tan(a) => {
                    let a = at(a);
                    quote!(::carvallo::Scalar::tan(#a))
                }
                Instruction::Power(..) => unreachable!("the pass `powers` leaves none"),
            };
            let name = format_ident!("t{value}");
            body.statements.push(quote! { let #name = #expression; });
            body.values.push(quote!(#name));
        }
        body
    }
}

fn binary(left: TokenStream, sign: TokenStream, right: TokenStream) -> TokenStream {
    quote!(#left #sign #right)
}
