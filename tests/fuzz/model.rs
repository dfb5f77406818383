//! Declarations without mistakes, written after a grammar: compiling one gives Rust, or says that a formula has no
//! value. Changes to text, as in `declaration`, seldom come as far as the symbolic engine.
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

mod inside;

use carvallo_compiler::{Driver, expand};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|data: &[u8]| {
    proc_macro2::extra::invalidate_current_thread_spans();
    let text = Writer { choices: data.iter(), names: Vec::new() }.declaration();
    if std::env::var_os("SHOW").is_some() {
        println!("{text}");
    }
    match expand(text.parse().expect("it comes apart into tokens"), Driver::Macro) {
        Ok(code) => assert!(syn::parse2::<syn::File>(code.clone()).is_ok(), "what came out is not Rust: {code}"),
        Err(errors) => errors.into_iter().for_each(|error| {
            let message = error.to_string();
            inside::look_for(&message, &text);
            assert!(UNDEFINED.iter().any(|known| message.contains(known)), "{message}\n{text}");
        }),
    }
});

/// What may be wrong with a formula that is written as it should be.
const UNDEFINED: [&str; 4] =
    ["a division by zero", "the square root of a negative number", "the tangent of", "range of f64"];

/// Writes what the input chooses; where it ends, the shortest.
struct Writer<'a> {
    choices: std::slice::Iter<'a, u8>,
    /// The parameters and definitions so far.
    names: Vec<String>,
}

impl Writer<'_> {
    fn below(&mut self, end: usize) -> usize {
        usize::from(self.choices.next().copied().unwrap_or(0)) % end
    }

    fn declaration(&mut self) -> String {
        let mut parameters = String::new();
        for index in 0..=self.below(5) {
            let domain = ["", ", > 0", ", >= 0", ", < 1", ", in (-pi/2, pi/2)", ", in [0, 1]"][self.below(6)];
            parameters += &format!("a{index}: m{domain}; ");
            self.names.push(format!("a{index}"));
        }
        let mut definitions = String::new();
        for index in 0..self.below(6) {
            definitions += &format!("let d{index} = {};\n", self.formula(3));
            self.names.push(format!("d{index}"));
        }
        let size = 1 + self.below(3);
        let coordinates: String = (0..size).map(|index| format!("q{index}: rad; ")).collect();
        let mut matrices = String::new();
        for name in ["C0", "C1", "Kc", "K0", "K2"] {
            if self.below(4) == 3 {
                matrices += &format!("{name} = {};\n", self.matrix(size, ""));
            }
        }
        // Everything that is declared must be used.
        let all: String = self.names.iter().map(|name| format!(" + {name}")).collect();
        matrices += &format!("M = {};\n", self.matrix(size, &all));
        let requirement =
            if self.below(4) == 3 { format!("require {} > 0;\n", self.formula(2)) } else { String::new() };
        format!(
            "model Any {{\nparameters {{ {parameters}}}\n{definitions}{requirement}coordinates {{ {coordinates}}}\n\
             {matrices}}}"
        )
    }

    /// A square matrix, `all` being added to its last entry.
    fn matrix(&mut self, size: usize, all: &str) -> String {
        let mut rows = Vec::new();
        for row in 0..size {
            let entries: Vec<String> = (0..size).map(|_| self.formula(4)).collect();
            let last = if row + 1 == size { all } else { "" };
            rows.push(format!("[{}{last}]", entries.join(", ")));
        }
        format!("[{}]", rows.join(", "))
    }

    fn formula(&mut self, depth: usize) -> String {
        const NUMBERS: [&str; 12] =
            ["0", "1", "2", "3", "0.5", "0.1", "1e-3", "1e10", "7.25", "9.80665", "pi", "0.333333333333"];
        const EXPONENTS: [&str; 8] = ["2", "3", "-1", "-2", "0", "1", "4", "-5"];
        let kind = if depth == 0 { self.below(3) } else { self.below(12) };
        let mut part = || self.formula(depth.saturating_sub(1));
        match kind {
            0 | 1 => {
                let name = self.below(self.names.len());
                self.names[name].clone()
            }
            2 => NUMBERS[self.below(NUMBERS.len())].into(),
            3 => format!("({} + {})", part(), part()),
            4 => format!("({} - {})", part(), part()),
            5 => format!("{}*{}", part(), part()),
            6 => format!("({})/({})", part(), part()),
            7 => format!("({})^{}", part(), EXPONENTS[self.below(EXPONENTS.len())]),
            8 => format!("sqrt({})", part()),
            9 => format!("sin({})*cos({})", part(), part()),
            10 => format!("{}({})", ["sin", "cos", "tan"][self.below(3)], self.formula(depth - 1)),
            _ => format!("(-{})", part()),
        }
    }
}
