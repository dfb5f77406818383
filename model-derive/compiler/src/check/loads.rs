//! Steady loads of wheels in the formulas of side forces.

use super::names::Scope;
use super::resolve;
use super::units::LOAD;
use crate::formula::Formula;
use crate::report::Report;
use crate::syntax::{Declaration, Expression, Mechanism};

/// Where the loads of wheels may stand, and what for.
pub struct Loads<'a> {
    mechanism: &'a Mechanism,
    /// Loads are derived, and until then parameters behind those that are declared.
    behind: usize,
}

impl<'a> Loads<'a> {
    pub fn new(declaration: &Declaration, mechanism: &'a Mechanism) -> Self {
        Self { mechanism, behind: declaration.parameters.len() }
    }

    /// The formulas that may have loads in them.
    fn places(&self) -> impl Iterator<Item = &'a Expression> {
        let slips = self.mechanism.wheels.iter().filter_map(|wheel| wheel.slip.as_ref());
        slips.flat_map(|slip| [&slip.cornering].into_iter().chain(&slip.camber))
    }

    /// The parameter that stands for the load of the first wheel, if some formula has a load in it.
    pub fn first(&self) -> Option<usize> {
        let mut has_loads = false;
        self.places().for_each(|formula| formula.calls(&mut |name, _| has_loads |= name == LOAD));
        has_loads.then_some(self.behind)
    }

    /// Resolves what equations of motion are derived from, with what stands for each load.
    pub fn resolve(
        &self,
        declaration: &Declaration,
        scope: &mut Scope,
        load: impl Fn(usize) -> Formula,
        report: &mut Report,
    ) -> Vec<Formula> {
        let wheels = self.mechanism.wheels.iter().enumerate();
        let loads: Vec<(String, Formula)> =
            wheels.map(|(index, wheel)| (wheel.name.to_string(), load(self.behind + index))).collect();
        let formulas = declaration.attributes().map(|formula| {
            let may = self.places().any(|place| std::ptr::eq(place, formula));
            scope.loads = may.then(|| loads.clone());
            resolve::resolve(formula, scope, report)
        });
        let formulas = formulas.collect();
        scope.loads = None;
        formulas
    }
}
