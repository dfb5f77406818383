//! Declarations without mistakes, written after a grammar, as matrices, with the speed in `C` and `K`, or as a mechanism:
//! compiling one gives Rust and a program that has the values of
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
            let compiled = compile(tokens).expect("it was compiled before");
            let names: Vec<&str> = compiled.model.matrices.iter().map(|(name, _)| name.name()).collect();
            for number in 0..8 {
                let parameters = model.point(number);
                // Of a mechanism gravity is a parameter behind them, which no matrix depends on.
                let with_gravity = [&parameters[..], &[9.81]].concat();
                model.compare(&parameters, &names, &compiled.programs.matrices.interpret(&with_gravity));
            }
        }
        Err(errors) => errors.into_iter().for_each(|error| {
            let message = error.to_string();
            inside::look_for(&message, &text);
            let known = UNDEFINED.iter().chain(&UNDETERMINED);
            assert!(known.into_iter().any(|known| message.contains(known)), "{message}\n{text}");
        }),
    }
});

/// What may be wrong with a formula that is written as it should be.
const UNDEFINED: [&str; 3] =
    ["a division by zero", "the square root of a negative number", "not a real and finite number"];

/// What may be wrong with matrices of which whole rows or columns happen to be zero.
const UNDETERMINED: [&str; 2] =
    ["has no motion of its own", "has neither an acceleration nor the rate of a coordinate of first order"];

/// What may follow a unit, and the values that it allows.
const DOMAINS: [(&str, [f64; 2]); 6] = [
    ("", [-2.0, 2.0]),
    (", > 0", [0.0, 2.0]),
    (", >= 0", [0.0, 3.0]),
    (", < 1", [-2.0, 1.0]),
    (", in (-90 deg, 90 deg)", [-1.5, 1.5]),
    (", in [0, 1]", [0.0, 1.0]),
];

/// The matrices, with a factor that gives pure numbers the unit of their entries where coordinates are lengths, which is that
/// of a part of `C` or `K` where the power of the speed is written beside it.
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

/// The matrices that may be written as one with the speed in it: its name, and of each part the position in `MATRICES` and
/// what is behind its formula.
const WHOLES: [(&str, &[(usize, &str)]); 2] =
    [("C", &[(1, "/v"), (2, ""), (3, "*v")]), ("K", &[(4, ""), (6, "*v"), (7, "*v^2")])];

/// Parameters and definitions are numbered in one row, all of them pure numbers.
struct Model {
    /// The domain of each parameter.
    parameters: Vec<usize>,
    definitions: Vec<Formula>,
    size: usize,
    /// The position in `MATRICES` of each matrix, in rising order, and its entries row by row.
    matrices: Vec<(usize, Vec<Formula>)>,
    form: Form,
}

/// How a model is written.
enum Form {
    Matrices,
    /// With the speed, where there are parts of `C` and `K`.
    Wholes,
    /// As the mechanism that has these matrices.
    Chain(Vec<Link>),
}

/// A body that hangs on a hinge of the one before, all in the vertical, and what holds the hinge; lengths in m and downward.
#[derive(Clone)]
struct Link {
    hinge: Formula,
    centre: Formula,
    mass: Formula,
    inertia: Formula,
    spring: Formula,
    damper: Formula,
}

impl std::fmt::Display for Model {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("model Any {\nparameters {")?;
        for (index, domain) in self.parameters.iter().enumerate() {
            write!(f, " a{index}: 1{};", DOMAINS[*domain].0)?;
        }
        if self.wholes().next().is_some() {
            f.write_str(" v: m/s, speed;")?;
        }
        if matches!(self.form, Form::Chain(_)) {
            f.write_str(" g: N/kg, >= 0, gravity;")?;
        }
        f.write_str(" }\n")?;
        for (index, definition) in self.definitions.iter().enumerate() {
            writeln!(f, "let a{} = {definition};", self.parameters.len() + index)?;
        }
        f.write_str("coordinates {")?;
        let unit = if matches!(self.form, Form::Chain(_)) { "rad" } else { "m" };
        (0..self.size).try_for_each(|index| write!(f, " q{index}: {unit};"))?;
        f.write_str(" }\n")?;
        if let Form::Chain(links) = &self.form {
            write_mechanism(f, links)?;
            return f.write_char('}');
        }
        let is_part = |matrix: usize| self.wholes().any(|(_, parts)| parts.iter().any(|(part, _)| *part == matrix));
        for (matrix, entries) in self.matrices.iter().filter(|(matrix, _)| !is_part(*matrix)) {
            let (name, factor) = MATRICES[*matrix];
            self.write_rows(f, name, |place| format!("{factor}*({})", entries[place]))?;
        }
        for (name, parts) in self.wholes() {
            self.write_rows(f, name, |place| {
                let parts = parts.iter().filter_map(|(part, power)| {
                    let entry = &self.entries(MATRICES[*part].0)?[place];
                    Some(format!("{}*({entry}){power}", MATRICES[*part].1))
                });
                parts.collect::<Vec<String>>().join(" + ")
            })?;
        }
        f.write_char('}')
    }
}

