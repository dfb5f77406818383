//! Declarations without mistakes, written after a grammar: compiling one gives Rust and a program that has the values of
//! the formulas, or says that a formula has none. Changes to text, as in `declaration`, seldom come as far as that.
//!
//! In this folder, with libFuzzer's options at the end:
//!
//! ```sh
//! mkdir -p ../../target/fuzz/corpus/model
//! RUSTC_BOOTSTRAP=1 cargo run --bin model -- ../../target/fuzz/corpus/model -timeout=60 -max_len=512 -len_control=0 \
//!     -max_total_time=3600 -print_final_stats=1
//! ```
//!
//! With `SHOW=1` it prints every declaration, for a look at one that was found.

#![no_main]

mod formula;
mod inside;

use std::fmt::Write as _;

use carvallo_compiler::{Driver, compile, expand};
use formula::{Formula, Rounded};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    proc_macro2::extra::invalidate_current_thread_spans();
    let model = Writer(data.iter()).model();
    let text = model.to_string();
    if std::env::var_os("SHOW").is_some() {
        println!("{text}");
    }
    let tokens: proc_macro2::TokenStream = text.parse().expect("it comes apart into tokens");
    match expand(tokens.clone(), &Driver::Macro { runtime: "::carvallo".parse().expect("a path") }) {
        Ok(code) => {
            assert!(syn::parse2::<syn::File>(code.clone()).is_ok(), "what came out is not Rust: {code}");
            let program = compile(tokens).expect("it was compiled before").programs.matrices;
            for number in 0..8 {
                let parameters = model.point(number);
                model.compare(&parameters, &program.interpret(&parameters));
            }
        }
        Err(errors) => errors.into_iter().for_each(|error| {
            let message = error.to_string();
            inside::look_for(&message, &text);
            assert!(UNDEFINED.iter().any(|known| message.contains(known)), "{message}\n{text}");
        }),
    }
});

/// What may be wrong with a formula that is written as it should be.
const UNDEFINED: [&str; 3] =
    ["a division by zero", "the square root of a negative number", "not a real and finite number"];

/// What may follow a unit, and the values that it allows.
const DOMAINS: [(&str, [f64; 2]); 6] = [
    ("", [-2.0, 2.0]),
    (", > 0", [0.0, 2.0]),
    (", >= 0", [0.0, 3.0]),
    (", < 1", [-2.0, 1.0]),
    (", in (-90 deg, 90 deg)", [-1.5, 1.5]),
    (", in [0, 1]", [0.0, 1.0]),
];

/// The matrices, with a factor that gives pure numbers the unit of their entries where coordinates are lengths.
const MATRICES: [(&str, &str); 8] = [
    ("M", "1 [kg]"),
    ("C-1", "1 [kg*m/s^2]"),
    ("C0", "1 [kg/s]"),
    ("C1", "1 [kg/m]"),
    ("Kc", "1 [kg/s^2]"),
    ("K0", "1 [kg/m]"),
    ("K1", "1 [kg/(m*s)]"),
    ("K2", "1 [kg/m^2]"),
];

/// Parameters and definitions are numbered in one row, all of them pure numbers.
struct Model {
    /// The domain of each parameter.
    parameters: Vec<usize>,
    definitions: Vec<Formula>,
    size: usize,
    /// The position in `MATRICES` of each matrix, in rising order, and its entries row by row.
    matrices: Vec<(usize, Vec<Formula>)>,
}

impl std::fmt::Display for Model {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("model Any {\nparameters {")?;
        for (index, domain) in self.parameters.iter().enumerate() {
            write!(f, " a{index}: 1{};", DOMAINS[*domain].0)?;
        }
        f.write_str(" }\n")?;
        for (index, definition) in self.definitions.iter().enumerate() {
            writeln!(f, "let a{} = {definition};", self.parameters.len() + index)?;
        }
        f.write_str("coordinates {")?;
        (0..self.size).try_for_each(|index| write!(f, " q{index}: m;"))?;
        f.write_str(" }\n")?;
        for (matrix, entries) in &self.matrices {
            let (name, factor) = MATRICES[*matrix];
            let mut rows = String::new();
            for row in entries.chunks(self.size) {
                rows.push('[');
                row.iter().try_for_each(|entry| write!(rows, "{factor}*({entry}), "))?;
                rows.push_str("], ");
            }
            writeln!(f, "{name} = [{rows}];")?;
        }
        f.write_char('}')
    }
}

