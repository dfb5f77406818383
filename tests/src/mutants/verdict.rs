//! What the compiler says of a mutant.

use std::fmt;

use carvallo_compiler::check;
use carvallo_compiler::formula::Formula;
use carvallo_compiler::model::Model;

use super::Mutant;

/// What a mutant comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// It does not compile, and this check says so.
    Caught(Check),
    /// Its matrices and requirements are those of the original.
    Equivalent,
    /// It compiles, and they are others.
    Survived,
}

/// The checks of the compiler, each before those that depend on what it finds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Check {
    /// A definition that uses itself.
    Cycle,
    /// Two units that do not fit.
    Units,
    /// A formula that changes where the mirror image of the machine does not.
    Mirror,
    /// A name that nothing depends on any more.
    Unused,
    /// A formula without a value, or a set against a requirement.
    Value,
    /// A matrix that is not symmetric and should be.
    Symmetry,
    /// Two formulas that are not the same and are said to be.
    Assertion,
    /// A motion without kinetic energy.
    Energy,
    /// Matrices that are not the published ones.
    Published,
    /// Anything else.
    Other,
}

impl Check {
    /// All of them.
    pub const ALL: [Self; 10] = [
        Self::Cycle,
        Self::Units,
        Self::Mirror,
        Self::Unused,
        Self::Value,
        Self::Symmetry,
        Self::Assertion,
        Self::Energy,
        Self::Published,
        Self::Other,
    ];

    /// Parts of their messages; the first that a message contains decides.
    const MESSAGES: [(&str, Self); 15] = [
        ("in a cycle", Self::Cycle),
        ("is never used", Self::Unused),
        ("expected no `unused`", Self::Unused),
        ("a division by zero", Self::Value),
        ("not a real and finite number", Self::Value),
        ("the square root of a negative number", Self::Value),
        ("mirror", Self::Mirror),
        ("symmetric", Self::Symmetry),
        ("publishes", Self::Published),
        (" unit", Self::Units),
        ("this entry of", Self::Units),
        ("a pure number", Self::Units),
        ("the sides ", Self::Assertion),
        ("not positive definite", Self::Energy),
        (" in the set `", Self::Value),
    ];

    fn of(message: &str) -> Self {
        let found = Self::MESSAGES.into_iter().find(|(part, _)| message.contains(part));
        found.map_or(Self::Other, |(_, check)| check)
    }
}

impl fmt::Display for Check {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Cycle => "cycle",
            Self::Units => "units",
            Self::Mirror => "mirror",
            Self::Unused => "unused",
            Self::Value => "no value",
            Self::Symmetry => "symmetry",
            Self::Assertion => "assertion",
            Self::Energy => "energy",
            Self::Published => "published",
            Self::Other => "other",
        })
    }
}

/// A declaration that compiles, with its values at some designs.
#[derive(Debug)]
pub struct Original {
    declaration: String,
    designs: Vec<Vec<f64>>,
    values: Vec<Vec<Vec<f64>>>,
}

/// Two values are the same if they differ by less, relative to the largest of their matrix.
const SAME: f64 = 1e-12;

impl Original {
    /// With designs at which no two different formulas should agree.
    ///
    /// # Panics
    /// If the declaration does not compile.
    pub fn new(declaration: &str, designs: Vec<Vec<f64>>) -> Self {
        let model = read(declaration).expect("the original has no mistakes");
        let values = designs.iter().map(|design| values(&model, design)).collect();
        Self { declaration: declaration.to_string(), designs, values }
    }

    /// What the compiler makes of a mutant of this declaration.
    pub fn judge(&self, mutant: &Mutant) -> Verdict {
        let text = mutant.apply(&self.declaration);
        let model = match read(&text) {
            Ok(model) => model,
            Err(error) => return caught(error),
        };
        if self.is_equivalent(&model) {
            return Verdict::Equivalent;
        }
        Verdict::Survived
    }

    fn is_equivalent(&self, model: &Model) -> bool {
        self.designs.iter().zip(&self.values).all(|(design, expected)| {
            values(model, design).iter().zip(expected).all(|(found, expected)| {
                let largest = expected.iter().fold(0.0f64, |largest, value| largest.max(value.abs()));
                found.len() == expected.len()
                    && found.iter().zip(expected).all(|(a, b)| (a - b).abs() <= SAME * largest)
            })
        })
    }
}

fn read(declaration: &str) -> syn::Result<Model> {
    check(declaration.parse().expect("a mutant is made of tokens"))
}

/// Of several mistakes the first check counts, whatever the order in which they were found.
fn caught(error: syn::Error) -> Verdict {
    let first = error.into_iter().map(|error| Check::of(&error.to_string())).min();
    Verdict::Caught(first.expect("an error has a message"))
}

/// The entries of each matrix, and the left sides of the requirements.
fn values(model: &Model, design: &[f64]) -> Vec<Vec<f64>> {
    let mut definitions = Vec::new();
    for (_, definition) in &model.definitions {
        definitions.push(definition.evaluate(design, &definitions));
    }
    let value = |formula: &Formula| formula.evaluate(design, &definitions);
    let matrices = model.matrices.iter().map(|(_, rows)| rows.iter().flatten().map(value).collect());
    matrices.chain([model.requirements.iter().map(|requirement| value(&requirement.value)).collect()]).collect()
}

#[cfg(test)]
mod tests {
    use super::super::{Kind, all};
    use super::*;

    const DECLARATION: &str = "model X {
        parameters { a: kg; b: kg; e: kg, unused; }
        let c = 1*a;
        coordinates { q: m; }
        M = [[c + b]];
    }";

    /// The verdicts on the mutants of one kind, with how often each is given.
    fn verdicts(kind: Kind) -> Vec<(Verdict, usize)> {
        let original = Original::new(DECLARATION, vec![vec![1.5, 2.25, 0.75], vec![-0.5, 3.0, 7.0]]);
        let mut verdicts: Vec<Verdict> =
            all(DECLARATION).iter().filter(|mutant| mutant.kind == kind).map(|mutant| original.judge(mutant)).collect();
        verdicts.sort_unstable();
        verdicts.chunk_by(|a, b| a == b).map(|same| (same[0], same.len())).collect()
    }

    #[test]
    fn what_changes_nothing_is_equivalent() {
        // `1*a` as `1/a` is in another unit; without the 1 it is the same, and without the a it is a pure number.
        assert_eq!(verdicts(Kind::ProductOrQuotient), [(Verdict::Caught(Check::Units), 1)]);
        let expected = [(Verdict::Caught(Check::Units), 1), (Verdict::Equivalent, 1)];
        assert_eq!(verdicts(Kind::Factor), expected);
    }

    #[test]
    fn each_mutant_is_caught_by_the_first_check_that_finds_it() {
        // Three uses, each with three other names. The a of c: c itself, a cycle; b or e, so a is not used.
        // In M the c: a or b, so c is not used; e, likewise. The b: a, c or e, so b is not used.
        let expected = [(Verdict::Caught(Check::Cycle), 1), (Verdict::Caught(Check::Unused), 8)];
        assert_eq!(verdicts(Kind::SimilarName), expected);
        assert_eq!(verdicts(Kind::SignOfTerm), [(Verdict::Survived, 1)]);
    }
}