fn write_mechanism(f: &mut std::fmt::Formatter<'_>, links: &[Link]) -> std::fmt::Result {
    f.write_str("mechanism {\n")?;
    for (index, Link { hinge, centre, mass, inertia, spring, damper }) in links.iter().enumerate() {
        let parent = if index == 0 { "ground".into() } else { format!("B{}", index - 1) };
        writeln!(
            f,
            "body B{index}: mass 1 [kg]*({mass}), at (0, 0, 1 [m]*({centre})), inertia [1 [kg*m^2]*({inertia}), 0, 0];"
        )?;
        writeln!(f, "revolute q{index}: {parent} to B{index}, through (0, 0, 1 [m]*({hinge})), along (1, 0, 0),")?;
        writeln!(f, "    spring 1 [N*m]*({spring}), damper 1 [N*m*s]*({damper});")?;
    }
    f.write_str("}\n")
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

    /// What a mechanism's formulas may lose beside those here: they lead through the hinges, however far these are.
    fn lost(&self, names: &[Rounded]) -> f64 {
        let Form::Chain(links) = &self.form else { return 0.0 };
        let value = |formula: &Formula| formula.value(names).value.abs();
        let lengths = links.iter().flat_map(|link| [&link.hinge, &link.centre]);
        let reach = lengths.map(value).fold(1.0, f64::max);
        links.iter().map(|link| value(&link.mass)).sum::<f64>() * reach.powi(2) * f64::EPSILON
    }

    /// The matrices that are written with the speed: those of which there is a part that the speed multiplies.
    fn wholes(&self) -> impl Iterator<Item = &'static (&'static str, &'static [(usize, &'static str)])> + '_ {
        let has_speed = |part: &(usize, &str)| !part.1.is_empty() && self.entries(MATRICES[part.0].0).is_some();
        WHOLES.iter().filter(move |(_, parts)| matches!(self.form, Form::Wholes) && parts.iter().any(has_speed))
    }

    fn entries(&self, name: &str) -> Option<&Vec<Formula>> {
        self.matrices.iter().find(|(matrix, _)| MATRICES[*matrix].0 == name).map(|(_, entries)| entries)
    }

    fn write_rows(
        &self,
        f: &mut std::fmt::Formatter<'_>,
        name: &str,
        entry: impl Fn(usize) -> String,
    ) -> std::fmt::Result {
        write!(f, "{name} = [")?;
        for row in 0..self.size {
            let entries: Vec<String> = (0..self.size).map(|column| entry(row * self.size + column)).collect();
            write!(f, "[{}], ", entries.join(", "))?;
        }
        f.write_str("];\n")
    }

    /// Holds what the program of the matrices with these names computed against the formulas; a matrix that is not there
    /// is zero.
    ///
    /// # Panics
    /// If a value that the program computed is not that of its formula.
    fn compare(&self, parameters: &[f64], present: &[&str], computed: &[f64]) {
        let mut names: Vec<Rounded> = parameters.iter().map(|value| Rounded::new(*value)).collect();
        for definition in &self.definitions {
            let value = definition.value(&names);
            names.push(value);
        }
        let lost = self.lost(&names);
        let count = self.size.pow(2);
        let entries = self.matrices.iter().flat_map(|(matrix, entries)| {
            let position = present.iter().position(|name| *name == MATRICES[*matrix].0);
            let computed = move |place| position.map_or(0.0, |position| computed[position * count + place]);
            entries.iter().enumerate().map(move |(place, entry)| (entry, computed(place)))
        });
        for (entry, computed) in entries {
            let Rounded { value, error } = entry.value(&names);
            // Other ways to write a formula may round a good deal worse.
            let allowed = 1e6 * (error + lost);
            let known = value.is_finite() && allowed < 1e-3 * value.abs();
            assert!(
                !known || (value - computed).abs() <= allowed,
                "{entry} is {value}, computed as {computed}, at {parameters:?} in\n{self}"
            );
        }
    }
}

