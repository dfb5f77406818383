//! The struct of the derivatives of the matrices, which value is which derivative, and the functions that compute them.

use super::super::evaluator::results;
use super::super::fields::field_name;
use super::super::with_respect_to::tell_asked;
use super::comment::block;
use super::template::{fill, wrap};
use super::{Context, Precision, counts, matrices};
use crate::derivatives::{Derivatives, Partial, entry_names};
use crate::model::Model;

/// That there is a table; nothing for a model without derivatives.
pub fn declare_table(context: &Context) -> String {
    let Some(derivatives) = &context.programs.derivatives else { return String::new() };
    let upper = context.prefix.upper();
    format!(
        "{}#define {upper}_PARTIALS {}U\n\n{}extern const carvallo_partial_t {}[{upper}_PARTIALS];\n\n",
        block("How many derivatives are not zero for all parameters.", 0),
        derivatives.partials.len(),
        block("Which derivatives there are, by parameters, and where their values stand.", 0),
        table_name(context)
    )
}

/// The table.
pub fn define_table(context: &Context) -> String {
    let Some(derivatives) = &context.programs.derivatives else { return String::new() };
    let n = context.model.coordinates.len();
    let rows = derivatives.partials.iter().map(|&Partial { entry, parameter, value, negative }| {
        let matrix = context.model.matrices[entry / (n * n)].0.identifier().to_uppercase();
        let (row, column) = (entry / n % n, entry % n);
        format!("    {{CARVALLO_MATRIX_{matrix}, {row}U, {column}U, {parameter}U, {value}U, {negative}}}")
    });
    let rows: Vec<String> = rows.collect();
    let upper = context.prefix.upper();
    format!("\nconst carvallo_partial_t {}[{upper}_PARTIALS] = {{\n{}\n}};\n", table_name(context), rows.join(",\n"))
}

fn table_name(context: &Context) -> String {
    format!("{}_partials", context.prefix.lower())
}

/// The struct and the functions.
pub fn declare(context: &Context, precision: Precision) -> String {
    let Some(derivatives) = &context.programs.derivatives else { return String::new() };
    let name = context.name(precision, "derivatives");
    let what = format!(
        "The derivatives of the matrices with respect to the parameters, in SI units: those that are not zero for all\n\
         parameters, each value once. Which is which is said by `{}`.{}",
        table_name(context),
        context.model.derivatives.as_ref().map(|asked| tell_asked(context.model, asked)).unwrap_or_default()
    );
    let does = format!(
        "The coefficient matrices and their derivatives, from one straight-line program:\n{}.\n\n@param[in] p The \
         parameters, which are not validated; at valid ones every derivative exists.\n@param[out] matrices The matrices.\n\
         @param[out] derivatives The derivatives.",
        counts(&derivatives.program)
    );
    format!(
        "{}typedef struct {{\n    {} values[{}];\n}} {name}_t;\n\n{}{};\n\n{}",
        block(&what, 0),
        precision.number(),
        count_values(derivatives),
        block(&does, 0),
        signature(context, precision),
        declare_with_respect_to(context, precision)
    )
}

/// Nothing where not all derivatives are asked for: what is not there could not be told from zeros.
fn declare_with_respect_to(context: &Context, precision: Precision) -> String {
    if !has_all(context.model) {
        return String::new();
    }
    let what = "The derivatives of all matrices with respect to one parameter, with the zeros filled in.\n\n@param[in] derivatives \
         The derivatives.\n@param[in] parameter The position of the parameter in declared order, from 0; beyond the last \
         all are zero.\n@param[out] matrices The derivatives of the matrices.";
    let signature = format!(
        "void {}(const {}_t *derivatives, size_t parameter, {} *matrices)",
        context.name(precision, "with_respect_to"),
        context.name(precision, "derivatives"),
        matrices::type_name(context, precision)
    );
    format!("{}{};\n\n", block(what, 0), wrap(&signature, 0).trim_end())
}

fn has_all(model: &Model) -> bool {
    model.derivatives.as_ref().is_some_and(|asked| asked.is_all(model))
}

fn count_values(derivatives: &Derivatives) -> usize {
    derivatives.partials.iter().map(|partial| partial.value + 1).max().unwrap_or(0)
}

fn signature(context: &Context, precision: Precision) -> String {
    let name = context.name(precision, "derivatives");
    let signature = format!(
        "void {name}(const {} *p, {} *matrices, {name}_t *derivatives)",
        context.parameters(precision),
        matrices::type_name(context, precision)
    );
    wrap(&signature, 0).trim_end().to_string()
}

/// The functions.
pub fn define(context: &Context, precision: Precision) -> String {
    let Some(derivatives) = &context.programs.derivatives else { return String::new() };
    let (model, program) = (context.model, &derivatives.program);
    let entries = model.matrices.len() * model.coordinates.len().pow(2);
    let body = context.body(program, precision, &names_of_results(model, derivatives), &["matrices", "derivatives"]);
    let values = program.outputs[entries..]
        .iter()
        .enumerate()
        .map(|(position, value)| wrap(&format!("derivatives->values[{position}] = {};", body.values[*value]), 4));
    let values: String = values.collect();
    format!(
        "{}\n{{\n{}{}{values}}}\n\n{}",
        signature(context, precision),
        body.statements(4),
        matrices::assign(model, &body, &program.outputs),
        with_respect_to(context, precision)
    )
}

fn names_of_results(model: &Model, derivatives: &Derivatives) -> Vec<(usize, String)> {
    let program = &derivatives.program;
    let entries = entry_names(model);
    let partials = derivatives.partials.iter().filter(|partial| !partial.negative).map(|partial| {
        let name = format!("{}_{}", entries[partial.entry], model.parameters[partial.parameter].name);
        (program.outputs[entries.len() + partial.value], name)
    });
    results(model, program).into_iter().chain(partials).collect()
}

fn with_respect_to(context: &Context, precision: Precision) -> String {
    if !has_all(context.model) {
        return String::new();
    }
    let upper = context.prefix.upper();
    let zero = precision.literal(0.0);
    let fields =
        || context.model.matrices.iter().map(|(matrix, _)| (matrix.identifier().to_uppercase(), field_name(*matrix)));
    let zeros: String =
        fields().map(|(_, field)| format!("            matrices->{field}[row][column] = {zero};\n")).collect();
    let case = |(matrix, field): (String, &str)| {
        format!(
            "            case CARVALLO_MATRIX_{matrix}:\n                \
             matrices->{field}[partial->row][partial->column] = signed_value;\n                break;\n"
        )
    };
    let cases: String = fields().map(case).collect();
    let name = format!("{}_{}", context.prefix.lower(), precision.name());
    fill(
        include_str!("templates/derivatives.c"),
        &[
            ("name", &name),
            ("N", &context.size),
            ("number", precision.number()),
            ("count", &format!("{upper}_PARTIALS")),
            ("partials", &table_name(context)),
            ("zeros", &zeros),
            ("cases", &cases),
        ],
    )
}
