//! The struct of the parameters, its parameter sets, and conversions.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use super::names::GeneratedNames;
use super::{derive, docs, number, or};
use crate::model::{Model, Parameter, ParameterSet};

/// The struct, its parameter sets if there are any, and the conversions.
pub fn emit(model: &Model, names: &GeneratedNames) -> (TokenStream, Option<TokenStream>, TokenStream) {
    let sets = (!model.sets.is_empty()).then(|| emit_sets(model, names));
    (emit_struct(model, names), sets, emit_conversions(model, names))
}

fn emit_struct(model: &Model, names: &GeneratedNames) -> TokenStream {
    let GeneratedNames { model: name, scalar, .. } = names;
    let Model { visibility, parameters, .. } = model;
    let (allow, derive) = (names.allow(), derive());
    let struct_docs = docs(&model_docs(model));
    let field_docs = parameters.iter().map(|parameter| docs(&parameter_docs(parameter)));
    let fields = fields(model);
    quote! {
        #struct_docs
        #allow
        #derive
        #visibility struct #name<#scalar = ::core::primitive::f64> {
            #(#field_docs pub #fields: #scalar,)*
        }
    }
}

/// All other conversions go by way of the array, so that the fields are listed once for each direction.
fn emit_conversions(model: &Model, names: &GeneratedNames) -> TokenStream {
    let GeneratedNames { runtime, model: name, scalar, other, .. } = names;
    let allow = names.allow();
    let fields = fields(model);
    let count = Literal::usize_unsuffixed(fields.len());
    let positions = (0..fields.len()).map(Literal::usize_unsuffixed);
    let [values, value] = ["values", "value"].map(|name| names.variable(name));
    quote! {
        #allow
        impl<#scalar: #runtime::Number> #name<#scalar> {
            /// The parameters from an array in declared order.
            #[must_use]
            pub const fn from_array(#values: [#scalar; #count]) -> Self {
                Self { #(#fields: #values[#positions],)* }
            }

            /// The parameters as an array in declared order.
            #[must_use]
            pub const fn to_array(&self) -> [#scalar; #count] {
                [#(self.#fields,)*]
            }
        }

        #allow
        impl<#scalar: #runtime::Scalar> #name<#scalar> {
            /// The same parameters in another number type, each rounded to the nearest.
            #[must_use]
            pub fn cast<#other: #runtime::Scalar>(&self) -> #name<#other> {
                let #values = self.to_array();
                #name::from_array(#values.map(|#value| #runtime::Scalar::from_f64(#runtime::Scalar::to_f64(#value))))
            }
        }
    }
}

fn fields(model: &Model) -> Vec<&Ident> {
    model.parameters.iter().map(|parameter| &parameter.name).collect()
}

fn emit_sets(model: &Model, names: &GeneratedNames) -> TokenStream {
    let (name, allow, fields) = (&names.model, names.allow(), fields(model));
    let constants = model.sets.iter().map(|set| {
        let constant = constant(set);
        let text = match (&*set.docs, &*set.source) {
            ("", "") => format!("The parameter set `{}`.", set.name),
            ("", source) => format!("The parameter set `{}`.\n\nSource: {source}", set.name),
            (text, "") => text.to_string(),
            (text, source) => format!("{text}\n\nSource: {source}"),
        };
        let text = docs(&text);
        let values = set.values.iter().map(|value| number(*value));
        quote! { #text pub const #constant: Self = Self { #(#fields: #values,)* }; }
    });
    quote! {
        #allow
        impl #name<::core::primitive::f64> { #(#constants)* }
    }
}

/// The name of the constant that holds a parameter set.
pub fn constant(set: &ParameterSet) -> Ident {
    format_ident!("{}", set.name.to_string().to_uppercase(), span = set.name.span())
}

fn model_docs(model: &Model) -> String {
    let mut text = or(&model.docs, &format!("The model `{}`.", model.name)).to_string();
    if !model.source.is_empty() {
        text.push_str(&format!("\n\nSource: {}", model.source));
    }
    if let Some(kinematics) = &model.kinematics {
        text.push_str(&format!("\n\nDerived from a mechanism: {}.", kinematics.parts.join(", ")));
    }
    text.push_str("\n\nThe fields are the parameters. The coordinates are");
    for (index, coordinate) in model.coordinates.iter().enumerate() {
        text.push_str(if index == 0 { " " } else { ", " });
        text.push_str(&format!("`{}`", coordinate.name));
        if coordinate.label != coordinate.name {
            text.push_str(&format!(" ({})", coordinate.label));
        }
        text.push_str(&format!(" in {}", coordinate.unit));
    }
    text.push('.');
    text
}

/// The text of the declaration, then symbol, unit and domain.
fn parameter_docs(parameter: &Parameter) -> String {
    let name = parameter.name.to_string();
    let unit = if parameter.unit == "1" { "a pure number".to_string() } else { format!("in {}", parameter.unit) };
    let mut facts = format!("`{name}`");
    if parameter.symbol != name {
        facts.push_str(&format!(", {},", parameter.symbol));
    }
    facts.push_str(&format!(" {unit}: {}.", parameter.domain));
    if !parameter.used {
        facts.push_str(" No matrix depends on it.");
    }
    if parameter.docs.is_empty() { facts } else { format!("{}\n\n{facts}", parameter.docs) }
}
