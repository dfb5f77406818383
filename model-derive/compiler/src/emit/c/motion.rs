//! The nonlinear equations of motion: what positions, speeds, forces and wheels are called, and the functions that compute
//! what the programs of the model do.

use super::super::inputs::names_of_inputs;
use super::body::Body;
use super::comment::{block, quoted};
use super::names::identifier;
use super::template::{define_texts, fill, wrap};
use super::{Context, Precision, counts};
use crate::kinematics::Applied;
use crate::motion::{MotionModel, PositionKind};
use crate::nonlinear::MotionPrograms;
use crate::program::{Instruction, Program};

/// What functions of a state take.
const OF_STATE: &[&str] = &["motion", "positions", "speeds"];
pub const WITH_FORCES: &[&str] = &["motion", "positions", "speeds", "forces"];

/// Positions, speeds, forces or wheels: what has a place in an array.
struct Places {
    /// What each is.
    what: &'static str,
    docs: &'static str,
    /// The name of each, and what it is.
    all: Vec<(String, String)>,
}

impl Places {
    /// Those of which there are any; nothing for a model without nonlinear equations.
    fn of(context: &Context) -> Vec<Self> {
        let Some((motion, _)) = find(context) else { return Vec::new() };
        let positions = motion.positions.iter().map(|position| {
            let by_heights =
                if position.kind == PositionKind::Dependent { ", by the heights of the wheels" } else { "" };
            (position.name.clone(), format!("{}{by_heights}, in {}", position.label, position.unit))
        });
        let speeds = motion.speeds().into_iter().map(|place| {
            let position = &motion.positions[place];
            (position.name.clone(), format!("The rate of `{}`, in {}/s", position.name, position.unit))
        });
        let forces =
            applied(context).map(|Applied { name, label, unit, .. }| (name.clone(), format!("{label}, in {unit}")));
        let wheels = motion.wheels.iter().map(|[name, label]| (name.clone(), label.clone()));
        let places = |what, docs, all: Vec<(String, String)>| Self { what, docs, all };
        let all = [
            places(
                "position",
                "The place of a position among the positions, of which each joint has one.",
                positions.collect(),
            ),
            places(
                "speed",
                "The place of a speed among the speeds, the rates that rolling leaves free.",
                speeds.collect(),
            ),
            places("force", "The place of a force or torque among those that may be applied.", forces.collect()),
            places("wheel", "The place of a wheel among the contact forces.", wheels.collect()),
        ];
        all.into_iter().filter(|places| !places.all.is_empty()).collect()
    }

    fn declare(&self, context: &Context) -> String {
        let Self { what, docs, all } = self;
        let (upper, count, kind) = (context.prefix.upper(), all.len(), what.to_uppercase());
        let places = all.iter().enumerate().map(|(place, (name, docs))| {
            let comma = if place + 1 < count { "," } else { "" };
            format!("{}    {upper}_{kind}_{} = {place}{comma}\n", block(&quoted(docs), 4), identifier(name))
        });
        format!(
            "{}typedef enum {{\n{}}} {}_{what}_t;\n\n{}#define {upper}_{kind}S {count}U\n\n{}{};\n\n",
            block(docs, 0),
            places.collect::<String>(),
            context.prefix.lower(),
            block(&format!("How many {what}s there are."), 0),
            block(&format!("The name of a {what}; a text of its own for what is none."), 0),
            self.signature(context),
        )
    }

    fn define(&self, context: &Context) -> String {
        let names = self.all.iter().map(|(name, _)| name.clone());
        format!("\n{}", define_texts(&self.signature(context), "which", names, &format!("no such {}", self.what)))
    }

    fn signature(&self, context: &Context) -> String {
        let (lower, what) = (context.prefix.lower(), self.what);
        format!("const char *{lower}_{what}_name({lower}_{what}_t which)")
    }
}

/// How many positions, speeds, forces and wheels there are, and which is which.
pub fn declare_places(context: &Context) -> String {
    Places::of(context).iter().map(|places| places.declare(context)).collect()
}

