//! The model's description as a constant expression.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::by_attributes;
use super::evaluator::entries;
use super::names::GeneratedNames;
use super::number;
use super::structure::constant;
use crate::domain::{Bound, Domain};
use crate::kinematics::Applied;
use crate::matrix_name::MatrixName;
use crate::model::{Model, Requirement};
use crate::pipeline::Programs;
use crate::states::States;
use crate::written::{Of, Written};

pub fn emit(model: &Model, names: &GeneratedNames, programs: Option<&Programs>) -> TokenStream {
    let GeneratedNames { runtime, model: model_name, .. } = names;
    let Model { docs, source, .. } = model;
    let name = model.name.to_string();
    let parameters = model.parameters.iter().map(|parameter| {
        let crate::model::Parameter { symbol, docs, unit, used, .. } = parameter;
        let (name, domain) = (parameter.name.to_string(), domain(parameter.domain, names));
        let symbol = (*symbol != name).then(|| quote!(.symbol(#symbol)));
        let docs = (!docs.is_empty()).then(|| quote!(.docs(#docs)));
        let unused = (!used).then(|| quote!(.unused()));
        quote!(#runtime::ParameterInfo::new(#name, #unit, #domain) #symbol #docs #unused)
    });
    let coordinates = model.coordinates.iter().map(|coordinate| {
        let crate::model::Coordinate { name, label, docs, unit, states } = coordinate;
        let label = (label != name).then(|| quote!(.label(#label)));
        let docs = (!docs.is_empty()).then(|| quote!(.docs(#docs)));
        let states = (*states != States::Both).then(|| {
            let states = super::states::emit(*states, names);
            quote!(.states(#states))
        });
        quote!(#runtime::CoordinateInfo::new(#name, #unit) #label #docs #states)
    });
    let sets = model.sets.iter().map(|set| {
        let (name, constant) = (set.name.to_string(), constant(set));
        let crate::model::ParameterSet { docs, source, .. } = set;
        let set = quote!(#model_name::<::core::primitive::f64>::#constant);
        let values = quote!(&#model_name::to_array(&#set));
        quote! { #runtime::SetInfo { name: #name, docs: #docs, source: #source, values: #values } }
    });
    let requirements = model.requirements.iter().map(|Requirement { text, unit, domain: required, .. }| {
        let domain = domain(*required, names);
        quote!(#runtime::RequirementInfo::new(#text, #unit, #domain))
    });
    let matrix_name = |matrix: MatrixName| {
        let matrix = format_ident!("{}", matrix.identifier());
        quote!(#runtime::MatrixName::#matrix)
    };
    let names_of_matrices = model.matrices.iter().map(|(matrix, _)| matrix_name(*matrix));
    let formula = |Written { of, unit, text }: &Written| match of {
        Of::Definition(name) => quote!(#runtime::FormulaInfo::definition(#name, #unit, #text)),
        Of::Attribute(name, what) => quote!(#runtime::FormulaInfo::attribute(#name, #what, #unit, #text)),
        Of::Entries(matrix, places) => {
            let matrix = matrix_name(*matrix);
            let places = places.iter().map(|place| {
                let [row, column] = place.map(Literal::usize_unsuffixed);
                quote!((#matrix, #row, #column))
            });
            quote!(#runtime::FormulaInfo::entry(&[#(#places),*], #unit, #text))
        }
    };
    let [formulas, attributes] = [&model.formulas, &model.attributes].map(|all| all.iter().map(formula));
    let forces = forces(model, names);
    let n = model.coordinates.len();
    let entries =
        programs.map(|programs| entries(&programs.matrices)).unwrap_or_default().into_iter().map(|(_, places)| {
            let places = places.into_iter().map(|place| {
                let matrix = matrix_name(model.matrices[place / (n * n)].0);
                let [row, column] = [place / n % n, place % n].map(Literal::usize_unsuffixed);
                quote!((#matrix, #row, #column))
            });
            quote!(#runtime::EntryInfo::at(&[#(#places),*]))
        });
    let motion = by_attributes::emit(model, names, programs.and_then(|programs| programs.by_attributes.as_ref()));
    let gravity = match model.gravity {
        Some(index) => {
            let index = Literal::usize_unsuffixed(index);
            quote!(::core::option::Option::Some(#index))
        }
        None => quote!(::core::option::Option::None),
    };
    quote! {
        &#runtime::ModelInfo {
            name: #name,
            docs: #docs,
            source: #source,
            parameters: &[#(#parameters),*],
            coordinates: &[#(#coordinates),*],
            forces: #forces,
            matrices: &[#(#names_of_matrices),*],
            entries: &[#(#entries),*],
            sets: &[#(#sets),*],
            requirements: &[#(#requirements),*],
            formulas: &[#(#formulas),*],
            attributes: &[#(#attributes),*],
            motion: #motion,
            gravity: #gravity,
        }
    }
}

/// The forces that may be applied, as a slice.
pub fn forces(model: &Model, names: &GeneratedNames) -> TokenStream {
    let runtime = &names.runtime;
    let applied = model.kinematics.iter().flat_map(|kinematics| &kinematics.applied);
    let forces = applied.map(|Applied { name, label, unit, position }| {
        quote!(#runtime::motion::AppliedInfo { name: #name, label: #label, unit: #unit, position: #position })
    });
    quote!(&[#(#forces),*])
}

fn domain(domain: Domain, names: &GeneratedNames) -> TokenStream {
    let runtime = &names.runtime;
    let bound = |bound| match bound {
        Bound::Unbounded => quote!(#runtime::Bound::Unbounded),
        Bound::Open(value) => {
            let value = number(value);
            quote!(#runtime::Bound::Open(#value))
        }
        Bound::Closed(value) => {
            let value = number(value);
            quote!(#runtime::Bound::Closed(#value))
        }
    };
    let Domain { lower, upper, nonzero } = domain;
    match (lower, upper, nonzero) {
        (Bound::Unbounded, Bound::Unbounded, false) => quote!(#runtime::Domain::FINITE),
        (Bound::Unbounded, Bound::Unbounded, true) => quote!(#runtime::Domain::NONZERO),
        (Bound::Open(0.0), Bound::Unbounded, false) => quote!(#runtime::Domain::POSITIVE),
        (Bound::Closed(0.0), Bound::Unbounded, false) => quote!(#runtime::Domain::NONNEGATIVE),
        _ => {
            let (lower, upper, nonzero) = (bound(lower), bound(upper), nonzero.then(|| quote!(.without_zero())));
            quote!(#runtime::Domain::between(#lower, #upper) #nonzero)
        }
    }
}
