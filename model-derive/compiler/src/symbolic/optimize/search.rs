//! The search for the choices that give the cheapest program.

use std::collections::HashSet;

use super::super::engine::Engine;
use super::super::failure::{Place, Undefined};
use super::forms::{FormId, Forms, find_used};
use super::shapes::Shape;
use super::system::{Choices, System};
use crate::equations::Equations;
use crate::formula::Formula;
use crate::program::{Counts, Program, passes};

/// In models with more definitions than this one program is built, of the formulas as they are written, and nothing is
/// tried: of models with hundreds of definitions the programs that are compared here differ by some hundredths, and
/// finding the shapes of a hundred formulas takes seconds where the engine is built without optimization.
const MAX_TRIED: usize = 64;

/// So many programs are built at most, and fewer of long ones: as many as come to so many operations together. It is not
/// the clock that ends the search, since the same declaration must always give the same program.
const MAX_PROGRAMS: usize = 40;
const MAX_OPERATIONS: usize = 2_500;
/// Choices that lead to formulas which were there before build no program, but making the formulas takes time, too: so many
/// are made at most, beyond those of the first program.
const MAX_FORMULAS: usize = 20_000;

/// Definitions do not disappear together if the formulas then take so many times the operations, each by itself: programs
/// that came out cheaper had up to 2.2 times as many.
const MAX_GROWTH: usize = 4;

/// In how many orders of the symbols the engine nests the formulas: it keeps the best, and then goes on from there.
const ORDERS: usize = 10;
/// What is tried at last: more orders take longer, and fewer can come out better, since it looks at the formulas alone.
const OTHER_ORDERS: [usize; 3] = [0, 1, 30];

/// The cheapest program that is found for the equations.
///
/// # Errors
/// If a formula has no value.
pub fn cheapest(engine: &Engine, equations: &Equations) -> Result<Program, (Place, Undefined)> {
    let mut search = Search {
        engine,
        equations,
        forms: Forms::new(engine, equations),
        seen: HashSet::new(),
        left: MAX_PROGRAMS,
        formulas_left: MAX_FORMULAS,
        best: Best::default(),
    };
    search.run()?;
    Ok(search.best.program)
}

struct Search<'a> {
    engine: &'a Engine,
    equations: &'a Equations,
    forms: Forms<'a>,
    /// The formulas of all programs so far.
    seen: HashSet<Vec<Option<FormId>>>,
    /// How many programs may still be built.
    left: usize,
    /// How many formulas may still be made.
    formulas_left: usize,
    best: Best,
}

#[derive(Default)]
struct Best {
    cost: Option<usize>,
    program: Program,
    choices: Choices,
    system: System,
}