impl Model {
    /// Values inside the domains.
    fn point(&self, number: u32) -> Vec<f64> {
        let inside = |(index, domain): (usize, &usize)| {
            let [low, high] = DOMAINS[*domain].1;
            let part = (f64::from(number) + 1.0) * (index as f64 + 1.0) * 0.618_033_988_749_894_9;
            low + (high - low) * (0.01 + 0.98 * part.fract())
        };
        self.parameters.iter().enumerate().map(inside).collect()
    }

    /// # Panics
    /// If a value that the program computed is not that of its formula.
    fn compare(&self, parameters: &[f64], computed: &[f64]) {
        let mut names: Vec<Rounded> = parameters.iter().map(|value| Rounded::new(*value)).collect();
        for definition in &self.definitions {
            let value = definition.value(&names);
            names.push(value);
        }
        let entries = self.matrices.iter().flat_map(|(_, entries)| entries);
        for (entry, computed) in entries.zip(computed) {
            let Rounded { value, error } = entry.value(&names);
            // Other ways to write a formula may round a good deal worse.
            let allowed = 1e6 * error;
            let known = value.is_finite() && allowed < 1e-3 * value.abs();
            assert!(
                !known || (value - computed).abs() <= allowed,
                "{entry} is {value}, computed as {computed}, at {parameters:?} in\n{self}"
            );
        }
    }
}

/// Writes what the input chooses; where it ends, the shortest.
struct Writer<'a>(std::slice::Iter<'a, u8>);

impl Writer<'_> {
    fn below(&mut self, end: usize) -> usize {
        usize::from(self.0.next().copied().unwrap_or(0)) % end
    }

    fn model(&mut self) -> Model {
        let parameters: Vec<usize> = (0..=self.below(5)).map(|_| self.below(DOMAINS.len())).collect();
        let mut names = parameters.len();
        let mut definitions = Vec::new();
        for _ in 0..self.below(6) {
            definitions.push(self.formula(3, names));
            names += 1;
        }
        let size = 1 + self.below(3);
        let mut matrices = Vec::new();
        for matrix in 0..MATRICES.len() {
            if matrix == 0 || self.below(4) == 3 {
                let mut entries: Vec<Formula> = (0..size * size).map(|_| self.formula(4, names)).collect();
                if matrix == 0 {
                    // Everything that is declared must be used.
                    let all = |sum, name| Formula::Sum(Box::new([sum, Formula::Name(name)]));
                    let last = entries.pop().unwrap_or(Formula::Number("1"));
                    entries.push((0..names).fold(last, all));
                }
                matrices.push((matrix, entries));
            }
        }
        Model { parameters, definitions, size, matrices }
    }

    fn formula(&mut self, depth: usize, names: usize) -> Formula {
        const NUMBERS: [&str; 12] =
            ["0", "1", "2", "3", "0.5", "0.1", "1e-3", "1e10", "7.25", "9.80665", "pi", "0.333333333333"];
        const EXPONENTS: [i32; 8] = [2, 3, -1, -2, 0, 1, 4, -5];
        let kind = if depth == 0 { self.below(3) } else { self.below(12) };
        match kind {
            0 | 1 => Formula::Name(self.below(names)),
            2 => Formula::Number(NUMBERS[self.below(NUMBERS.len())]),
            3 => Formula::Sum(self.both(depth, names)),
            4 => Formula::Difference(self.both(depth, names)),
            5 | 6 => Formula::Product(self.both(depth, names)),
            7 => Formula::Quotient(self.both(depth, names)),
            8 => {
                let exponent = EXPONENTS[self.below(EXPONENTS.len())];
                Formula::Power(Box::new(self.formula(depth - 1, names)), exponent)
            }
            _ => {
                let function = ["sin", "cos", "tan", "sqrt", "-"][self.below(5)];
                Formula::Call(function, Box::new(self.formula(depth - 1, names)))
            }
        }
    }

    fn both(&mut self, depth: usize, names: usize) -> Box<[Formula; 2]> {
        Box::new([self.formula(depth - 1, names), self.formula(depth - 1, names)])
    }
}
