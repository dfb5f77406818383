//! Operations of a function, counted in its source.

use std::fs;

use carvallo_compare::Operations;
use syn::visit::{self, Visit};
use syn::{BinOp, Expr, ExprBinary, ExprCall, ExprLit, ExprMethodCall, ExprUnary, ImplItemFn, ItemFn, Lit, UnOp};

/// The names of the columns of a table of shipped programs.
pub const COLUMNS: &str =
    "model\tprogram\tadditions\tmultiplications\tdivisions\tnegations\troots\ttrigonometric\ttotal";

/// The functions that may be there.
const PROGRAMS: [&str; 13] = [
    "kinematics",
    "matrices",
    "matrices_and_derivatives",
    "validate",
    "motion",
    "closure_unchecked",
    "rates_unchecked",
    "derivatives_unchecked",
    "accelerations_unchecked",
    "energy_unchecked",
    "contact_forces_unchecked",
    "linearize_unchecked",
    "by_parameters_unchecked",
];

/// For each shipped model and each of its programs (the matrices, also with their derivatives, the rates and forces of a
/// mechanism, the requirements in `validate`, the nonlinear equations and their derivatives) its name and its operations, in alphabetical order.
///
/// # Panics
/// If the generated code cannot be read.
pub fn shipped() -> Vec<(String, Operations)> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../generated/src/models");
    let files = fs::read_dir(folder).expect("the folder of generated code").map(|file| file.expect("a file").path());
    let mut programs = Vec::new();
    for path in files.filter(|path| path.extension().is_some_and(|extension| extension == "rs")) {
        let model = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let source = fs::read_to_string(&path).expect("generated code");
        for program in PROGRAMS {
            // The functions that return them and that write them share it.
            let function = if program == "matrices_and_derivatives" { "each_result" } else { program };
            if source.contains(&format!("fn {function}(")) {
                programs.push((format!("{model}\t{program}"), count(&source, function)));
            }
        }
    }
    programs.sort_by(|(one, _), (other, _)| one.cmp(other));
    programs
}

/// Operations in the functions or methods called `name` of a Rust source file.
///
/// # Panics
/// If the source does not parse or has no such function.
pub fn count(source: &str, name: &str) -> Operations {
    let mut counter = Counter { name, inside: false, found: false, operations: Operations::default() };
    counter.visit_file(&syn::parse_file(source).expect("Rust source"));
    assert!(counter.found, "no function is called {name}");
    counter.operations
}

struct Counter<'a> {
    name: &'a str,
    inside: bool,
    found: bool,
    operations: Operations,
}

impl Counter<'_> {
    fn enter(&mut self, name: &syn::Ident, body: &syn::Block) {
        if name == self.name {
            self.found = true;
            self.inside = true;
            self.visit_block(body);
            self.inside = false;
        }
    }

    fn call(&mut self, function: &syn::Ident) {
        if self.inside {
            match function.to_string().as_str() {
                "sin_cos" => self.operations.trigonometric += 2,
                "sin" | "cos" | "tan" => self.operations.trigonometric += 1,
                "sqrt" => self.operations.roots += 1,
                _ => {}
            }
        }
    }
}

impl<'ast> Visit<'ast> for Counter<'_> {
    fn visit_item_fn(&mut self, function: &'ast ItemFn) {
        self.enter(&function.sig.ident, &function.block);
    }

    fn visit_impl_item_fn(&mut self, method: &'ast ImplItemFn) {
        self.enter(&method.sig.ident, &method.block);
    }

    fn visit_expr_binary(&mut self, expression: &'ast ExprBinary) {
        if self.inside {
            self.operations += match expression.op {
                BinOp::Add(_) | BinOp::Sub(_) => Operations { additions: 1, ..Default::default() },
                BinOp::Mul(_) => Operations { multiplications: 1, ..Default::default() },
                BinOp::Div(_) => Operations { divisions: 1, ..Default::default() },
                _ => panic!("an operator that is no arithmetic"),
            };
        }
        visit::visit_expr_binary(self, expression);
    }

    fn visit_expr_unary(&mut self, expression: &'ast ExprUnary) {
        // A negative literal is a constant.
        let negated = matches!(expression.op, UnOp::Neg(_)) && !matches!(*expression.expr, Expr::Lit(_));
        self.operations.negations += usize::from(self.inside && negated);
        visit::visit_expr_unary(self, expression);
    }

    fn visit_expr_method_call(&mut self, call: &'ast ExprMethodCall) {
        self.call(&call.method);
        if self.inside && call.method == "powi" {
            self.operations += power(call.args.first());
        }
        visit::visit_expr_method_call(self, call);
    }

    fn visit_expr_call(&mut self, call: &'ast ExprCall) {
        if let Expr::Path(path) = &*call.func
            && let Some(last) = path.path.segments.last()
        {
            self.call(&last.ident);
        }
        visit::visit_expr_call(self, call);
    }
}

/// A power with a literal exponent, as multiplications of the base one by one, and a division if it is negative.
fn power(exponent: Option<&Expr>) -> Operations {
    let (negative, literal) = match exponent {
        Some(Expr::Unary(ExprUnary { op: UnOp::Neg(_), expr, .. })) => (true, &**expr),
        Some(literal) => (false, literal),
        None => panic!("a power without an exponent"),
    };
    let Expr::Lit(ExprLit { lit: Lit::Int(exponent), .. }) = literal else { panic!("an exponent that is no literal") };
    let exponent: usize = exponent.base10_parse().expect("an exponent");
    let multiplications = exponent.checked_sub(1).expect("an exponent that is not zero");
    Operations { multiplications, divisions: usize::from(negative), ..Default::default() }
}