/// Their names.
pub fn define_names(context: &Context) -> String {
    Places::of(context).iter().map(|places| places.define(context)).collect()
}

/// The struct and the functions.
pub fn declare(context: &Context, precision: Precision) -> String {
    let Some((motion, programs)) = find(context) else { return String::new() };
    let values = values(context, precision, motion, programs);
    let mut text = fill(include_str!("templates/motion.h"), &borrowed(&values));
    if !motion.layout.standing.is_empty() {
        text.push_str(&fill(include_str!("templates/close.h"), &borrowed(&values)));
    }
    if !motion.wheels.is_empty() {
        text.push_str(&fill(include_str!("templates/contact_forces.h"), &borrowed(&values)));
    }
    text
}

/// The functions.
pub fn define(context: &Context, precision: Precision) -> String {
    let Some((motion, programs)) = find(context) else { return String::new() };
    let values = values(context, precision, motion, programs);
    let body = |program: &Program, arguments: &[&str], outputs: &[(&str, usize)]| {
        compute(context, precision, program, arguments, outputs)
    };
    let sizes = [motion.positions.len(), motion.speeds().len()];
    let of_constants = {
        let body = context.body(&programs.constants, precision, &[], &["motion"]);
        let reads = if body.reads_parameters() { "" } else { "    (void)p;\n" };
        let constants = assign(&body, &programs.constants, &[("motion->constants", programs.constants.outputs.len())]);
        format!("{reads}{}{constants}", body.statements(4))
    };
    let parts = [
        ("compute_constants", of_constants),
        ("compute_rates", body(&programs.rates, OF_STATE, &[("rates", sizes[0])])),
        (
            "compute_derivatives",
            body(&programs.derivatives, WITH_FORCES, &[("rates", sizes[0]), ("speed_rates", sizes[1])]),
        ),
        ("compute_accelerations", body(&programs.accelerations, WITH_FORCES, &[("accelerations", sizes[0])])),
        ("compute_energy", body(&programs.energy, OF_STATE, &[("energy", 2)])),
    ];
    let all = [&values[..], &parts].concat();
    let mut text = fill(include_str!("templates/motion.c"), &borrowed(&all));
    let dependent = motion.layout.standing.len();
    if dependent > 0 {
        let compute = body(&programs.closure, &OF_STATE[..2], &[("below", dependent), ("steps", dependent)]);
        let all = [&values[..], &[("compute_closure", compute)]].concat();
        text.push_str(&format!("\n{}", fill(include_str!("templates/close.c"), &borrowed(&all))));
    }
    if !motion.wheels.is_empty() {
        let compute = body(&programs.contact_forces, WITH_FORCES, &[("contact_forces", 3 * motion.wheels.len())]);
        let all = [&values[..], &[("compute_contact_forces", compute)]].concat();
        text.push_str(&format!("\n{}", fill(include_str!("templates/contact_forces.c"), &borrowed(&all))));
    }
    text
}

pub fn find<'a>(context: &'a Context) -> Option<(&'a MotionModel, &'a MotionPrograms)> {
    context.model.motion.as_ref().zip(context.programs.motion.as_ref())
}

pub fn applied<'a>(context: &'a Context) -> impl Iterator<Item = &'a Applied> {
    context.model.kinematics.iter().flat_map(|kinematics| &kinematics.applied)
}

