//! The equations of motion at a speed, and their state-space form.

use super::super::fields::field_name;
use super::template::fill;
use super::{Context, Precision, matrices};
use crate::matrix_name::MatrixName;
use crate::model::Model;
use crate::states::States;

/// The structs and the functions.
pub fn declare(context: &Context, precision: Precision) -> String {
    let model = context.model;
    let of_speed = depends_on_speed(model);
    let nonzero = if has(model, MatrixName::Cm1) { ", not 0" } else { "" };
    let mut arguments = String::new();
    if of_speed {
        arguments.push_str(&format!(
            " * @param[in] speed The forward speed v in m/s{nonzero}; below 0 it runs backwards.\n"
        ));
    }
    if has(model, MatrixName::K0) {
        arguments.push_str(" * @param[in] gravity The gravitational field strength g in N/kg.\n");
    }
    let states = if is_of_second_order(model) { "" } else { STATES };
    let fields = fields(context, precision);
    let all: Vec<(&str, &str)> = fields
        .iter()
        .map(|(name, value)| (*name, value.as_str()))
        .chain([
            ("arguments", &*arguments),
            ("at_one_speed", if of_speed { " at one speed" } else { "" }),
            ("states", states),
        ])
        .collect();
    fill(include_str!("templates/system.h"), &all)
}

const STATES: &str = " *
 * Where only the position or only the rate of a coordinate is a state, the row and the column of the other one are zero.
 * They are no part of the motion: leave them out before you ask for eigenvalues.
";

/// Both functions: the sums in the same order as in the runtime, without those matrices that there are not.
pub fn define(context: &Context, precision: Precision) -> String {
    let (model, size) = (context.model, &context.size);
    let zero = precision.literal(0.0);
    let finite = |value: &str| format!("carvallo_is_finite_{}({value})", precision.name());
    let of_speed = depends_on_speed(model).then(|| finite("speed"));
    let of_gravity = has(model, MatrixName::K0).then(|| finite("gravity"));
    let given: Vec<String> = of_speed.into_iter().chain(of_gravity).collect();
    let given = if given.is_empty() { "true".to_string() } else { given.join(" && ") };
    let entries: String = model.matrices.iter().map(|(matrix, _)| format!(" && {}", finite(&entry(*matrix)))).collect();
    let damping =
        sum(model, &zero, &[(MatrixName::C0, ""), (MatrixName::C1, " * speed"), (MatrixName::Cm1, "divided")]);
    let stiffness = sum(
        model,
        &zero,
        &[
            (MatrixName::Kc, ""),
            (MatrixName::K0, " * gravity"),
            (MatrixName::K2, " * speed * speed"),
            (MatrixName::K1, " * speed"),
        ],
    );
    let mut all = fields(context, precision);
    all.extend([("given", given), ("entries", entries), ("damping", damping), ("stiffness", stiffness)]);
    let all: Vec<(&str, &str)> = all.iter().map(|(name, value)| (*name, value.as_str())).collect();
    let divided = fill(include_str!("templates/divided.c"), &all);
    let flag = format!("    const bool moves = (speed < {zero}) || (speed > {zero});\n    bool is_at_rest = false;\n");
    let at_rest = "    } else if (is_at_rest) {\n        error = CARVALLO_SYSTEM_AT_REST;\n";
    let of_cm1 = if has(model, MatrixName::Cm1) { [&*flag, &*divided, at_rest] } else { [""; 3] };
    let target = if is_of_second_order(model) { format!("{size} + row") } else { "TARGETS[row]".to_string() };
    let [tables, columns, rates] = states(context, precision);
    let rest = [
        ("flag", of_cm1[0]),
        ("divided", of_cm1[1]),
        ("at_rest", of_cm1[2]),
        ("target", &*target),
        ("tables", &*tables),
        ("columns", &*columns),
        ("rates", &*rates),
    ];
    let all = [&all[..], &rest].concat();
    let [at_speed, space] = [include_str!("templates/at_speed.c"), include_str!("templates/state_space.c")];
    format!("{}\n{}", fill(at_speed, &all), fill(space, &all))
}

