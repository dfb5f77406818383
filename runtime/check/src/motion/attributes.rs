//! Accelerations by the nonlinear equations for any values of the attributes of a mechanism.

use carvallo::motion::{self, MotionError, MotionInfo};
use carvallo::simulation::Moving;
use carvallo::{FormulaSubject, ModelInfo};

use super::program::Program;

/// The equations as text that was read.
#[derive(Clone, Debug)]
pub struct ByAttributes {
    constants: Program,
    closure: Program,
    rates: Program,
    accelerations: Program,
}

impl ByAttributes {
    /// Those of a model; `None` where it has none.
    pub fn new(model: &ModelInfo, info: &MotionInfo) -> Option<Self> {
        let text = model.motion?;
        let is_attribute = |subject: FormulaSubject| matches!(subject, FormulaSubject::Attribute { .. });
        let attributes = model.attributes.iter().filter(|formula| is_attribute(formula.of)).count();
        let read = [('A', attributes), ('P', model.parameters.len())];
        let constants = Program::new(text.constants, &read, 'C')?;
        let of_state = [
            ('C', constants.results()),
            ('Q', info.positions.len()),
            ('U', info.speeds.len()),
            ('F', info.forces.len()),
        ];
        let closure = Program::new(text.closure, &of_state[..2], 'R')?;
        let accelerations = Program::new(text.accelerations, &of_state, 'R')?;
        Some(Self { constants, closure, rates: accelerations.first(info.positions.len()), accelerations })
    }

    /// Whether the motion depends on an attribute, by its place.
    pub fn depend_on(&self, attribute: usize) -> bool {
        self.constants.depends_on(attribute)
    }

    /// The machine with these attributes, in their order, and parameters, which are what is no attribute.
    pub fn machine(&self, info: &'static MotionInfo, attributes: &[f64], parameters: &[f64]) -> WithAttributes<'_> {
        WithAttributes { info, equations: self, constants: self.constants.run(&[attributes, parameters]) }
    }
}

/// A machine with attributes of its own.
#[derive(Debug)]
pub struct WithAttributes<'a> {
    info: &'static MotionInfo,
    equations: &'a ByAttributes,
    constants: Vec<f64>,
}

/// Writes results that are all finite.
fn write(quantity: &'static str, found: &[f64], values: &mut [f64]) -> Result<(), MotionError> {
    values.copy_from_slice(found);
    if values.iter().all(|value| value.is_finite()) { Ok(()) } else { Err(MotionError::Singular { quantity }) }
}

impl Moving for WithAttributes<'_> {
    fn info(&self) -> &'static MotionInfo {
        self.info
    }

    fn close(&self, positions: &mut [f64]) -> Result<(), MotionError> {
        let closure = |positions: &Vec<f64>| {
            let mut below = self.equations.closure.run(&[&self.constants, positions]);
            let steps = below.split_off(below.len() / 2);
            (below, steps)
        };
        positions.copy_from_slice(&motion::close(closure, self.info, positions.to_vec())?);
        Ok(())
    }

    fn rates(&self, positions: &[f64], speeds: &[f64], rates: &mut [f64]) -> Result<(), MotionError> {
        let forces = vec![0.0; self.info.forces.len()];
        write("a rate", &self.equations.rates.run(&[&self.constants, positions, speeds, &forces]), rates)
    }

    fn accelerations(
        &self,
        positions: &[f64],
        speeds: &[f64],
        forces: &[f64],
        accelerations: &mut [f64],
    ) -> Result<(), MotionError> {
        let found = self.equations.accelerations.run(&[&self.constants, positions, speeds, forces]);
        write("an acceleration", &found[positions.len()..], accelerations)
    }
}

#[cfg(test)]
mod tests {
    use carvallo::simulation::Machine;
    use carvallo_design::MODELS;
    use carvallo_slips::{Formulas, Subject};

    use super::*;

    /// Evenly spread in -1 to 1, by the golden ratio.
    fn spread(at: usize) -> f64 {
        2.0 * ((at as f64 + 1.0) * 0.618_033_988_749_895).fract() - 1.0
    }

    fn all(size: f64, first: usize, count: usize) -> Vec<f64> {
        (first..first + count).map(|at| size * spread(at)).collect()
    }

    /// Positions that are closed, rates of all of them, and accelerations.
    fn found(machine: &dyn Moving, number: usize) -> Result<[Vec<f64>; 3], MotionError> {
        let info = machine.info();
        let mut positions = all(0.4, 100 * number, info.positions.len());
        let speeds = all(5.0, 100 * number + 20, info.speeds.len());
        let forces = all(3.0, 100 * number + 40, info.forces.len());
        machine.close(&mut positions)?;
        let [mut rates, mut accelerations] = [positions.clone(), positions.clone()];
        machine.rates(&positions, &speeds, &mut rates)?;
        machine.accelerations(&positions, &speeds, &forces, &mut accelerations)?;
        Ok([positions, rates, accelerations])
    }

    /// The text makes what the compiled code makes: of every model that has nonlinear equations, also for other designs than those that
    /// ship, in states far from upright.
    #[test]
    fn the_text_makes_the_accelerations_of_every_mechanism() {
        let mut compared = 0;
        for model in MODELS.iter().filter(|model| model.info.motion.is_some()) {
            let formulas = Formulas::with_attributes(model.info, model.info.attributes).expect("formulas");
            let is_attribute = |at: &usize| matches!(formulas.formulas[*at].subject, Subject::Attribute(_));
            for number in 0..20 {
                let design = |(at, value): (usize, &f64)| value * (1.0 + 0.1 * spread(at + 37 * number));
                let parameters: Vec<f64> = model.info.sets[0].values.iter().enumerate().map(design).collect();
                let values = formulas.values(&parameters);
                let attributes = (0..formulas.definitions).filter(is_attribute).map(|at| values.definition(at));
                let attributes: Vec<f64> = attributes.collect();
                let mut compare = |machine: &dyn Machine| {
                    let by_attributes = ByAttributes::new(model.info, machine.info()).expect("text that can be read");
                    let by_text = found(&by_attributes.machine(machine.info(), &attributes, &parameters), number);
                    let Ok(compiled) = found(machine, number) else {
                        assert!(by_text.is_err(), "{}", model.info.name);
                        return;
                    };
                    for (own, expected) in by_text.expect("a motion").iter().zip(compiled) {
                        let largest = expected.iter().fold(1.0, |largest: f64, value| largest.max(value.abs()));
                        let is_same = own.iter().zip(&expected).all(|(a, b)| (a - b).abs() <= 1e-11 * largest);
                        assert!(is_same, "{} {number}: {own:?}, not {expected:?}", model.info.name);
                    }
                    compared += 1;
                };
                // A design that does not hold has no equations.
                let _ = model.with_machine(&parameters, &mut compare);
            }
        }
        // Of six models.
        assert!(compared > 100, "{compared}");
    }
}
