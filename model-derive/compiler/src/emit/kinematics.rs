//! The struct of the rates and forces that follow from a mechanism, and the function that computes them.

use std::collections::HashSet;

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use super::body::Body;
use super::names::GeneratedNames;
use super::{derive, docs};
use crate::formula::Formula;
use crate::free_name::take_free_name;
use crate::kinematics::{Applied, Kinematics};
use crate::model::Model;
use crate::program::{Counts, Program};

/// Nothing for a model whose formulas are written, or whose mechanism has no motions and forces beside its coordinates.
pub fn emit(model: &Model, names: &GeneratedNames, program: Option<&Program>) -> Option<TokenStream> {
    let kinematics = model.kinematics.as_ref()?;
    if kinematics.is_empty() {
        return None;
    }
    let GeneratedNames { runtime, model: name, kinematics: output, scalar, .. } = names;
    let visibility = &model.visibility;
    let (n, forces) = (model.coordinates.len(), kinematics.applied.len());
    let [size, force_count] = [n, forces].map(Literal::usize_unsuffixed);
    let (allow, derive) = (names.allow(), derive());
    let fields = fields(kinematics);
    let field_docs = kinematics.rates.iter().map(|rate| docs(&rate.docs));
    let coordinates: Vec<String> = model.coordinates.iter().map(|q| format!("`{}`", q.name)).collect();
    let struct_docs = docs(&format!(
        "Rates and forces of [`{name}`] that follow from its coordinates q = ({}),\nto first order and in SI units.",
        coordinates.join(", "),
    ));
    let force_field = (forces > 0).then(|| {
        let what = kinematics.applied.iter().map(|Applied { name, label, unit, .. }| format!("`{name}` ({label}) in `{unit}`"));
        let what: Vec<String> = what.collect();
        let docs = docs(&format!(
            "The forces f on the coordinates that applied forces make: a row for each coordinate,\na column for each of \
             {}.",
            what.join(", ")
        ));
        quote! { #docs pub forces: [[#scalar; #force_count]; #size], }
    });
    let counts = program.map(|program| format!(":\n{}", Counts::of(program))).unwrap_or_default();
    let function_docs = docs(&format!(
        "Rates and forces that follow from the coordinates{counts}.\n\nThe parameters are not validated."
    ));
    let body = match program {
        Some(program) => body(model, names, kinematics, &fields, program),
        // Beside a mistake in the declaration: nothing ever runs it.
        None => quote!(loop {}),
    };
    Some(quote! {
        #struct_docs
        #allow
        #derive
        #visibility struct #output<#scalar = ::core::primitive::f64> {
            #(#field_docs pub #fields: #runtime::Rate<#scalar, #size>,)*
            #force_field
        }

        #allow
        impl<#scalar: #runtime::Scalar> #name<#scalar> {
            #function_docs
            #[inline]
            #[must_use]
            pub fn kinematics(&self) -> #output<#scalar> {
                #body
            }
        }
    })
}

/// A field for each rate; of two with one name the later one is set apart.
fn fields(kinematics: &Kinematics<Formula>) -> Vec<Ident> {
    let mut taken = HashSet::from(["forces".to_string()]);
    let field = |name: &String| Ident::new(&take_free_name(name, &mut taken), Span::call_site());
    kinematics.rates.iter().map(|rate| &rate.name).map(field).collect()
}

fn body(
    model: &Model,
    names: &GeneratedNames,
    kinematics: &Kinematics<Formula>,
    fields: &[Ident],
    program: &Program,
) -> TokenStream {
    let GeneratedNames { runtime, kinematics: output, .. } = names;
    let body = Body::new(program, model, names, &[]);
    let statements = body.statements();
    let mut values = program.outputs.iter().map(|value| &body.values[*value]);
    let mut next = || values.next().unwrap_or_else(|| unreachable!("a value for each formula"));
    let rates = kinematics.map(|_| next());
    let literals = rates.rates.iter().map(|rate| {
        let (speed, heading) = (rate.speed, rate.heading);
        let (by_rate, by_coordinate) = (&rate.rates, &rate.coordinates);
        quote! {
            #runtime::Rate { speed: #speed, rates: [#(#by_rate),*], coordinates: [#(#by_coordinate),*], heading: #heading }
        }
    });
    let forces = (!kinematics.applied.is_empty()).then(|| {
        let rows = rates.forces.iter().map(|row| quote!([#(#row),*]));
        let field = format_ident!("forces");
        quote! { #field: [#(#rows),*], }
    });
    quote! {
        #statements
        #output { #(#fields: #literals,)* #forces }
    }
}
