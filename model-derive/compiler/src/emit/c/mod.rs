//! A checked model and its programs to C99, with a header for C++ as well: in double and in single precision.

mod body;
mod comment;
mod derivatives;
mod kinematics;
mod linearization;
mod matrices;
mod motion;
mod names;
mod parameters;
mod precision;
mod support;
mod system;
mod template;
mod validity;

use self::body::Body;
use self::names::{Prefix, distinct};
use self::precision::Precision;
pub use self::support::files as support_files;
use super::Driver;
use super::names::GeneratedNames;
use crate::model::Model;
use crate::nonlinear::MotionPrograms;
use crate::pipeline::{Compiled, Programs};
use crate::program::{Counts, Instruction, Program, Value};

/// A file of C.
pub struct File {
    /// With its extension.
    pub name: String,
    pub text: String,
}

/// The header and the source of a model. What is public in them begins with the name of the files.
pub fn emit(compiled: &Compiled, file: &str) -> [File; 2] {
    let context = Context::new(compiled, file);
    [
        File { name: format!("{file}.h"), text: emit_header(&context, file) },
        File { name: format!("{file}.c"), text: emit_source(&context, file) },
    ]
}

/// What all parts are written from.
struct Context<'a> {
    model: &'a Model,
    programs: &'a Programs,
    prefix: Prefix,
    names: GeneratedNames,
    /// The members of the struct of the parameters.
    fields: Vec<String>,
    /// The macro that is the number of coordinates.
    size: String,
}

impl<'a> Context<'a> {
    fn new(Compiled { model, programs }: &'a Compiled, file: &str) -> Self {
        let prefix = Prefix::new(file);
        Self {
            model,
            programs,
            names: GeneratedNames::new(model, programs.derivatives.as_ref(), &Driver::File),
            fields: distinct(model.parameters.iter().map(|parameter| &parameter.name)),
            size: format!("{}_N", prefix.upper()),
            prefix,
        }
    }

    /// The name of a function, or of a type with `_t` behind it.
    fn name(&self, precision: Precision, what: &str) -> String {
        format!("{}_{}_{what}", self.prefix.lower(), precision.name())
    }

    /// The type of the parameters.
    fn parameters(&self, precision: Precision) -> String {
        self.name(precision, "t")
    }

    /// A program in the parameters `p`, with names for its results, in a function that has other names already.
    fn body(&self, program: &Program, precision: Precision, results: &[(Value, String)], taken: &[&str]) -> Body {
        let inputs: Vec<String> = self.model.parameters.iter().map(|parameter| parameter.name.to_string()).collect();
        let variable = self.names.values(program, self.model, &inputs, results);
        let taken = [taken, &["p"]].concat();
        let read = |index: usize| format!("p->{}", self.fields[index]);
        Body::new(program, precision, &taken, read, |value| variable(value).to_string())
    }

    fn all_programs(&self) -> impl Iterator<Item = &Program> {
        let Programs { matrices, requirements, kinematics, derivatives, motion, by_attributes: _ } = self.programs;
        let derivatives = derivatives.as_ref().map(|derivatives| &derivatives.program);
        let motion = motion.iter().flat_map(MotionPrograms::all);
        [matrices, requirements].into_iter().chain(kinematics).chain(derivatives).chain(motion)
    }

    fn has(&self, wanted: impl Fn(Instruction) -> bool) -> bool {
        self.all_programs().flat_map(|program| &program.instructions).any(|instruction| wanted(*instruction))
    }
}

fn emit_header(context: &Context, file: &str) -> String {
    let model = context.model;
    let guard = format!("CARVALLO_MODEL_{}_H", context.prefix.upper());
    let about = format!(
        "@file {file}.h\n@brief The model `{}`, in C99 and C++: everything is in SI units, and angles are in rad.\n\n{}\n\n\
         Nothing is allocated, and all functions may be called at once. `carvallo_system.h` says how to compile for the\n\
         same bits on every processor.",
        model.name,
        comment::of_model(model),
    );
    let of_motion = if context.programs.motion.is_some() { "#include \"carvallo_motion.h\"\n" } else { "" };
    let mut text = comment::block(&about, 0);
    text.push_str(&format!(
        "\n#ifndef {guard}\n#define {guard}\n\n{of_motion}#include \"carvallo_system.h\"\n\n#ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n"
    ));
    let size = comment::block("The number N of coordinates, and of rows and columns of each matrix.", 0);
    text.push_str(&format!("{size}#define {} {}U\n\n", context.size, model.coordinates.len()));
    text.push_str(&parameters::declare_sets(context));
    text.push_str(&validity::declare(context));
    text.push_str(&derivatives::declare_table(context));
    text.push_str(&motion::declare_places(context));
    text.push_str(&linearization::declare_sizes(context));
    for precision in Precision::ALL {
        let rule = "-".repeat(60);
        text.push_str(&format!("/* {rule} {} */\n\n", precision.number()));
        for declare in [
            parameters::declare,
            validity::declare_function,
            matrices::declare,
            system::declare,
            kinematics::declare,
            derivatives::declare,
            motion::declare,
            linearization::declare,
        ] {
            text.push_str(&declare(context, precision));
        }
    }
    text.push_str(&format!("#ifdef __cplusplus\n}}\n#endif\n\n#endif /* {guard} */\n"));
    text
}

fn emit_source(context: &Context, file: &str) -> String {
    let has_trigonometry = context
        .has(|instruction| matches!(instruction, Instruction::Sin(_) | Instruction::Cos(_) | Instruction::Tan(_)));
    let needs_math = context.has(|instruction| match instruction {
        Instruction::Sqrt(_) | Instruction::Tan(_) => true,
        Instruction::Constant(value) => Precision::Single.is_too_large(value),
        _ => false,
    }) || context.model.motion.as_ref().is_some_and(|motion| !motion.layout.standing.is_empty());
    let mut text = comment::block(&formulas(context.model), 0);
    text.push_str(&format!("\n#include \"{file}.h\"\n\n"));
    if has_trigonometry {
        text.push_str("#include \"carvallo_trig.h\"\n\n");
    }
    text.push_str("#include <float.h>\n");
    if needs_math {
        text.push_str("#include <math.h>\n");
    }
    text.push_str(&parameters::define_names(context));
    text.push_str(&validity::define_text(context));
    text.push_str(&derivatives::define_table(context));
    text.push_str(&motion::define_names(context));
    for precision in Precision::ALL {
        for define in [
            parameters::define,
            validity::define,
            matrices::define,
            system::define,
            kinematics::define,
            derivatives::define,
            motion::define,
            linearization::define,
        ] {
            let part = define(context, precision);
            if !part.is_empty() {
                text.push('\n');
                text.push_str(&part);
            }
        }
    }
    text
}

/// The formulas that the programs were made of, for who reviews them.
fn formulas(model: &Model) -> String {
    let formulas: Vec<String> = model.formulas.iter().map(ToString::to_string).collect();
    format!(
        "@file\nThe programs below are made of these formulas, which are those of the matrices:\n\n@verbatim\n{}\n@endverbatim",
        formulas.join("\n")
    )
}

/// How many operations a program takes, as the end of a sentence.
fn counts(program: &Program) -> String {
    Counts::of(program).to_string()
}