/// The matrices of a chain that hangs down, from the textbook: M_ij is the sum of I + m (z - h_i)(z - h_j) over the bodies
/// below both hinges, at the heights h, and K0_ij that of m (z - h) with the lower of them.
fn find_matrices(links: &[Link]) -> Vec<(usize, Vec<Formula>)> {
    let n = links.len();
    let zero = || Formula::Number("0");
    let arm = |body: usize, hinge: usize| {
        Formula::Difference(Box::new([links[body].centre.clone(), links[hinge].hinge.clone()]))
    };
    let entries = |entry: &dyn Fn(usize, usize) -> Formula| -> Vec<Formula> {
        (0..n * n).map(|place| entry(place / n, place % n)).collect()
    };
    let inertia = entries(&|row, column| {
        (row.max(column)..n).fold(zero(), |all, body| {
            let arms = Formula::Product(Box::new([arm(body, row), arm(body, column)]));
            let moment = Formula::Product(Box::new([links[body].mass.clone(), arms]));
            sum([all, sum([links[body].inertia.clone(), moment])])
        })
    });
    let weight = entries(&|row, column| {
        let lower = row.max(column);
        let moment = |body: usize| Formula::Product(Box::new([links[body].mass.clone(), arm(body, lower)]));
        (lower..n).fold(zero(), |all, body| sum([all, moment(body)]))
    });
    let diagonal =
        |of: &dyn Fn(&Link) -> Formula| entries(&|row, column| if row == column { of(&links[row]) } else { zero() });
    let (damping, stiffness) = (diagonal(&|link| link.damper.clone()), diagonal(&|link| link.spring.clone()));
    vec![(0, inertia), (2, damping), (4, stiffness), (5, weight)]
}

fn sum(parts: [Formula; 2]) -> Formula {
    Formula::Sum(Box::new(parts))
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
        let form = self.below(4);
        if form == 3 {
            let links = self.links(size, names);
            return Model { parameters, definitions, size, matrices: find_matrices(&links), form: Form::Chain(links) };
        }
        let form = if form == 2 { Form::Wholes } else { Form::Matrices };
        let mut matrices = Vec::new();
        for matrix in 0..MATRICES.len() {
            // K0 is a part of K too.
            let (one_in, is_allowed) = if matches!(form, Form::Wholes) { (2, matrix != 5) } else { (4, true) };
            if matrix == 0 || is_allowed && self.below(one_in) == one_in - 1 {
                let mut entries: Vec<Formula> = (0..size * size).map(|_| self.formula(4, names)).collect();
                if matrix == 0 {
                    // Everything that is declared must be used.
                    let all = |all, name| sum([all, Formula::Name(name)]);
                    let last = entries.pop().unwrap_or(Formula::Number("1"));
                    entries.push((0..names).fold(last, all));
                }
                matrices.push((matrix, entries));
            }
        }
        Model { parameters, definitions, size, matrices, form }
    }

    /// Masses and moments of inertia are positive, since no other body can be.
    fn links(&mut self, size: usize, names: usize) -> Vec<Link> {
        let positive = |formula| sum([Formula::Number("1"), Formula::Power(Box::new(formula), 2)]);
        let mut links: Vec<Link> = (0..size)
            .map(|_| Link {
                hinge: self.formula(2, names),
                centre: self.formula(2, names),
                mass: positive(self.formula(2, names)),
                inertia: positive(self.formula(2, names)),
                spring: self.formula(2, names),
                damper: self.formula(2, names),
            })
            .collect();
        if let Some(last) = links.last_mut() {
            // Everything that is declared must be used.
            let all = (0..names).fold(self.formula(2, names), |all, name| sum([all, Formula::Name(name)]));
            last.inertia = positive(all);
        }
        links
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
