//! Names of C: those of the declaration, as far as C and C++ let them be.

use std::collections::HashSet;

use proc_macro2::Ident;

use crate::free_name::take_free_name;

/// What the names of everything public begin with: the name of the file.
#[derive(Clone, Debug)]
pub struct Prefix(String);

impl Prefix {
    pub fn new(file: &str) -> Self {
        Self(identifier(file))
    }

    /// Of functions and types.
    pub fn lower(&self) -> &str {
        &self.0
    }

    /// Of macros and constants.
    pub fn upper(&self) -> String {
        self.0.to_uppercase()
    }
}

/// Identifiers for names, none of them twice.
pub fn distinct<'a>(names: impl IntoIterator<Item = &'a Ident>) -> Vec<String> {
    let mut taken = HashSet::new();
    names.into_iter().map(|name| take_free_name(&identifier(&name.to_string()), &mut taken)).collect()
}

/// A name as C has it: letters that not every compiler takes are written by their number, and an underscore behind it sets
/// a word of C or C++ apart.
pub fn identifier(name: &str) -> String {
    let name = name.trim_start_matches("r#");
    let mut text = String::new();
    for letter in name.chars() {
        if letter.is_ascii_alphanumeric() || letter == '_' {
            text.push(letter);
        } else {
            text.push_str(&format!("u{:04x}", u32::from(letter)));
        }
    }
    // What begins with an underscore belongs to the compiler, at file scope at least.
    if text.starts_with('_') {
        text.insert(0, 'x');
    }
    if WORDS.contains(&text.as_str()) {
        text.push('_');
    }
    text
}

/// Keywords of C and C++, macros of the standard headers that are read, and functions of `math.h`.
const WORDS: &[&str] = &[
    "BUFSIZ",
    "EOF",
    "FILE",
    "HUGE_VAL",
    "I",
    "INFINITY",
    "NAN",
    "NULL",
    "acos",
    "acosh",
    "alignas",
    "alignof",
    "and",
    "and_eq",
    "asin",
    "asinh",
    "asm",
    "assert",
    "atan",
    "atan2",
    "atanh",
    "auto",
    "bitand",
    "bitor",
    "bool",
    "break",
    "case",
    "catch",
    "cbrt",
    "ceil",
    "char",
    "char16_t",
    "char32_t",
    "char8_t",
    "class",
    "co_await",
    "co_return",
    "co_yield",
    "compl",
    "concept",
    "const",
    "const_cast",
    "consteval",
    "constexpr",
    "constinit",
    "continue",
    "copysign",
    "cos",
    "cosh",
    "decltype",
    "default",
    "delete",
    "do",
    "double",
    "double_t",
    "dynamic_cast",
    "else",
    "enum",
    "erf",
    "erfc",
    "errno",
    "exp",
    "exp2",
    "explicit",
    "expm1",
    "export",
    "extern",
    "fabs",
    "false",
    "fdim",
    "float",
    "float_t",
    "floor",
    "fma",
    "fmax",
    "fmin",
    "fmod",
    "for",
    "frexp",
    "friend",
    "gamma",
    "goto",
    "hypot",
    "if",
    "ilogb",
    "inline",
    "int",
    "isfinite",
    "isinf",
    "isnan",
    "isnormal",
    "j0",
    "j1",
    "jn",
    "ldexp",
    "lgamma",
    "llrint",
    "llround",
    "log",
    "log10",
    "log1p",
    "log2",
    "logb",
    "long",
    "lrint",
    "lround",
    "main",
    "modf",
    "mutable",
    "namespace",
    "nan",
    "nearbyint",
    "new",
    "nextafter",
    "noexcept",
    "not",
    "not_eq",
    "nullptr",
    "operator",
    "or",
    "or_eq",
    "pow",
    "private",
    "protected",
    "ptrdiff_t",
    "public",
    "register",
    "reinterpret_cast",
    "remainder",
    "remquo",
    "requires",
    "restrict",
    "return",
    "rint",
    "round",
    "scalbln",
    "scalbn",
    "short",
    "signbit",
    "signed",
    "signgam",
    "sin",
    "sinh",
    "size_t",
    "sizeof",
    "sqrt",
    "static",
    "static_assert",
    "static_cast",
    "struct",
    "switch",
    "tan",
    "tanh",
    "template",
    "tgamma",
    "this",
    "thread_local",
    "throw",
    "true",
    "trunc",
    "try",
    "typedef",
    "typeid",
    "typename",
    "union",
    "unix",
    "linux",
    "unsigned",
    "using",
    "virtual",
    "void",
    "volatile",
    "wchar_t",
    "while",
    "xor",
    "xor_eq",
    "y0",
    "y1",
    "yn",
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_the_declaration_where_c_has_no_other_use_for_them() {
        for (name, expected) in [("mB", "mB"), ("int", "int_"), ("r#struct", "struct_"), ("λ", "u03bb"), ("_a", "x_a")]
        {
            assert_eq!(identifier(name), expected);
        }
        assert_eq!(Prefix::new("my_bicycle").upper(), "MY_BICYCLE");
    }
}
