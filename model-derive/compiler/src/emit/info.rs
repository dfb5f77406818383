//! The model's description as a constant expression.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::evaluator::entries;
use super::names::Names;
use super::number;
use crate::model::{Bound, Domain, Model};
use crate::program::Program;
use crate::syntax::MatrixName;

pub fn emit(model: &Model, names: &Names, matrices: Option<&Program>) -> TokenStream {
    let runtime = &names.runtime;
    let Model { docs, source, .. } = model;
    let name = model.name.to_string();
    let parameters = model.parameters.iter().map(|parameter| {
        let name = parameter.name.to_string();
        let crate::model::Parameter { symbol, docs, unit, used, .. } = parameter;
        let domain = domain(parameter.domain, names);
        quote! {
            #runtime::ParameterInfo {
                name: #name, symbol: #symbol, docs: #docs, unit: #unit, domain: #domain, used: #used,
            }
        }
    });
    let coordinates = model.coordinates.iter().map(|coordinate| {
        let crate::model::Coordinate { name, label, docs, unit } = coordinate;
        quote! { #runtime::CoordinateInfo { name: #name, label: #label, docs: #docs, unit: #unit } }
    });
    let sets = model.sets.iter().map(|set| {
        let name = set.name.to_string();
        let crate::model::ParameterSet { docs, source, .. } = set;
        let values = set.values.iter().map(|value| number(*value));
        quote! { #runtime::SetInfo { name: #name, docs: #docs, source: #source, values: &[#(#values),*] } }
    });
    let matrix_name = |matrix: MatrixName| {
        let matrix = format_ident!("{}", matrix.name());
        quote!(#runtime::MatrixName::#matrix)
    };
    let names_of_matrices = model.matrices.iter().map(|(matrix, _)| matrix_name(*matrix));
    let n = model.coordinates.len();
    let entries = matrices.map(entries).unwrap_or_default().into_iter().map(|(_, places)| {
        let places = places.into_iter().map(|place| {
            let matrix = matrix_name(model.matrices[place / (n * n)].0);
            let [row, column] = [place / n % n, place % n].map(Literal::usize_unsuffixed);
            quote!((#matrix, #row, #column))
        });
        quote! { #runtime::EntryInfo { places: &[#(#places),*] } }
    });
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
            matrices: &[#(#names_of_matrices),*],
            entries: &[#(#entries),*],
            sets: &[#(#sets),*],
            gravity: #gravity,
        }
    }
}

pub fn domain(domain: Domain, names: &Names) -> TokenStream {
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
    let (lower, upper, nonzero) = (bound(domain.lower), bound(domain.upper), domain.nonzero);
    quote!(#runtime::Domain { lower: #lower, upper: #upper, nonzero: #nonzero })
}