impl Search<'_> {
    fn run(&mut self) -> Result<(), (Place, Undefined)> {
        let count = self.equations.definitions.len();
        // Definitions never all disappear into the formulas that use them: that grows exponentially with their depth.
        let mut times = vec![0; count];
        let formulas = self.equations.definitions.iter().chain(&self.equations.outputs);
        formulas.flat_map(Formula::find_definitions).for_each(|index| times[index] += 1);
        let used_once: Vec<bool> = times.into_iter().map(|times| times == 1).collect();
        if count > MAX_TRIED {
            self.try_out(self.choices(&used_once, Some(Shape::Written)))?;
            return Ok(());
        }
        let none = vec![false; count];
        self.try_out(self.choices(&none, Some(Shape::Written)))?;
        let operations = Counts::of(&self.best.program).total();
        self.left = self.left.min(MAX_OPERATIONS / operations.max(1));
        let fractions = self.find_fractions()?;
        let quotients: Vec<bool> = self
            .equations
            .definitions
            .iter()
            .zip(&fractions)
            .map(|(formula, inline)| *inline || divides(formula))
            .collect();
        // All formulas alike first: from the best of these starts single changes go on, and none of them would lead from
        // one such start to another.
        let written = self.best.system.operations(&self.forms);
        for inline in [&none, &used_once, &fractions, &quotients] {
            // What multiplies the formulas is seen before any program is built of them.
            let choices = self.choices(inline, Some(Shape::Written));
            let inlined = System::new(&mut self.forms, &choices)?;
            if inlined.operations(&self.forms) > MAX_GROWTH * written {
                continue;
            }
            for shape in [Some(Shape::Written), None, Some(Shape::ByFunctions), Some(Shape::ByLinear)] {
                self.try_out(self.choices(inline, shape))?;
            }
        }
        // Each of the three changes formulas one by one and keeps what is cheaper, which can make more of the others
        // worthwhile: so they go round until none finds anything.
        while !self.is_over() && (self.keep(&fractions)? | self.open()? | self.reshape()?) {}
        for orders in OTHER_ORDERS {
            self.compare(self.best.system.clone(), self.best.choices.clone(), orders);
        }
        Ok(())
    }

    /// All formulas in one shape.
    fn choices(&self, inline: &[bool], shape: Option<Shape>) -> Choices {
        let formulas = self.forms.count();
        Choices { inline: inline.to_vec(), opened: vec![Vec::new(); formulas], shapes: vec![shape; formulas] }
    }

    /// Builds the program of choices, unless their formulas were there before, and says whether it is the cheapest so far.
    fn try_out(&mut self, choices: Choices) -> Result<bool, (Place, Undefined)> {
        let first = self.best.cost.is_none();
        if !first && self.is_over() {
            return Ok(false);
        }
        self.formulas_left = self.formulas_left.saturating_sub(self.forms.count());
        let system = System::new(&mut self.forms, &choices)?;
        if !self.seen.insert(system.formulas().to_vec()) {
            return Ok(false);
        }
        self.left -= 1;
        Ok(self.compare(system, choices, ORDERS))
    }

    /// Whether nothing more may be tried.
    fn is_over(&self) -> bool {
        self.left == 0 || self.formulas_left < self.forms.count()
    }

    /// Keeps a program if it is cheaper than the best so far: of equally cheap ones the first stays, so that the choice is
    /// the same on every run.
    fn compare(&mut self, system: System, choices: Choices, orders: usize) -> bool {
        let program = passes::optimize(system.program(self.engine, self.equations, &self.forms, orders));
        let cost = Counts::of(&program).cost();
        let cheaper = self.best.cost.is_none_or(|best| cost < best);
        if cheaper {
            self.best = Best { cost: Some(cost), program, choices, system };
        }
        cheaper
    }

    /// Which definitions divide by a sum, in themselves or through what they use, such as a centre of mass, and what they
    /// divide by: once all of it is inside of the formulas further on, the division may cancel out of them.
    fn find_fractions(&mut self) -> Result<Vec<bool>, (Place, Undefined)> {
        let definitions = &self.equations.definitions;
        let mut inline = vec![false; definitions.len()];
        definitions.iter().flat_map(find_divisors).for_each(|index| inline[index] = true);
        let mut values = self.forms.names();
        for (index, inline) in inline.iter_mut().enumerate() {
            let made = self.forms.make(index, &values)?;
            let form = self.forms.form(made);
            *inline |= form.is_fraction();
            if *inline && !System::keeps(form) {
                values[index] = made;
            }
        }
        Ok(inline)
    }

    /// Keeps definitions that went into the formulas that use them, one by one.
    fn keep(&mut self, fractions: &[bool]) -> Result<bool, (Place, Undefined)> {
        let mut better = false;
        for (index, fraction) in fractions.iter().enumerate() {
            if self.best.choices.inline[index] && !fraction {
                let mut choices = self.best.choices.clone();
                choices.inline[index] = false;
                for (formula, shape) in choices.shapes.iter_mut().enumerate() {
                    if self.forms.uses(formula).contains(&index) {
                        *shape = None;
                    }
                }
                better |= self.try_out(choices)?;
            }
        }
        Ok(better)
    }

    /// Puts definitions into one of the formulas that use them, one by one.
    fn open(&mut self) -> Result<bool, (Place, Undefined)> {
        let mut better = false;
        for formula in 0..self.forms.count() {
            for index in self.forms.uses(formula).to_vec() {
                if self.is_over() {
                    return Ok(better);
                }
                let best = &self.best.choices;
                if best.is_inside(formula) || best.inline[index] || best.opened[formula].contains(&index) {
                    continue;
                }
                let mut choices = best.clone();
                choices.opened[formula].push(index);
                let system = &self.best.system;
                let [closed, opened] = [&self.best.choices, &choices]
                    .map(|choices| system.form(&mut self.forms, formula, &choices.opened[formula]));
                if !self.forms.merges(closed?, system.inside(index), opened?) {
                    continue;
                }
                choices.shapes[formula] = None;
                better |= self.try_out(choices)?;
            }
        }
        Ok(better)
    }

    /// Gives formulas other shapes, one by one.
    fn reshape(&mut self) -> Result<bool, (Place, Undefined)> {
        let mut better = false;
        for formula in 0..self.forms.count() {
            if self.is_over() {
                break;
            }
            if self.best.choices.is_inside(formula) {
                continue;
            }
            let opened = &self.best.choices.opened[formula];
            let form = self.best.system.form(&mut self.forms, formula, opened)?;
            for shape in self.forms.worthwhile(form) {
                let mut choices = self.best.choices.clone();
                choices.shapes[formula] = Some(shape);
                better |= self.try_out(choices)?;
            }
        }
        Ok(better)
    }
}

/// Whether a formula is a product that divides by something.
fn divides(formula: &Formula) -> bool {
    match formula {
        Formula::Product(factors) => factors.iter().any(|factor| factor.inverse || divides(&factor.value)),
        _ => false,
    }
}

/// The definitions that a formula divides by.
fn find_divisors(formula: &Formula) -> Vec<usize> {
    let mut divisors = Vec::new();
    formula.walk(&mut |part| {
        if let Formula::Product(factors) = part {
            divisors.extend(factors.iter().filter(|factor| factor.inverse).flat_map(|factor| find_used(&factor.value)));
        }
    });
    divisors
}
