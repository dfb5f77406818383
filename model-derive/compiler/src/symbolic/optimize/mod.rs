//! The search for the cheapest program among equivalent ones.

mod forms;
mod search;
mod shapes;
mod system;

use nanoserde::{DeBin, SerBin};

use super::door::ask;
use super::failure::Failure;
use crate::equations::Equations;
use crate::program::passes::Effort;
use crate::program::{Counts, Program, passes};

/// A program to compare with others.
#[derive(Clone, Debug, DeBin, SerBin)]
pub struct Found {
    program: Program,
    /// What it cost as it was found in the formulas.
    cost: usize,
}

impl Found {
    /// It is not finished.
    pub fn program(&self) -> &Program {
        &self.program
    }
}

/// The cheapest program found for each set of equations.
///
/// # Errors
/// If the engine cannot be had or fails, or if a formula has no value.
pub fn compile(equations: Vec<Equations>) -> Result<Vec<Found>, Failure> {
    ask("programs", equations, |engine, equations| {
        let numbered = equations.iter().enumerate();
        let programs = numbered.map(|(index, equations)| {
            let program = search::cheapest(engine, equations).map_err(|(place, why)| Failure::Undefined {
                equations: index,
                place,
                why,
            })?;
            let cost = Counts::of(&program).cost();
            Ok(Found { program: passes::rearrange(program, cost, Effort::COMPARE), cost })
        });
        programs.collect()
    })
}

/// Looks longer for something cheaper in the place of those that were chosen.
///
/// # Errors
/// If the engine cannot be had, in whose turn this is done: so it is kept with what the engine finds.
pub fn finish(chosen: Vec<Found>) -> Result<Vec<Program>, Failure> {
    ask("finished programs", chosen, |_, chosen| Ok(rearranged(chosen, Effort::FINISH)))
}

/// The same for programs with derivatives, for which it looks much longer.
///
/// # Errors
/// If the engine cannot be had, in whose turn this is done: so it is kept with what the engine finds.
pub fn finish_derivatives(chosen: Found) -> Result<Program, Failure> {
    ask("finished derivatives", vec![chosen], |_, chosen| Ok(rearranged(chosen, Effort::DERIVATIVES).remove(0)))
}

fn rearranged(chosen: &[Found], effort: Effort) -> Vec<Program> {
    chosen.iter().cloned().map(|Found { program, cost }| passes::rearrange(program, cost, effort)).collect()
}

#[cfg(test)]
mod tests {
    use super::super::{Engine, Form, enter};
    use super::shapes::{Rewritten, shapes_of};
    use super::*;
    use crate::formula::{Factor, Formula, Function, Term};

    fn sum(terms: impl IntoIterator<Item = Formula>) -> Formula {
        Formula::Sum(terms.into_iter().map(Term::plus).collect())
    }

    fn product(factors: impl IntoIterator<Item = Formula>) -> Formula {
        Formula::Product(factors.into_iter().map(Factor::times).collect())
    }

    fn over(product: Formula, divisor: Formula) -> Formula {
        Formula::Product(vec![Factor::times(product), Factor::over(divisor)])
    }

    fn call(function: Function, index: usize) -> Formula {
        Formula::Call(function, Box::new(Formula::Parameter(index)))
    }

    /// The program of equations in four parameters, whose values must be the expected ones.
    fn compiled(definitions: Vec<Formula>, outputs: Vec<Formula>, expected: impl Fn(&[f64; 4]) -> Vec<f64>) -> Counts {
        let origins = (0..definitions.len()).collect();
        let equations = Equations { parameters: 4, definitions, origins, outputs };
        let program = compile(vec![equations]).and_then(finish).expect("it compiles").remove(0);
        for parameters in [[1.5, 0.25, 0.75, 2.0], [0.5, 3.0, 1.25, 0.125]] {
            for (value, expected) in program.interpret(&parameters).into_iter().zip(expected(&parameters)) {
                assert!(
                    (value - expected).abs() <= 1e-14 * expected.abs(),
                    "{value}, expected {expected}: {program:?}"
                );
            }
        }
        Counts::of(&program)
    }

    #[test]
    fn a_division_that_cancels_out_is_not_done() {
        // The parallel-axis theorem about a centre of mass: m (a - c)^2 + n (b - c)^2 + (m + n) c^2 is m a^2 + n b^2.
        let [m, n, a, b] = [0, 1, 2, 3].map(Formula::Parameter);
        let mass = sum([m.clone(), n.clone()]);
        let moment = sum([product([m.clone(), a.clone()]), product([n.clone(), b.clone()])]);
        let centre = over(moment, Formula::Definition(0));
        let arm = |end: Formula| {
            Formula::Power(Box::new(Formula::Sum(vec![Term::plus(end), Term::minus(Formula::Definition(1))])), 2)
        };
        let inertia = sum([product([m, arm(a)]), product([n, arm(b)])]);
        let shifted = product([Formula::Definition(0), Formula::Power(Box::new(Formula::Definition(1)), 2)]);
        let output = sum([Formula::Definition(2), shifted]);
        let counts = compiled(vec![mass, centre, inertia], vec![output], |[m, n, a, b]| vec![m * a * a + n * b * b]);
        assert_eq!(counts, Counts { additions: 1, multiplications: 4, ..Counts::default() });
    }

    #[test]
    fn a_definition_goes_into_the_one_formula_that_gets_shorter_by_it() {
        // With q = c/w, which the other formula needs: q x + y/w is (c x + y)/w.
        let [c, w, x, y] = [0, 1, 2, 3].map(Formula::Parameter);
        let ratio = over(c, w.clone());
        let merged = sum([product([Formula::Definition(0), x.clone()]), over(y.clone(), w)]);
        let other = sum([product([Formula::Definition(0), y]), x]);
        let counts = compiled(vec![ratio], vec![merged, other], |[c, w, x, y]| vec![(c * x + y) / w, c / w * y + x]);
        assert!(counts.total() <= 7 && counts.divisions == 1, "{counts}");
    }

    #[test]
    fn every_shape_of_a_formula_is_equal_to_it() {
        let holds = enter(|engine: &Engine| {
            let [x, y, z] = [0, 1, 2].map(Formula::Parameter);
            let [sine, cosine] = [Function::Sin, Function::Cos].map(|function| call(function, 3));
            let arm = sum([product([x.clone(), cosine.clone()]), product([y.clone(), sine.clone()])]);
            let formulas = [
                product([z.clone(), Formula::Power(Box::new(arm.clone()), 2)]),
                sum([over(product([x.clone(), cosine]), z.clone()), over(arm, z.clone()), sine]),
                over(sum([product([x.clone(), y.clone()]), product([x.clone(), z.clone()])]), sum([x, y])),
            ];
            formulas.iter().all(|formula| {
                let form = engine.form(formula, &[]).expect("it has a value");
                let shapes: Vec<Form> =
                    shapes_of(&form, &Rewritten::default()).into_iter().map(|(_, shape)| shape).collect();
                shapes.len() > 1 && shapes.iter().all(|shape| shape.minus(&form).is_zero())
            })
        });
        assert!(holds.expect("the engine works"));
    }
}
