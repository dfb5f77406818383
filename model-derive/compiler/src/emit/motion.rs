//! The struct of the nonlinear equations of motion, and what implements the runtime's traits.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::body::{Body, Inputs};
use super::inputs::names_of_inputs;
use super::names::GeneratedNames;
use super::{derive, docs, info, linearization};
use crate::model::Model;
use crate::motion::{MotionModel, PositionKind};
use crate::nonlinear::MotionPrograms;
use crate::pipeline::Programs;
use crate::program::{Counts, Program};

/// Nothing for a model that does not ask for nonlinear equations.
pub fn emit(model: &Model, names: &GeneratedNames, programs: Option<&Programs>) -> Option<TokenStream> {
    let motion = model.motion.as_ref()?;
    let programs = programs.and_then(|programs| programs.motion.as_ref());
    let GeneratedNames { runtime, model: name, motion: output, scalar, other, .. } = names;
    let visibility = &model.visibility;
    let (allow, derive) = (names.allow(), derive());
    let count = Literal::usize_unsuffixed(programs.map_or(0, |programs| programs.constants.outputs.len()));
    let struct_docs = docs(&format!(
        "The nonlinear equations of motion of [`{name}`], with its parameters: what does not depend on the state is computed.\n\n\
         {}",
        describe(motion, programs),
    ));
    let constants = programs.map(|programs| &programs.constants);
    let counts = constants.map(|program| format!(":\n{}", Counts::of(program))).unwrap_or_default();
    let function_docs = docs(&format!(
        "The nonlinear equations of motion, of what is computed once for these parameters{counts}.\n\n\
         The parameters are not validated."
    ));
    let made = match constants {
        Some(program) => {
            let body = Body::new(program, model, names, &[]);
            let statements = body.statements();
            let values = program.outputs.iter().map(|value| &body.values[*value]);
            quote!(#statements #output { constants: [#(#values),*] })
        }
        // Beside a mistake in the declaration: nothing ever runs it.
        None => quote!(loop {}),
    };
    let model_over = names.variable("model");
    let traits = emit_traits(model, names, motion, programs);
    let partials = linearization::emit(model, names, motion, programs);
    let n = Literal::usize_unsuffixed(model.coordinates.len());
    Some(quote! {
        #struct_docs
        #allow
        #derive
        #visibility struct #output<#scalar = ::core::primitive::f64> {
            constants: [#scalar; #count],
        }

        #allow
        impl<#scalar: #runtime::Number> #name<#scalar> {
            #function_docs
            // Lanes are fast only inside the function that was compiled for them.
            #[inline(always)]
            #[must_use]
            pub fn motion(&self) -> #output<#scalar> {
                #made
            }
        }

        #allow
        impl<#scalar: #runtime::Scalar> #runtime::Nonlinear<#n> for #name<#scalar> {
            type Motion = #output<#scalar>;

            type MotionOver<#other: #runtime::Number> = #output<#other>;

            fn motion(&self) -> #output<#scalar> {
                #name::motion(self)
            }

            #[inline(always)]
            fn motion_over<#other: #runtime::Number>(#model_over: &#name<#other>) -> #output<#other> {
                #name::motion(#model_over)
            }
        }

        #traits

        #partials
    })
}