/// What all templates have places for.
pub fn values(
    context: &Context,
    precision: Precision,
    motion: &MotionModel,
    programs: &MotionPrograms,
) -> Vec<(&'static str, String)> {
    let (upper, number) = (context.prefix.upper(), precision.number());
    let name = format!("{}_{}", context.prefix.lower(), precision.name());
    let dependent: Vec<String> = motion.dependent().iter().map(|place| format!("{place}U")).collect();
    let has_forces = applied(context).next().is_some();
    let finite = format!("carvallo_are_finite_{}", precision.name());
    let literal = |value: f64| precision.literal(value);
    vec![
        ("number", number.to_string()),
        ("finite", finite.clone()),
        ("one_finite", format!("carvallo_is_finite_{}", precision.name())),
        ("absolute", precision.function("fabs")),
        ("epsilon", if precision == Precision::Double { "DBL_EPSILON" } else { "FLT_EPSILON" }.to_string()),
        ("parameters", context.parameters(precision)),
        ("P", format!("{upper}_POSITIONS")),
        ("S", format!("{upper}_SPEEDS")),
        ("STATES", format!("{upper}_STATES")),
        ("PARAMETERS", format!("{upper}_PARAMETERS")),
        ("W", format!("{upper}_WHEELS")),
        ("D", format!("{}U", dependent.len())),
        ("dependent", dependent.join(", ")),
        ("constants", format!("{}U", programs.constants.outputs.len().max(1))),
        ("forces", if has_forces { format!(", const {number} forces[{upper}_FORCES]") } else { String::new() }),
        (
            "forces_docs",
            if has_forces {
                " * @param[in] forces The applied forces, each positive as the position that it acts on.\n"
            } else {
                ""
            }
            .to_string(),
        ),
        ("forces_finite", if has_forces { format!(" && {finite}(forces, {upper}_FORCES)") } else { String::new() }),
        ("pass_forces", if has_forces { ", forces" } else { "" }.to_string()),
        ("zero", literal(0.0)),
        ("one", literal(1.0)),
        ("four", literal(4.0)),
        ("longest_step", literal(0.25)),
        ("near", literal(1e-5)),
        ("largest", literal(1e30)),
        ("count_constants", counts(&programs.constants)),
        ("count_rates", counts(&programs.rates)),
        ("count_derivatives", counts(&programs.derivatives)),
        ("count_accelerations", counts(&programs.accelerations)),
        ("count_energy", counts(&programs.energy)),
        ("count_contact_forces", counts(&programs.contact_forces)),
        ("name", name),
    ]
}

pub fn borrowed<'a>(values: &'a [(&'static str, String)]) -> Vec<(&'a str, &'a str)> {
    values.iter().map(|(name, value)| (*name, value.as_str())).collect()
}

/// The statements of a program of a state, with its results in arrays of these lengths; what it does not read is said.
pub fn compute(
    context: &Context,
    precision: Precision,
    program: &Program,
    arguments: &[&str],
    outputs: &[(&str, usize)],
) -> String {
    let Some((motion, programs)) = find(context) else { return String::new() };
    let names = names_of_inputs(context.model, motion, programs.constants.outputs.len());
    let arrays =
        [("motion", "motion->constants"), ("positions", "positions"), ("speeds", "speeds"), ("forces", "forces")];
    let (mut reads, mut inputs, mut unused) = (Vec::new(), Vec::new(), String::new());
    for ((argument, array), names) in arrays.into_iter().zip(names) {
        let range = reads.len()..reads.len() + names.len();
        let is_read =
            |instruction: &Instruction| matches!(instruction, Instruction::Parameter(at) if range.contains(at));
        let is_argument = !(names.is_empty() && argument == "forces") && arguments.contains(&argument);
        if is_argument && !program.instructions.iter().any(is_read) {
            unused.push_str(&format!("    (void){argument};\n"));
        }
        reads.extend((0..names.len()).map(|index| format!("{array}[{index}]")));
        inputs.extend(names);
    }
    let variable = context.names.values(program, context.model, &inputs, &[]);
    // Of what stands in a struct the name of the struct.
    let results = outputs.iter().filter_map(|(array, _)| array.split(['-', '[']).next());
    let taken: Vec<&str> = arguments.iter().copied().chain(results).collect();
    let body = Body::new(program, precision, &taken, |index| reads[index].clone(), |value| variable(value).to_string());
    format!("{unused}{}{}", body.statements(4), assign(&body, program, outputs))
}

fn assign(body: &Body, program: &Program, outputs: &[(&str, usize)]) -> String {
    let mut values = program.outputs.iter();
    let mut text = String::new();
    for (array, length) in outputs {
        for (place, value) in values.by_ref().take(*length).enumerate() {
            text.push_str(&wrap(&format!("{array}[{place}] = {};", body.values[*value]), 4));
        }
    }
    text
}
