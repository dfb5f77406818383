//! The struct of the coefficient matrices, and the function that computes them.

use super::super::evaluator::results;
use super::super::fields::{field_docs, field_name};
use super::body::Body;
use super::comment::block;
use super::template::wrap;
use super::{Context, Precision, counts};
use crate::model::{Model, Origin};

/// The struct and the function.
pub fn declare(context: &Context, precision: Precision) -> String {
    let (model, number, size) = (context.model, precision.number(), &context.size);
    let members = model.matrices.iter().map(|(matrix, _)| {
        let proved = if model.symmetric.contains(matrix) { " Symmetric, proved." } else { "" };
        let docs = block(&format!("{}{proved}", field_docs(*matrix)), 4);
        format!("{docs}    {number} {}[{size}][{size}];\n", field_name(*matrix))
    });
    let members: String = members.collect();
    let what = "The coefficient matrices, row by row, in SI units. Those that are not among them are zero.";
    let does = format!(
        "The coefficient matrices, from one straight-line program:\n{}.\n\n@param[in] p The parameters, which are not \
         validated.{}\n@param[out] matrices The matrices.",
        counts(&context.programs.matrices),
        needs(model),
    );
    format!(
        "{}typedef struct {{\n{members}}} {};\n\n{}{};\n\n",
        block(what, 0),
        type_name(context, precision),
        block(&does, 0),
        signature(context, precision)
    )
}

/// What the matrices need beside parameters in their domains.
fn needs(model: &Model) -> String {
    let needs = model.requirements.iter().any(|requirement| requirement.origin == Origin::Matrices);
    let text = " Some requirements are what the program divides by\nor takes the root of.";
    if needs { text.to_string() } else { String::new() }
}

/// The type of the matrices.
pub fn type_name(context: &Context, precision: Precision) -> String {
    context.name(precision, "matrices_t")
}

fn signature(context: &Context, precision: Precision) -> String {
    format!(
        "void {}(const {} *p, {} *matrices)",
        context.name(precision, "matrices"),
        context.parameters(precision),
        type_name(context, precision)
    )
}

/// The function.
pub fn define(context: &Context, precision: Precision) -> String {
    let program = &context.programs.matrices;
    let body = context.body(program, precision, &results(context.model, program), &["matrices"]);
    let reads = if body.reads_parameters() { "" } else { "    (void)p;\n" };
    format!(
        "{}\n{{\n{reads}{}{}}}\n",
        signature(context, precision),
        body.statements(4),
        assign(context.model, &body, &program.outputs)
    )
}

/// The first of the outputs as the entries of the struct that `matrices` points to.
pub fn assign(model: &Model, body: &Body, outputs: &[usize]) -> String {
    let size = model.coordinates.len();
    let places = (0..size).flat_map(|row| (0..size).map(move |column| (row, column)));
    let fields = model.matrices.iter().map(|(matrix, _)| field_name(*matrix));
    let entries = fields.flat_map(|field| places.clone().map(move |place| (field, place)));
    let assignments = entries.zip(outputs).map(|((field, (row, column)), value)| {
        wrap(&format!("matrices->{field}[{row}][{column}] = {};", body.values[*value]), 4)
    });
    assignments.collect()
}
