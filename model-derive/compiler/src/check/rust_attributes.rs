//! Attributes of Rust on the model and its parameters: those that the struct and its fields get.

use proc_macro2::TokenStream;
use quote::quote;
use syn::punctuated::Punctuated;
use syn::{Meta, Path, Token};

use crate::report::{Region, Report};
use crate::syntax::{Declaration, RustAttribute};

/// What every model derives; declarations may say so too.
const DERIVED: [&str; 4] = ["Clone", "Copy", "Debug", "PartialEq"];

/// What stands between the brackets of attributes.
#[derive(Debug)]
pub struct RustAttributes {
    /// Those of the struct, without what it derives anyway.
    pub model: Vec<TokenStream>,
    /// Those of each field.
    pub parameters: Vec<Vec<TokenStream>>,
}

/// Reads the attributes of the model and of its parameters, and finds its default.
pub fn read_rust_attributes(declaration: &Declaration, report: &mut Report) -> RustAttributes {
    check_defaults(declaration, report);
    refuse_on_the_speed(declaration, report);
    let model =
        declaration.rust_attributes.iter().filter_map(|attribute| read_of_model(attribute, declaration, report));
    let model = model.collect();
    let parameters = declaration.parameters.iter().map(|parameter| {
        let attributes = parameter.rust_attributes.iter();
        attributes.filter_map(|attribute| read_of_parameter(attribute, report)).collect()
    });
    RustAttributes { model, parameters: parameters.collect() }
}

fn check_defaults(declaration: &Declaration, report: &mut Report) {
    for second in declaration.sets.iter().flat_map(|set| &set.defaults).skip(1) {
        report.error(*second, "a second `#[default]`: expected one parameter set that is the default");
    }
}

fn read_of_model(attribute: &RustAttribute, declaration: &Declaration, report: &mut Report) -> Option<TokenStream> {
    let RustAttribute { meta, region } = attribute;
    refuse_default(attribute, report)?;
    if meta.path().is_ident("cfg") {
        report.error(*region, "a `cfg` that would leave out the struct alone: expected it before `carvallo::model!`");
        return None;
    }
    without_derived(meta, *region, declaration, report)
}

fn read_of_parameter(attribute: &RustAttribute, report: &mut Report) -> Option<TokenStream> {
    let RustAttribute { meta, region } = attribute;
    refuse_default(attribute, report)?;
    let path = meta.path();
    if path.is_ident("cfg") {
        report.error(*region, "a `cfg` on a parameter, without which there is no model: expected none");
        return None;
    }
    if path.is_ident("derive") {
        report.error(*region, "`derive` on a parameter: expected it before `model`");
        return None;
    }
    Some(quote!(#meta))
}

/// The speed is a parameter of formulas alone.
fn refuse_on_the_speed(declaration: &Declaration, report: &mut Report) {
    for attribute in declaration.speed.iter().flat_map(|speed| &speed.rust_attributes) {
        report.error(attribute.region, "an attribute on the speed, which is no field: expected it on a parameter");
    }
}

/// Nothing, and a mistake, for `#[default]`.
fn refuse_default(attribute: &RustAttribute, report: &mut Report) -> Option<()> {
    if !attribute.meta.path().is_ident("default") {
        return Some(());
    }
    report.error(attribute.region, "`#[default]` on something that has no value: expected it before a parameter set");
    None
}

/// An attribute, without traits that every model derives: written twice they would be implemented twice.
fn without_derived(meta: &Meta, region: Region, declaration: &Declaration, report: &mut Report) -> Option<TokenStream> {
    let path = meta.path();
    if path.is_ident("cfg_attr")
        && let Meta::List(list) = meta
        && let Ok(metas) = list.parse_args_with(Punctuated::<Meta, Token![,]>::parse_terminated)
    {
        let condition = metas.first()?;
        let attributes = metas.iter().skip(1);
        let kept: Vec<_> = attributes.filter_map(|meta| without_derived(meta, region, declaration, report)).collect();
        return (!kept.is_empty()).then(|| quote!(#path(#condition, #(#kept),*)));
    }
    if !path.is_ident("derive") {
        return Some(quote!(#meta));
    }
    let traits = match meta {
        Meta::List(list) => list.parse_args_with(Punctuated::<Path, Token![,]>::parse_terminated).ok(),
        _ => None,
    };
    let Some(traits) = traits else {
        report.error(region, "a `derive` without names of traits: expected `#[derive(Trait, …)]`");
        return None;
    };
    let default = declaration.sets.iter().find(|set| !set.defaults.is_empty());
    let derived = traits.iter().find(|path| is_standard(path, &["Default"])).and_then(|path| path.segments.last());
    if let (Some(set), Some(name)) = (default, derived) {
        let set = &set.name;
        let message = format!("`Default` is the parameter set `{set}`, by `#[default]`: expected one of the two");
        report.error(&name.ident, message);
        return None;
    }
    let kept: Vec<&Path> = traits.iter().filter(|path| !is_standard(path, &DERIVED)).collect();
    (!kept.is_empty()).then(|| quote!(#path(#(#kept),*)))
}

/// Whether a path is that of one of these traits of the standard library, as people write it.
fn is_standard(path: &Path, names: &[&str]) -> bool {
    let segments: Vec<String> = path.segments.iter().map(|segment| segment.ident.to_string()).collect();
    match &segments[..] {
        [name] => names.contains(&&**name),
        [krate, .., name] => matches!(&**krate, "std" | "core") && names.contains(&&**name),
        [] => false,
    }
}
