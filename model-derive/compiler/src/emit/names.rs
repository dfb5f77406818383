//! What the generated code calls things.

use std::collections::{HashMap, HashSet};

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use super::Driver;
use crate::derivatives::Derivatives;
use crate::free_name::take_free_name;
use crate::model::Model;
use crate::program::{Instruction, Program, Value};

/// What the struct of the matrices has behind the name of the model.
pub const MATRICES: &str = "Matrices";
/// What the struct of their derivatives has behind it.
pub const DERIVATIVES: &str = "Derivatives";
const KINEMATICS: &str = "Kinematics";
/// What the struct of the nonlinear equations has behind it.
pub const MOTION: &str = "Motion";

/// The names of what a model defines in its module.
pub fn find_defined_names(model: &Model) -> Vec<String> {
    let has_kinematics = model.kinematics.as_ref().is_some_and(|kinematics| !kinematics.is_empty());
    let optional =
        [(has_kinematics, KINEMATICS), (model.derivatives.is_some(), DERIVATIVES), (model.motion.is_some(), MOTION)];
    let optional = optional.into_iter().filter(|(is_there, _)| *is_there).map(|(_, suffix)| suffix);
    ["", MATRICES].into_iter().chain(optional).map(|suffix| format!("{}{suffix}", model.name)).collect()
}

/// The names that the parts share.
pub struct GeneratedNames {
    /// The path of the runtime.
    pub runtime: TokenStream,
    pub model: Ident,
    pub matrices: Ident,
    pub kinematics: Ident,
    pub derivatives: Ident,
    pub motion: Ident,
    /// Names of derivatives; labels beyond the definitions of the model mean them.
    derived: Vec<Ident>,
    /// The type parameter; another letter for a model that is called `T` itself.
    pub scalar: Ident,
    /// A second type parameter.
    pub other: Ident,
    /// Whether the code lands among a user's items.
    pub among_items: bool,
}

impl GeneratedNames {
    pub fn new(model: &Model, derivatives: Option<&Derivatives>, driver: &Driver) -> Self {
        let name = model.name.clone();
        let unless_taken =
            |letter: &str, instead: &str| format_ident!("{}", if name == letter { instead } else { letter });
        Self {
            runtime: match driver {
                Driver::Macro { runtime } => runtime.clone(),
                Driver::File => quote!(::carvallo),
            },
            matrices: format_ident!("{name}{MATRICES}", span = name.span()),
            kinematics: format_ident!("{name}{KINEMATICS}", span = name.span()),
            derivatives: format_ident!("{name}{DERIVATIVES}", span = name.span()),
            motion: format_ident!("{name}{MOTION}", span = name.span()),
            derived: derived(model, derivatives),
            scalar: unless_taken("T", "S"),
            other: unless_taken("U", "S"),
            model: name,
            among_items: matches!(driver, Driver::Macro { .. }),
        }
    }

    /// A variable of the generated code. A constant or a unit struct of that name in the user's scope would be taken
    /// for a pattern, with whatever hygiene; so among a user's items variables begin with two underscores.
    pub fn variable(&self, name: &str) -> Ident {
        if self.among_items { format_ident!("__{name}") } else { format_ident!("{name}") }
    }

    /// A variable of a function that has a program inside, beside those that hold what it computes.
    pub fn variable_beside_values(&self, name: &str, model: &Model) -> Ident {
        let named = model.definitions.iter().map(|(name, _)| name).chain(&self.derived);
        self.variable(&take_free_name(name, &mut named.map(ToString::to_string).collect()))
    }

    /// Items with functions whose parameters have these names, for their documentation: whatever has the name in the
    /// user's scope, here it is that of a function, which a pattern may shadow.
    pub fn with_arguments(&self, arguments: &[&str], items: TokenStream) -> TokenStream {
        if !self.among_items {
            return items;
        }
        let allow = self.allow();
        let arguments = arguments.iter().map(|name| format_ident!("{name}"));
        quote! {
            const _: () = {
                #(#allow fn #arguments() {})*
                #items
            };
        }
    }

    /// A call of a method of the runtime's trait `Number`; among a user's items another trait could have a method of that
    /// name for all types.
    pub fn call(&self, method: &str, receiver: &TokenStream, argument: Option<&TokenStream>) -> TokenStream {
        let (runtime, method) = (&self.runtime, format_ident!("{method}"));
        match (self.among_items, argument) {
            (true, Some(argument)) => quote!(#runtime::Number::#method(#receiver, #argument)),
            (true, None) => quote!(#runtime::Number::#method(#receiver)),
            (false, argument) => quote!(#receiver.#method(#argument)),
        }
    }

    /// What generated items are allowed: names as in the formulas, and parts that a crate does not use. A file says it
    /// once at its head.
    pub fn allow(&self) -> Option<TokenStream> {
        let allowed = allowed();
        self.among_items.then(|| quote!(#[allow(#allowed)]))
    }

    /// The variables that hold the values of a program, of which some are results that have names.
    pub fn values<'a>(
        &'a self,
        program: &Program,
        model: &'a Model,
        inputs: &[String],
        results: &[(Value, String)],
    ) -> impl Fn(Value) -> Ident + use<'a> {
        let mut names: HashMap<Value, Ident> = HashMap::new();
        let mut taken: HashSet<String> = HashSet::new();
        // For people to read, values that are definitions have their names, then zero, functions of angles and other results.
        if !self.among_items {
            let named: Vec<&Ident> = model.definitions.iter().map(|(name, _)| name).chain(&self.derived).collect();
            for (value, index) in &program.labels {
                names.entry(*value).or_insert_with(|| named[*index].clone());
            }
            taken.extend(named.iter().map(ToString::to_string));
            for (value, name) in plain(program, inputs).iter().chain(results) {
                if !names.contains_key(value) && taken.insert(name.clone()) {
                    names.insert(*value, format_ident!("{name}"));
                }
            }
        }
        move |value| match names.get(&value) {
            Some(name) => name.clone(),
            None if taken.contains(&format!("t{value}")) => format_ident!("t{value}_"),
            None => self.variable(&format!("t{value}")),
        }
    }
}

/// Zero, and sine and cosine of inputs by name: `sin_lam` is that of `lam`.
fn plain(program: &Program, inputs: &[String]) -> Vec<(Value, String)> {
    let name = |(value, instruction): (Value, &Instruction)| {
        let (function, angle) = match *instruction {
            Instruction::Constant(0.0) => return Some((value, "zero".to_string())),
            Instruction::Sin(angle) => ("sin", angle),
            Instruction::Cos(angle) => ("cos", angle),
            _ => return None,
        };
        let Instruction::Parameter(index) = program.instructions[angle] else { return None };
        Some((value, format!("{function}_{}", inputs[index])))
    };
    program.instructions.iter().enumerate().filter_map(name).collect()
}

/// The lints that generated code does not keep to.
pub fn allowed() -> TokenStream {
    quote!(clippy::all, dead_code, deprecated, non_camel_case_types, non_snake_case)
}

/// A name for each derivative that has one; one that a definition or an earlier derivative has is set apart.
fn derived(model: &Model, derivatives: Option<&Derivatives>) -> Vec<Ident> {
    let mut taken: HashSet<String> = model.definitions.iter().map(|(name, _)| name.to_string()).collect();
    let names = derivatives.map_or(&[][..], |derivatives| &derivatives.names);
    names.iter().map(|name| format_ident!("{}", take_free_name(name, &mut taken))).collect()
}
