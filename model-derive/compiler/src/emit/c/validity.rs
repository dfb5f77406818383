//! Whether parameters are valid: a code for each parameter and each requirement, its text, and the function that looks.

use super::comment::{block, in_unit, of_requirement, required};
use super::template::define_texts;
use super::{Context, Precision};
use crate::domain::Domain;

/// The codes.
pub fn declare(context: &Context) -> String {
    let (upper, type_name) = (context.prefix.upper(), type_name(context));
    let codes = codes(context);
    let last = codes.len();
    let constants = codes.iter().enumerate().map(|(position, code)| {
        let comma = if position + 1 < last { "," } else { "" };
        format!("{}    {} = {}{comma}\n", block(&code.docs, 4), code.name, position + 1)
    });
    let constants: String = constants.collect();
    let valid = block("They are valid.", 4);
    let comma = if last > 0 { "," } else { "" };
    format!(
        "{}typedef enum {{\n{valid}    {upper}_VALID = 0{comma}\n{constants}}} {type_name};\n\n{}const char *{}({type_name} validity);\n\n",
        block(
            "What is wrong with parameters: the first that is outside its domain, or the first requirement that does not hold.",
            0
        ),
        block(
            "What a code means, in English, with the values that are allowed; a text of its own for what is no code.",
            0
        ),
        text_function(context),
    )
}

/// That there is a function.
pub fn declare_function(context: &Context, precision: Precision) -> String {
    let what = "Whether parameters are valid, which no other function looks at: with those that are not, results may be \
                infinite or\nno numbers.\n\n@param[in] p The parameters.\n@return The first thing that is wrong.";
    format!("{}{};\n\n", block(what, 0), signature(context, precision))
}

fn signature(context: &Context, precision: Precision) -> String {
    format!(
        "{} {}(const {} *p)",
        type_name(context),
        context.name(precision, "validate"),
        context.parameters(precision)
    )
}

fn type_name(context: &Context) -> String {
    format!("{}_validity_t", context.prefix.lower())
}

fn text_function(context: &Context) -> String {
    format!("{}_validity_text", context.prefix.lower())
}

/// A code: its name, its documentation, and its text.
struct Code {
    name: String,
    docs: String,
    text: String,
}

fn codes(context: &Context) -> Vec<Code> {
    let (model, upper) = (context.model, context.prefix.upper());
    let text = |subject: &str, unit: &str, domain: Domain| {
        format!("{}: {subject}{} must be {}", model.name, in_unit(unit), required(domain))
    };
    let parameters = model.parameters.iter().zip(&context.fields).map(|(parameter, field)| Code {
        name: format!("{upper}_INVALID_{field}"),
        docs: format!("`{}`{} must be {}.", parameter.name, in_unit(&parameter.unit), required(parameter.domain)),
        text: text(&parameter.name.to_string(), &parameter.unit, parameter.domain),
    });
    let requirements = model.requirements.iter().enumerate().map(|(position, requirement)| Code {
        name: format!("{upper}_REQUIREMENT_{}", position + 1),
        docs: of_requirement(requirement),
        text: text(&requirement.text, &requirement.unit, requirement.domain),
    });
    parameters.chain(requirements).collect()
}

/// The texts of the codes.
pub fn define_text(context: &Context) -> String {
    let valid = format!("{}: the parameters are valid", context.model.name);
    let texts = [valid].into_iter().chain(codes(context).into_iter().map(|code| code.text));
    let signature = format!("const char *{}({} validity)", text_function(context), type_name(context));
    format!("\n{}", define_texts(&signature, "validity", texts, "no such code"))
}

/// The function that looks.
pub fn define(context: &Context, precision: Precision) -> String {
    let (model, codes) = (context.model, codes(context));
    let (of_parameters, of_requirements) = codes.split_at(model.parameters.len());
    let parameters =
        model.parameters.iter().zip(&context.fields).zip(of_parameters).map(|((parameter, field), code)| {
            (precision.condition(parameter.domain, &format!("p->{field}")), &*code.name)
        });
    let body = context.body(&context.programs.requirements, precision, &[], &["validity"]);
    let requirements = model.requirements.iter().zip(&context.programs.requirements.outputs).zip(of_requirements);
    let requirements = requirements
        .map(|((requirement, value), code)| (precision.condition(requirement.domain, &body.atom(*value)), &*code.name));
    let requirements: Vec<_> = requirements.collect();
    let rest = if requirements.is_empty() {
        "        /* All are in their domains. */\n".to_string()
    } else {
        let otherwise = "            /* All requirements hold. */\n";
        format!("{}{}", body.statements(8), chain(requirements, 8, otherwise))
    };
    let parameters = chain(parameters, 4, &rest);
    format!(
        "{}\n{{\n    {} validity = {}_VALID;\n{parameters}    return validity;\n}}\n",
        signature(context, precision),
        type_name(context),
        context.prefix.upper(),
    )
}

/// Conditions one after the other, with what is wrong if they do not hold, and what comes after them all.
fn chain<'a>(conditions: impl IntoIterator<Item = (String, &'a str)>, indent: usize, otherwise: &str) -> String {
    let space = " ".repeat(indent);
    let mut text = String::new();
    for (position, (condition, code)) in conditions.into_iter().enumerate() {
        let before = if position == 0 { space.clone() } else { format!("{space}}} else ") };
        text.push_str(&format!("{before}if (!({condition})) {{\n{space}    validity = {code};\n"));
    }
    format!("{text}{space}}} else {{\n{otherwise}{space}}}\n")
}
