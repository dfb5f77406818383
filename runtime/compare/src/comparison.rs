//! A comparison as one asks for it.

use std::marker::PhantomData;
use std::time::Duration;

use carvallo::{Coefficients, Model, ParameterError};

use crate::accuracy::{self, Accuracy, Errors};
use crate::assembly::{Assembly, AssemblyError};
use crate::designs::{Design, designs, regular_designs};
use crate::executed::{Instructions, NotCounted};
use crate::explain::{AtDesign, Evidence, Explanation, explain};
use crate::number::{Counted, Exact, Operations};
use crate::reference::Reference;
use crate::report::{Report, SideReport};
use crate::side::{Code, Side, counted, design, single};
use crate::time::{Task, batch, one_by_one};

/// How many designs explain a difference.
const EVIDENCE: usize = 8;

/// The generated code of a model and functions by hand, and what they are compared on.
///
/// [`compare!`](crate::compare) makes one with all number types; this is what it writes, and what it does not say.
pub struct Comparison<M, const N: usize> {
    sides: Vec<Side>,
    designs: Option<Vec<Design>>,
    random: usize,
    seed: u64,
    time: Option<Duration>,
    model: PhantomData<M>,
}

impl<M: Model<N, Scalar = f64> + 'static, const N: usize> Comparison<M, N> {
    /// The generated code of a model: its method `matrices`, or `Model::coefficients`.
    ///
    /// Unless it is told otherwise, it is compared at the sets of the model and at 500 random designs over the domains of the
    /// parameters which fulfil the requirements of the declaration. They are the same on every run.
    #[must_use]
    pub fn of<O: Into<Coefficients<f64, N>> + 'static>(generated: impl Fn(&M) -> O + Copy + 'static) -> Self {
        let start = Self { sides: Vec::new(), designs: None, random: 500, seed: 1899, time: None, model: PhantomData };
        start.against("generated", generated)
    }

    /// With a function by hand, which gives the same matrices.
    #[must_use]
    pub fn against<O: Into<Coefficients<f64, N>> + 'static>(
        mut self,
        name: impl Into<String>,
        by_hand: impl Fn(&M) -> O + Copy + 'static,
    ) -> Self {
        let double = Code::new(design::<N, M>, by_hand);
        self.sides.push(Side { name: name.into(), double, single: None, operations: None });
        self
    }

    /// The side that was named last, in `f32`.
    #[must_use]
    pub fn single<O: Into<Coefficients<f32, N>> + 'static>(
        mut self,
        function: impl Fn(&M::Over<f32>) -> O + Copy + 'static,
    ) -> Self
    where
        M::Over<f32>: 'static,
    {
        if let Some(side) = self.sides.last_mut() {
            side.single = Some(Code::new(single::<N, M>, function));
        }
        self
    }

    /// The side that was named last, in numbers that count their operations.
    #[must_use]
    pub fn counted<O>(mut self, function: impl Fn(&M::Over<Counted>) -> O + 'static) -> Self {
        if let Some(side) = self.sides.last_mut() {
            side.operations = Some(counted::<N, M, O>(function));
        }
        self
    }

    /// At so many random designs beside the sets of the model.
    #[must_use]
    pub fn random_designs(mut self, count: usize) -> Self {
        self.random = count;
        self
    }

    /// With other random designs.
    #[must_use]
    pub fn seed(mut self, seed: u64) -> Self {
        self.seed = seed;
        self
    }

    /// At these designs and no others. Their parameters are not validated.
    #[must_use]
    pub fn at(mut self, designs: impl IntoIterator<Item = M>) -> Self {
        let named = |(number, design): (usize, M)| Design {
            name: format!("design {number}"),
            parameters: design.parameters().as_ref().to_vec(),
        };
        self.designs = Some(designs.into_iter().enumerate().map(named).collect());
        self
    }

    /// Times all sides in turn as well, each task so long.
    #[must_use]
    pub fn timed(mut self, time: Duration) -> Self {
        self.time = Some(time);
        self
    }

    /// What is timed: one design again and again, and a loop over 64, in each number type; the batch beside the loop in `f64`.
    ///
    /// Each contender runs its own loop, so that a benchmark can call it: see the page of this crate for criterion.
    ///
    /// # Errors
    /// If no random design fulfils the requirements of the model.
    pub fn tasks(&self) -> Result<Vec<Task<'static>>, ParameterError> {
        let designs = self.all_designs()?;
        let parameters: Vec<Vec<f64>> = designs.iter().map(|design| design.parameters.clone()).collect();
        let mut tasks = Vec::new();
        for single in [false, true] {
            for count in [1, 64] {
                // Fewer designs than that go round.
                let designs: Vec<Vec<f64>> = parameters.iter().cycle().take(count).cloned().collect();
                let task = one_by_one(&self.sides, &designs, single);
                let with_batch = !single && count > 1;
                let task = if with_batch { task.map(|task| batch::<N, M>(task, &designs)) } else { task };
                tasks.extend(task);
            }
        }
        Ok(tasks)
    }

    /// The code of all sides as the processor has it, by `objdump`, which has to be installed.
    ///
    /// # Errors
    /// If there is no `objdump`, or it does not read the program that is running.
    pub fn assembly(&self) -> Result<Assembly, AssemblyError> {
        Assembly::of(&self.sides)
    }

    /// How many instructions all sides execute for a design in a loop over 64, by callgrind of valgrind, which has to be installed. The
    /// program runs itself again for it, with the same arguments, and of tests the one that asks: what stands before this is done
    /// twice more for each side and number type.
    ///
    /// # Errors
    /// If there is no valgrind, or no random design that fulfils the requirements of the model.
    pub fn instructions(&self) -> Result<Instructions, NotCounted> {
        let designs = self.all_designs().map_err(|error| NotCounted::Failed(error.to_string()))?;
        let designs: Vec<Vec<f64>> = designs.iter().cycle().take(64).map(|design| design.parameters.clone()).collect();
        Instructions::of(M::INFO.name, &self.sides, &designs)
    }

    fn all_designs(&self) -> Result<Vec<Design>, ParameterError> {
        match &self.designs {
            Some(designs) => Ok(designs.clone()),
            None => designs::<N, M>(self.random, self.seed),
        }
    }

    /// Compares.
    ///
    /// # Errors
    /// If no random design fulfils the requirements of the model.
    pub fn report(&self) -> Result<Report, ParameterError> {
        let designs = self.all_designs()?;
        let reference = Reference::of::<N, M>();
        let accuracies = |code: fn(&Side) -> Option<&Code>, precision: Precision| {
            self.accuracies(&designs, &reference, code, precision)
        };
        let double = accuracies(|side| Some(&side.double), Precision::DOUBLE);
        let single = accuracies(|side| side.single.as_ref(), Precision::SINGLE);
        let mut sides = Vec::new();
        for (side, (double, single)) in self.sides.iter().zip(double.into_iter().zip(single)) {
            let double = double.expect("every side has a function in `f64`");
            let (explanations, unexplained) = self.explain(&reference, (&side.double, &double), Precision::DOUBLE)?;
            let in_single = match side.single.as_ref().zip(single.as_ref()) {
                Some(own) => self.explain(&reference, own, Precision::SINGLE)?,
                None => Explained::default(),
            };
            sides.push(SideReport {
                name: side.name.clone(),
                operations: side.operations.as_ref().map(|operations| most(operations, &designs)),
                double,
                single,
                explanations,
                unexplained,
                explanations_in_single: in_single.0,
                unexplained_in_single: in_single.1,
            });
        }
        let times = match self.time {
            Some(time) => self.tasks()?.into_iter().map(|task| (task.name.clone(), task.race(time)).into()).collect(),
            None => Vec::new(),
        };
        Ok(Report {
            model: M::INFO,
            parameters: M::INFO.parameters.iter().map(|parameter| parameter.name).collect(),
            reference: reference.kind(),
            designs: designs.len(),
            seed: self.designs.is_none().then_some(self.seed),
            sides,
            times,
            optimized: !cfg!(debug_assertions),
        })
    }

    /// The errors of each side that has a function in a number type.
    fn accuracies(
        &self,
        designs: &[Design],
        reference: &Reference,
        code: fn(&Side) -> Option<&Code>,
        Precision { epsilon, rounded }: Precision,
    ) -> Vec<Option<Accuracy>> {
        let mut all: Vec<_> = self.sides.iter().map(|side| Some((code(side)?, Errors::new(epsilon)))).collect();
        if all.iter().any(Option::is_some) {
            for design in designs {
                let parameters: Vec<f64> = design.parameters.iter().copied().map(rounded).collect();
                let exact = reference.entries(&parameters);
                for (code, errors) in all.iter_mut().flatten() {
                    errors.add(N, &(code.entries)(&parameters), &exact, design);
                }
            }
        }
        let accuracy = |side: Option<(&Code, Errors)>| Some(side?.1.accuracy(N, |entry| reference.formula(entry)));
        all.into_iter().map(accuracy).collect()
    }

    /// What explains the differences of a side in a number type, if there are any.
    fn explain(
        &self,
        reference: &Reference,
        (code, accuracy): (&Code, &Accuracy),
        Precision { epsilon, rounded }: Precision,
    ) -> Result<Explained, ParameterError> {
        if accuracy.differences.is_empty() {
            return Ok(Explained::default());
        }
        let at = |parameters: Vec<f64>| {
            let parameters: Vec<f64> = parameters.into_iter().map(rounded).collect();
            let exact: Vec<Exact> = reference.entries(&parameters);
            let by_hand = (code.entries)(&parameters);
            let (exact, sizes) = exact.iter().map(|exact| (exact.value.to_f64(), exact.size)).unzip();
            let values = reference.formulas().map(|formulas| formulas.values(&parameters)).unwrap_or_default();
            AtDesign { parameters, values, exact, sizes, by_hand }
        };
        let designs = regular_designs::<N, M>(EVIDENCE, self.seed)?.into_iter().map(at).collect();
        let same = accuracy::same(epsilon);
        Ok(explain(&Evidence { info: M::INFO, formulas: reference.formulas(), designs, same }))
    }
}

/// A number type: its epsilon, and the number of it that is nearest to another.
#[derive(Clone, Copy)]
struct Precision {
    epsilon: f64,
    rounded: fn(f64) -> f64,
}

impl Precision {
    const DOUBLE: Self = Self { epsilon: f64::EPSILON, rounded: |value| value };
    const SINGLE: Self = Self { epsilon: f32::EPSILON as f64, rounded: |value| f64::from(value as f32) };
}

/// What explains some entries that differ, and those that nothing explains.
type Explained = (Vec<Explanation>, Vec<String>);

/// The most operations at any of some designs: a function may have branches.
fn most(operations: &dyn Fn(&[f64]) -> Operations, designs: &[Design]) -> Operations {
    let few = designs.iter().take(EVIDENCE).map(|design| operations(&design.parameters));
    few.max_by_key(|operations| operations.total()).unwrap_or_default()
}
