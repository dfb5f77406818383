//! A program of C that reads parameters and prints what the generated functions make of them.

use super::expected::Expected;
use super::motion::{Motions, STATES};

const HEAD: &str = r#"
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

static uint64_t read_word(void)
{
    uint64_t word = 0;
    if (scanf("%" SCNx64, &word) != 1) {
        puts("the input ends");
    }
    return word;
}

static double read_f64(void)
{
    const uint64_t word = read_word();
    double value;
    memcpy(&value, &word, sizeof value);
    return value;
}

static float read_f32(void)
{
    const uint32_t word = (uint32_t)read_word();
    float value;
    memcpy(&value, &word, sizeof value);
    return value;
}

/* With one zero for both. */
static void print_f64(const double values[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const double value = values[i] + 0.0;
        uint64_t word;
        memcpy(&word, &value, sizeof word);
        printf("%" PRIx64 "\n", word);
    }
}

static void print_f32(const float values[], size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const float value = values[i] + 0.0F;
        uint32_t word;
        memcpy(&word, &value, sizeof word);
        printf("%" PRIx32 "\n", word);
    }
}
"#;

/// What is done with one design in one precision. Structs of numbers of one kind are arrays of them.
const DESIGN: &str = r#"
static PREFIX_KIND_t PREFIX_KIND_read(void)
{
    PREFIX_KIND_t p;
    NUMBER *const parameters = (NUMBER *)&p;
    for (size_t i = 0; i < sizeof p / sizeof(NUMBER); i++) {
        parameters[i] = read_KIND();
    }
    return p;
}

static void PREFIX_KIND_check(void)
{
    const PREFIX_KIND_t p = PREFIX_KIND_read();
    puts(PREFIX_validity_text(PREFIX_KIND_validate(&p)));
}

static void PREFIX_KIND_run(void)
{
    const PREFIX_KIND_t p = PREFIX_KIND_read();
    const NUMBER speed = read_KIND();
    const NUMBER gravity = read_KIND();
    PREFIX_KIND_matrices_t matrices;
    PREFIX_KIND_matrices(&p, &matrices);
    print_KIND((const NUMBER *)&matrices, sizeof matrices / sizeof(NUMBER));
    PREFIX_KIND_system_t system;
    carvallo_system_error_t error = AT_SPEED;
    printf("%d\n", (int)error);
    PREFIX_KIND_state_space_t space;
    if (error == CARVALLO_SYSTEM_OK) {
        error = PREFIX_KIND_state_space(&system, &space);
        printf("%d\n", (int)error);
        print_KIND((const NUMBER *)&space, sizeof space / sizeof(NUMBER));
    }
REST
    (void)speed;
    (void)gravity;
}
"#;

const KINEMATICS: &str = r#"
    PREFIX_KIND_kinematics_t kinematics;
    PREFIX_KIND_kinematics(&p, &kinematics);
    print_KIND((const NUMBER *)&kinematics, sizeof kinematics / sizeof(NUMBER));
"#;

const DERIVATIVES: &str = r#"
    PREFIX_KIND_derivatives_t derivatives;
    PREFIX_KIND_derivatives(&p, &matrices, &derivatives);
    for (size_t i = 0; i < sizeof p / sizeof(NUMBER); i++) {
        PREFIX_KIND_with_respect_to(&derivatives, i, &matrices);
        print_KIND((const NUMBER *)&matrices, sizeof matrices / sizeof(NUMBER));
    }
"#;

/// What is done with one state: a function for each result, of which the numbers are printed if there is no error.
const MOTIONS: &str = r#"
    PREFIX_KIND_motion_t motion;
    PREFIX_KIND_motion(&p, &motion);
    for (size_t state = 0; state < STATES; state++) {
        NUMBER given[POSITIONS + SPEEDS + FORCES];
        NUMBER result[64];
        PREFIX_KIND_linearization_t linearization;
        NUMBER by_parameters[POSITIONS + SPEEDS][PARAMETERS];
        for (size_t i = 0; i < POSITIONS + SPEEDS + FORCES; i++) {
            given[i] = read_KIND();
        }
        NUMBER *const positions = given;
        const NUMBER *const speeds = &given[POSITIONS];
        carvallo_motion_error_t code;
CALLS
    }