/// What all templates have places for.
fn fields(context: &Context, precision: Precision) -> Vec<(&'static str, String)> {
    let (model, number) = (context.model, precision.number());
    let speed = if depends_on_speed(model) { format!("{number} speed, ") } else { String::new() };
    let gravity = if has(model, MatrixName::K0) { format!("{number} gravity, ") } else { String::new() };
    let name = format!("{}_{}", context.prefix.lower(), precision.name());
    let what = if depends_on_speed(model) { "at_speed" } else { "system" };
    let matrices = matrices::type_name(context, precision);
    vec![
        (
            "at_speed",
            format!(
                "carvallo_system_error_t {name}_{what}(const {matrices} *matrices, {speed}{gravity}{name}_system_t *system)"
            ),
        ),
        ("N", context.size.clone()),
        ("name", name),
        ("number", number.to_string()),
        ("kind", precision.name().to_string()),
        ("finite", format!("carvallo_is_finite_{}", precision.name())),
        ("zero", precision.literal(0.0)),
        ("one", precision.literal(1.0)),
    ]
}

fn has(model: &Model, wanted: MatrixName) -> bool {
    model.matrices.iter().any(|(matrix, _)| *matrix == wanted)
}

fn depends_on_speed(model: &Model) -> bool {
    [MatrixName::Cm1, MatrixName::C1, MatrixName::K1, MatrixName::K2].into_iter().any(|matrix| has(model, matrix))
}

fn is_of_second_order(model: &Model) -> bool {
    model.coordinates.iter().all(|coordinate| coordinate.states == States::Both)
}

fn entry(matrix: MatrixName) -> String {
    format!("matrices->{}[row][column]", field_name(matrix))
}

/// The sum of those matrices that there are, each times its factor.
fn sum(model: &Model, zero: &str, terms: &[(MatrixName, &str)]) -> String {
    let terms = terms.iter().filter(|(matrix, _)| has(model, *matrix)).map(|(matrix, factor)| match *factor {
        "" => entry(*matrix),
        "divided" => "divided".to_string(),
        factor => format!("({}{factor})", entry(*matrix)),
    });
    let terms: Vec<String> = terms.collect();
    match &terms[..] {
        [] => zero.to_string(),
        [only] => only.trim_matches(['(', ')']).to_string(),
        all => all.join(" + "),
    }
}

/// Of the state-space form: tables of rows, what becomes of the columns of what is no state, and the rates of positions.
fn states(context: &Context, precision: Precision) -> [String; 3] {
    let (model, size) = (context.model, &context.size);
    let (zero, one) = (precision.literal(0.0), precision.literal(1.0));
    let rate = format!("            space->a[row][{size} + row] = {one};\n");
    if is_of_second_order(model) {
        return [String::new(), String::new(), rate];
    }
    let coordinates = || model.coordinates.iter().map(|coordinate| coordinate.states).enumerate();
    let column = |(column, states)| match states {
        States::Both => String::new(),
        // Its rate is what is solved for.
        States::Position => format!(
            "        m[(row * {size}) + {column}U] = system->c[row][{column}];\n        solved[{size} + {column}U] = {zero};\n"
        ),
        States::Rate => format!("        solved[{column}] = {zero};\n"),
    };
    let targets = coordinates().map(|(row, states)| match states {
        States::Position => format!("{row}U"),
        States::Both | States::Rate => format!("{size} + {row}U"),
    });
    let targets: Vec<String> = targets.collect();
    let both: Vec<String> = coordinates().map(|(_, states)| (states == States::Both).to_string()).collect();
    let tables = format!(
        "    /* The row of A and B for each coordinate, and whether its position is a state beside its rate. */\n    \
         static const size_t TARGETS[{size}] = {{{}}};\n    static const bool HAS_BOTH[{size}] = {{{}}};\n",
        targets.join(", "),
        both.join(", "),
    );
    let rates = format!("            if (HAS_BOTH[row]) {{\n    {rate}            }}\n");
    [tables, coordinates().map(column).collect(), rates]
}