fn emit_traits(
    model: &Model,
    names: &GeneratedNames,
    motion: &MotionModel,
    programs: Option<&MotionPrograms>,
) -> TokenStream {
    let GeneratedNames { runtime, motion: output, scalar, .. } = names;
    let allow = names.allow();
    let MotionModel { layout, wheels, .. } = motion;
    let sizes = [layout.positions.len(), layout.conditions.independent.len(), layout.standing.len()];
    let [p, n, m] = sizes.map(Literal::usize_unsuffixed);
    let applied = model.kinematics.as_ref().map_or(0, |kinematics| kinematics.applied.len());
    let [f, w] = [applied, wheels.len()].map(Literal::usize_unsuffixed);
    let info = emit_info(model, names, motion);
    let arguments = ["positions", "speeds", "forces"].map(|name| names.variable(name));
    let [positions, speeds, forces] = &arguments;
    let body = |program: fn(&MotionPrograms) -> &Program, split: &[usize]| match programs {
        Some(programs) => emit_body(model, names, motion, program(programs), programs, &arguments, split),
        None => quote!(loop {}),
    };
    let closure = body(|programs| &programs.closure, &[sizes[2], sizes[2]]);
    let rates = body(|programs| &programs.rates, &[]);
    let derivatives = body(|programs| &programs.derivatives, &[sizes[0], sizes[1]]);
    let accelerations = body(|programs| &programs.accelerations, &[]);
    let energy = body(|programs| &programs.energy, &[]);
    let contact_forces = match programs {
        Some(programs) => {
            let (statements, values) =
                emit_values(model, names, motion, &programs.contact_forces, programs, &arguments);
            let rows = rows(&values, wheels.len(), 3);
            quote!(#statements #rows)
        }
        None => quote!(loop {}),
    };
    let written = model
        .derivatives
        .as_ref()
        .filter(|asked| asked.is_all(model))
        .map(|_| linearization::emit_written(names, [p.clone(), n.clone(), f.clone()]));
    quote! {
        #allow
        impl<#scalar: #runtime::Scalar> #runtime::motion::Motion for #output<#scalar> {
            const INFO: &'static #runtime::motion::MotionInfo = #info;
            #written
        }

        #allow
        #[allow(unused_variables)]
        impl<#scalar: #runtime::Number> #runtime::motion::Unchecked for #output<#scalar> {
            type Scalar = #scalar;
            type Positions = [#scalar; #p];
            type Speeds = [#scalar; #n];
            type Dependent = [#scalar; #m];
            type Forces = [#scalar; #f];
            type ContactForces = [[#scalar; 3]; #w];

            #[inline(always)]
            fn closure_unchecked(&self, #positions: &[#scalar; #p]) -> ([#scalar; #m], [#scalar; #m]) {
                #closure
            }

            #[inline(always)]
            fn rates_unchecked(&self, #positions: &[#scalar; #p], #speeds: &[#scalar; #n]) -> [#scalar; #p] {
                #rates
            }

            #[inline(always)]
            fn derivatives_unchecked(
                &self,
                #positions: &[#scalar; #p],
                #speeds: &[#scalar; #n],
                #forces: &[#scalar; #f],
            ) -> ([#scalar; #p], [#scalar; #n]) {
                #derivatives
            }

            #[inline(always)]
            fn accelerations_unchecked(
                &self,
                #positions: &[#scalar; #p],
                #speeds: &[#scalar; #n],
                #forces: &[#scalar; #f],
            ) -> [#scalar; #p] {
                #accelerations
            }

            fn energy_unchecked(&self, #positions: &[#scalar; #p], #speeds: &[#scalar; #n]) -> [#scalar; 2] {
                #energy
            }

            fn contact_forces_unchecked(
                &self,
                #positions: &[#scalar; #p],
                #speeds: &[#scalar; #n],
                #forces: &[#scalar; #f],
            ) -> [[#scalar; 3]; #w] {
                #contact_forces
            }
        }
    }
}

/// Values as so many arrays of so many.
pub fn rows(values: &[TokenStream], rows: usize, columns: usize) -> TokenStream {
    let rows = (0..rows).map(|row| &values[row * columns..][..columns]).map(|row| quote!([#(#row),*]));
    quote!([#(#rows),*])
}

/// The outputs of a program as one array, or as a pair of arrays of these lengths.
fn emit_body(
    model: &Model,
    names: &GeneratedNames,
    motion: &MotionModel,
    program: &Program,
    programs: &MotionPrograms,
    arguments: &[Ident; 3],
    split: &[usize],
) -> TokenStream {
    let (statements, values) = emit_values(model, names, motion, program, programs, arguments);
    match split {
        [first, _] => {
            let (first, second) = values.split_at(*first);
            quote!(#statements ([#(#first),*], [#(#second),*]))
        }
        _ => quote!(#statements [#(#values),*]),
    }
}

/// The statements of a program, and what they make of each output.
pub fn emit_values(
    model: &Model,
    names: &GeneratedNames,
    motion: &MotionModel,
    program: &Program,
    programs: &MotionPrograms,
    [positions, speeds, forces]: &[Ident; 3],
) -> (TokenStream, Vec<TokenStream>) {
    let inputs = Inputs::of_motion(model, motion, programs.constants.outputs.len(), [positions, speeds, forces]);
    let body = Body::of(program, &inputs, model, names, &[]);
    let values = program.outputs.iter().map(|value| body.values[*value].clone()).collect();
    (body.statements(), values)
}

impl Inputs {
    /// Constants, and a state with forces.
    fn of_motion(model: &Model, motion: &MotionModel, constants: usize, arguments: [&Ident; 3]) -> Self {
        let [positions, speeds, forces] = arguments.map(|argument| quote!(#argument));
        let arrays = [quote!(self.constants), positions, speeds, forces];
        let mut inputs = Self { values: Vec::new(), names: Vec::new(), like: 0 };
        for (array, names) in arrays.iter().zip(names_of_inputs(model, motion, constants)) {
            let places = (0..names.len()).map(Literal::usize_unsuffixed);
            inputs.values.extend(places.map(|place| quote!(#array[#place])));
            inputs.names.extend(names);
        }
        inputs
    }
}

fn emit_info(model: &Model, names: &GeneratedNames, motion: &MotionModel) -> TokenStream {
    let runtime = &names.runtime;
    let name = model.name.to_string();
    let MotionModel { positions, wheels, .. } = motion;
    let described = positions.iter().map(|position| {
        let crate::motion::Position { name, label, unit, kind } = position;
        let kind = match kind {
            PositionKind::Free => quote!(Free),
            PositionKind::Dependent => quote!(Dependent),
            PositionKind::Ignorable => quote!(Ignorable),
        };
        quote! {
            #runtime::motion::PositionInfo {
                name: #name,
                label: #label,
                unit: #unit,
                kind: #runtime::motion::PositionKind::#kind,
            }
        }
    });
    let places = |places: Vec<usize>| places.into_iter().map(Literal::usize_unsuffixed);
    let (speeds, dependent) = (places(motion.speeds()), places(motion.dependent()));
    let forces = info::forces(model, names);
    let wheels = wheels.iter().map(|[name, label]| quote!(#runtime::motion::WheelInfo { name: #name, label: #label }));
    quote! {
        &#runtime::motion::MotionInfo {
            model: #name,
            positions: &[#(#described),*],
            speeds: &[#(#speeds),*],
            dependent: &[#(#dependent),*],
            forces: #forces,
            wheels: &[#(#wheels),*],
        }
    }
}

/// What the arrays hold, and what the programs take.
fn describe(motion: &MotionModel, programs: Option<&MotionPrograms>) -> String {
    let positions: Vec<String> = motion
        .positions
        .iter()
        .map(|position| {
            let depends = if position.kind == PositionKind::Dependent { ", by the heights of the wheels" } else { "" };
            format!("`{}` ({}{depends}) in `{}`", position.name, position.label, position.unit)
        })
        .collect();
    let speeds: Vec<String> = motion
        .layout
        .conditions
        .independent
        .iter()
        .filter_map(|joint| motion.layout.positions.iter().position(|position| position == joint))
        .map(|place| format!("`{}`", motion.positions[place].name))
        .collect();
    let mut text = format!("Positions: {}.\nSpeeds: the rates of {}.", positions.join(", "), speeds.join(", "));
    if let Some(programs) = programs {
        let partials = programs.partials.iter();
        let partials =
            partials.flat_map(|all| [("linearization", &all.by_state), ("by parameters", &all.by_parameters)]);
        for (what, program) in [
            ("closure", &programs.closure),
            ("rates", &programs.rates),
            ("derivatives", &programs.derivatives),
            ("accelerations", &programs.accelerations),
            ("energy", &programs.energy),
            ("contact forces", &programs.contact_forces),
        ]
        .into_iter()
        .chain(partials)
        {
            text.push_str(&format!("\n- {what}: {}", Counts::of(program)));
        }
        text = text.replacen("\n- ", "\n\nEach from one straight-line program:\n- ", 1);
    }
    text
}