"#;

fn motions(Motions { info, parameters }: Motions) -> String {
    let (positions, speeds) = (info.positions.len(), info.speeds.len());
    let forces = if info.forces.is_empty() { String::new() } else { format!(", &given[{}]", positions + speeds) };
    let call = |function: &str, arguments: &str, array: &str, count: usize| {
        format!(
            "        code = PREFIX_KIND_motion_{function}(&motion, positions{arguments});\n        \
             printf(\"%d\\n\", (int)code);\n        if (code == CARVALLO_MOTION_OK) {{\n            \
             print_KIND({array}, {count});\n        }}\n"
        )
    };
    let of_forces = format!(", speeds{forces}, result");
    let mut calls = String::new();
    if !info.dependent.is_empty() {
        calls.push_str(&call("close", "", "positions", positions));
    }
    calls.push_str(&call("rates", ", speeds, result", "result", positions));
    calls.push_str(&call("derivatives", &format!("{of_forces}, &result[{positions}]"), "result", positions + speeds));
    calls.push_str(&call("accelerations", &of_forces, "result", positions));
    calls.push_str(&call("energy", ", speeds, result", "result", 2));
    if !info.wheels.is_empty() {
        calls.push_str(&call("contact_forces", &of_forces, "result", 3 * info.wheels.len()));
    }
    let states = positions + speeds;
    let entries = states * (states + info.forces.len());
    let linearization = "(const NUMBER *)&linearization";
    calls.push_str(&call("linearize", &format!(", speeds{forces}, &linearization"), linearization, entries));
    let (by_parameters, entries) = ("(const NUMBER *)by_parameters", states * parameters);
    calls.push_str(&call("by_parameters", &format!(", speeds{forces}, by_parameters"), by_parameters, entries));
    MOTIONS
        .replace("CALLS\n", &calls)
        .replace("STATES", &STATES.to_string())
        .replace("POSITIONS", &positions.to_string())
        .replace("SPEEDS", &speeds.to_string())
        .replace("FORCES", &info.forces.len().to_string())
        .replace("PARAMETERS", &parameters.to_string())
}

/// A program for all models, each with what its files are called and the text of its header.
pub fn write<'a>(models: impl Iterator<Item = (&'a Expected, &'a str, &'a str)>) -> String {
    let mut includes = String::new();
    let mut functions = String::new();
    let mut calls = String::new();
    for (expected, file, header) in models {
        includes.push_str(&format!("#include \"{file}.h\"\n"));
        for (kind, number) in [("f64", "double"), ("f32", "float")] {
            let gravity = if header.contains(&format!("{number} gravity")) { ", gravity" } else { "" };
            let at_speed = if header.contains("_f64_at_speed(") {
                format!("PREFIX_KIND_at_speed(&matrices, speed{gravity}, &system)")
            } else {
                format!("PREFIX_KIND_system(&matrices{gravity}, &system)")
            };
            let derivatives = if expected.has_derivatives { DERIVATIVES } else { "" };
            let kinematics = if expected.has_kinematics { KINEMATICS } else { "" };
            let motions = expected.motions.map(motions).unwrap_or_default();
            let rest = format!("{kinematics}{motions}{derivatives}");
            let function = DESIGN.replace("AT_SPEED", &at_speed).replace("REST", &rest);
            functions.push_str(&function.replace("PREFIX", file).replace("KIND", kind).replace("NUMBER", number));
            for (what, count) in [("run", expected.designs), ("check", expected.checked)] {
                calls.push_str(&format!(
                    "    for (size_t i = 0; i < {count}; i++) {{\n        {file}_{kind}_{what}();\n    }}\n"
                ));
            }
        }
    }
    format!("{includes}{HEAD}{functions}\nint main(void)\n{{\n{calls}    return 0;\n}}\n")
}
