//! The struct of the parameters, and the parameter sets as tables of constants.

use super::comment::{block, of_parameter, of_set};
use super::names::identifier;
use super::template::define_texts;
use super::{Context, Precision};

/// The positions of the parameter sets, the same for both kinds of numbers.
pub fn declare_sets(context: &Context) -> String {
    let (lower, upper) = (context.prefix.lower(), context.prefix.upper());
    let sets = &context.model.sets;
    if sets.is_empty() {
        return String::new();
    }
    let constants: String = sets
        .iter()
        .enumerate()
        .map(|(position, set)| {
            let name = identifier(&set.name.to_string()).to_uppercase();
            let comma = if position + 1 < sets.len() { "," } else { "" };
            format!("{}    {upper}_SET_{name} = {position}{comma}\n", block(&of_set(set), 4))
        })
        .collect();
    format!(
        "{}typedef enum {{\n{constants}}} {lower}_set_t;\n\n{}#define {upper}_SETS {}U\n\n{}{};\n\n",
        block("The parameter sets, by their positions in the tables of them.", 0),
        block("How many parameter sets there are.", 0),
        sets.len(),
        block("The name of a parameter set, as it is declared; a text of its own for what is none.", 0),
        name_signature(context),
    )
}

fn name_signature(context: &Context) -> String {
    let lower = context.prefix.lower();
    format!("const char *{lower}_set_name({lower}_set_t set)")
}

/// The names of the sets.
pub fn define_names(context: &Context) -> String {
    let names = context.model.sets.iter().map(|set| set.name.to_string());
    if context.model.sets.is_empty() {
        return String::new();
    }
    format!("\n{}", define_texts(&name_signature(context), "set", names, "no such set"))
}

/// The struct, and that there are sets of it.
pub fn declare(context: &Context, precision: Precision) -> String {
    let (number, name) = (precision.number(), context.parameters(precision));
    let members: String = context
        .model
        .parameters
        .iter()
        .zip(&context.fields)
        .map(|(parameter, field)| format!("{}    {number} {field};\n", block(&of_parameter(parameter), 4)))
        .collect();
    let what = format!("The parameters of `{}`.", context.model.name);
    let mut text = format!("{}typedef struct {{\n{members}}} {name};\n\n", block(&what, 0));
    if !context.model.sets.is_empty() {
        let upper = context.prefix.upper();
        let what = format!(
            "The parameter sets, such as `{}[{upper}_SET_{}]`.",
            context.name(precision, "sets"),
            first(context)
        );
        text.push_str(&format!(
            "{}extern const {name} {}[{upper}_SETS];\n\n",
            block(&what, 0),
            context.name(precision, "sets")
        ));
    }
    text
}

fn first(context: &Context) -> String {
    identifier(&context.model.sets[0].name.to_string()).to_uppercase()
}

/// The sets, each value rounded to the nearest.
pub fn define(context: &Context, precision: Precision) -> String {
    let sets = &context.model.sets;
    if sets.is_empty() {
        return String::new();
    }
    let tables: Vec<String> = sets
        .iter()
        .map(|set| {
            let members: Vec<String> = context
                .fields
                .iter()
                .zip(&set.values)
                .map(|(field, value)| format!("        .{field} = {}", precision.literal(*value)))
                .collect();
            format!("    {{ /* {} */\n{}\n    }}", set.name, members.join(",\n"))
        })
        .collect();
    format!(
        "const {} {}[{}_SETS] = {{\n{}\n}};\n",
        context.parameters(precision),
        context.name(precision, "sets"),
        context.prefix.upper(),
        tables.join(",\n")
    )
}
