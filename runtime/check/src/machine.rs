//! A machine with everything that may be mistaken about it.

use std::sync::OnceLock;

use carvallo::{FormulaInfo, ModelInfo};
use carvallo_design::Design;
use carvallo_design::feedback::{Gain, Law};
use carvallo_design::units::Units;
use carvallo_slips::{FormulaSlip, Formulas, Subject, Values, index, place};

use crate::conventions::{self, Convention};
use crate::explain::Cause;
use crate::motion::Nonlinear;
use crate::predict::World;

/// A design, its formulas with their values, and all slips and conventions.
#[derive(Debug)]
pub struct Machine {
    /// What the model tells about itself.
    pub info: &'static ModelInfo,
    /// Its formulas.
    pub formulas: Formulas,
    /// The values of the parameters.
    pub parameters: Vec<f64>,
    /// The feedback: all numbers are those of the closed loop.
    pub feedback: Vec<Law>,
    /// What reports show values in.
    pub units: Units,
    /// Its nonlinear equations, where it has any in the same coordinates.
    pub motion: Option<Nonlinear>,
    /// The values of the formulas.
    pub values: Values,
    /// What may be otherwise on purpose, by a convention: with a slip, or with another convention.
    pub usual: Vec<Convention>,
    /// Those of all that C or K at a speed is made of, where these or state matrices are given.
    pub sums: Vec<Convention>,
    /// Powers of the speed that are forgotten, where anything is given at speeds.
    pub powers: Vec<Convention>,
    /// Entries and parameters that are mistaken by themselves.
    pub single: Vec<Convention>,
    /// Of each place among the entries the formula.
    places: Vec<Option<usize>>,
    /// The attributes among the formulas, in their order, where the nonlinear equations depend on them.
    attributes: Vec<usize>,
    /// The text of the attributes that are among the formulas.
    by_attributes: &'static [FormulaInfo],
    wholes: OnceLock<[Vec<Convention>; 2]>,
    slips: OnceLock<Vec<FormulaSlip>>,
    worlds: OnceLock<Worlds>,
    others: OnceLock<Vec<Machine>>,
    with_mechanism: OnceLock<Option<Box<Machine>>>,
}

/// The matrices of every single cause.
#[derive(Debug)]
struct Worlds {
    /// Of the usual conventions, then the others.
    conventions: Vec<World>,
    /// Of the slips; `None` where one makes none.
    slips: Vec<Option<World>>,
}

impl Machine {
    /// Everything about a design.
    ///
    /// # Errors
    /// If its model has no formulas, as matrices that are given themselves.
    pub fn new(design: &Design) -> Result<Self, String> {
        Self::closed(design.info(), design.info().attributes, &design.values(), &design.feedback)
    }

    /// The same from a model and the values of its parameters.
    ///
    /// # Errors
    /// As there.
    pub fn with(info: &'static ModelInfo, parameters: &[f64]) -> Result<Self, String> {
        Self::closed(info, info.attributes, parameters, &[])
    }

    /// The same machine with other feedback; `None` where that is none.
    pub fn closed_by(&self, feedback: &[Law]) -> Option<Self> {
        Self::closed(self.info, self.by_attributes, &self.parameters, feedback).ok().filter(|_| !feedback.is_empty())
    }

    /// The same machine with the mechanism of its nonlinear equations among its formulas; `None` where that is there already, or
    /// where it has none.
    pub fn with_mechanism(&self) -> Option<&Self> {
        let with_mechanism = || {
            let by_attributes = self.motion.as_ref().map(Nonlinear::attributes)?;
            let closed = || Self::closed(self.info, by_attributes, &self.parameters, &self.feedback);
            let machine = if self.by_attributes.is_empty() { closed().ok() } else { None };
            machine.map(|machine| Box::new(Self { units: self.units.clone(), ..machine }))
        };
        self.with_mechanism.get_or_init(with_mechanism).as_deref()
    }

    fn closed(
        info: &'static ModelInfo,
        by_attributes: &'static [FormulaInfo],
        parameters: &[f64],
        feedback: &[Law],
    ) -> Result<Self, String> {
        let formulas = Formulas::with_attributes(info, by_attributes)?;
        let values = formulas.values(parameters);
        let gravity = info.gravity.map_or(0.0, |at| parameters[at]);
        // Of a closed loop the sign of its feedback is the likeliest.
        let mut usual = conventions::feedback(info, feedback);
        let gains = feedback.iter().flat_map(|law| &law.gains);
        let closed: Vec<usize> =
            gains.flat_map(|gain| entries_of(gain, info, parameters)).map(|(entry, _)| entry).collect();
        let of_open_loop = |own: Convention| own.of_open_loop(&closed);
        usual.extend(conventions::matrices(info, &values.entries, gravity).into_iter().map(of_open_loop));
        usual.extend(conventions::speeds(info, feedback));
        usual.extend(conventions::usual(info, parameters));
        // Gains are those of the coordinates as they are.
        usual.extend(if feedback.is_empty() { conventions::coordinates(info) } else { Vec::new() });
        let sums = conventions::sums(info, &values.entries).into_iter().map(of_open_loop).collect();
        let powers = conventions::powers(info).into_iter().map(of_open_loop).collect();
        let mut single: Vec<Convention> =
            conventions::entries(info, &values.entries).into_iter().map(of_open_loop).collect();
        single.extend(conventions::parameters(info, parameters));
        single.extend(conventions::shipped(info, parameters));
        single.extend(conventions::gains(info, feedback));
        let (parameters, feedback) = (parameters.to_vec(), feedback.to_vec());
        let (wholes, slips, worlds, others, with_mechanism) = Default::default();
        let (units, motion) = (Units::default(), Nonlinear::new(info));
        let entry = |at: usize| {
            let (matrix, row, column) = place(at, formulas.count);
            formulas.entry(matrix, row, column)
        };
        let places = (0..values.entries.len()).map(entry).collect();
        let is_attribute = |at: &usize| matches!(formulas.formulas[*at].subject, Subject::Attribute(_));
        let attributes = (0..formulas.definitions).filter(|at| motion.is_some() && is_attribute(at)).collect();
        Ok(Self {
            info,
            formulas,
            parameters,
            feedback,
            units,
            motion,
            values,
            usual,
            sums,
            powers,
            single,
            places,
            attributes,
            by_attributes,
            wholes,
            slips,
            worlds,
            others,
            with_mechanism,
        })
    }

    /// Whole matrices that are others, where these are given; and one coordinate in degrees, where matrices of any kind are.
    pub fn wholes(&self) -> &[Vec<Convention>; 2] {
        self.wholes.get_or_init(|| {
            let gravity = self.gravity(&self.parameters);
            let gains = self.gains().flat_map(|gain| entries_of(gain, self.info, &self.parameters));
            let closed: Vec<usize> = gains.map(|(entry, _)| entry).collect();
            let all = [conventions::wholes(self.info, &self.values.entries, gravity), conventions::degrees(self.info)];
            all.map(|own| own.into_iter().map(|own| own.of_open_loop(&closed)).collect())
        })
    }

    /// Every slip of every formula, in their order; those of a formula that several entries share in all of them, and in
    /// each alone. They are made when they are first asked for.
    pub fn slips(&self) -> &[FormulaSlip] {
        self.slips.get_or_init(|| self.formulas.slips())
    }

    /// Tells every single cause that is no other value of something, with the matrices that it makes.
    pub fn singles<'a>(&'a self, tell: &mut dyn FnMut(Cause<'a>, &World)) {
        let Worlds { conventions, slips } = self.worlds.get_or_init(|| self.all_worlds());
        let all = self.usual.iter().chain(&self.single).zip(conventions);
        all.for_each(|(convention, world)| tell(Cause::Convention(convention), world));
        for (slip, world) in self.slips().iter().zip(slips) {
            world.iter().for_each(|world| tell(Cause::Slip(slip), world));
        }
    }

    fn all_worlds(&self) -> Worlds {
        let mut own = self.values.clone();
        let mut world = |slip: &FormulaSlip| {
            let is_any = slip.apply(&self.formulas, &self.parameters, &self.values, &mut own);
            is_any.then(|| self.world_from(own.clone(), &self.parameters))
        };
        Worlds {
            conventions: self.usual.iter().chain(&self.single).map(|own| self.world_with(own)).collect(),
            slips: self.slips().iter().map(&mut world).collect(),
        }
    }

    /// The machine with other parameters, twice, at which no two different formulas should agree.
    pub fn others(&self) -> &[Self] {
        self.others.get_or_init(|| {
            let vary = |number: usize, (at, value): (usize, &f64)| {
                // The golden ratio spreads them evenly.
                let fraction = ((at + 1 + 37 * number) as f64 * 0.618_033_988_749_895).fract();
                if *value == 0.0 { 0.05 + 0.1 * fraction } else { value * (0.9 + 0.2 * fraction) }
            };
            let other = |number: usize| -> Vec<f64> {
                self.parameters.iter().enumerate().map(|own| vary(number, own)).collect()
            };
            (0..2)
                .filter_map(|number| Self::closed(self.info, self.by_attributes, &other(number), &self.feedback).ok())
                .collect()
        })
    }

    /// The gravitational field strength among parameters.
    pub fn gravity(&self, parameters: &[f64]) -> f64 {
        self.info.gravity.map_or(0.0, |at| parameters[at])
    }

    /// The gains of all laws of the feedback, one after the other.
    pub fn gains(&self) -> impl Iterator<Item = &Gain> {
        self.feedback.iter().flat_map(|law| &law.gains)
    }

    /// The terms of the feedback that are taken from an entry: `"3*v*delta" of Tdelta`.
    pub fn fed_back(&self, entry: usize) -> Vec<String> {
        let each = self.feedback.iter().flat_map(|law| law.gains.iter().map(move |gain| (law, gain)));
        let own = each.filter(|(_, gain)| {
            entries_of(gain, self.info, &self.parameters).iter().any(|(closed, _)| *closed == entry)
        });
        own.map(|(law, gain)| format!("\"{}\" of {}", conventions::term(gain, self.info), law.force(self.info).0))
            .collect()
    }

    /// The formula of the entry at a place, if the model has any.
    pub fn formula(&self, place: usize) -> Option<usize> {
        self.places[place]
    }

    /// The place of what a formula is of among the entries of a [`World`]; `None` of a definition.
    pub fn place(&self, formula: usize) -> Option<usize> {
        match self.formulas.formulas[formula].subject {
            Subject::Entry(matrix, row, column) => Some(index(matrix, row, column, self.formulas.count)),
            Subject::Definition(_) | Subject::OfMechanism(_) | Subject::Attribute(_) => None,
        }
    }

    /// The matrices as they are.
    pub fn world(&self) -> World {
        self.world_from(self.values.clone(), &self.parameters)
    }

    /// The matrices for other parameters.
    pub fn world_of(&self, parameters: &[f64]) -> World {
        self.world_from(self.formulas.values(parameters), parameters)
    }

    /// With these values, for parameters that have the gravitational field strength among them.
    pub fn world_from(&self, values: Values, parameters: &[f64]) -> World {
        let gains = self.gains().map(|gain| gain.value).collect();
        let (gravity, attributes) = (self.gravity(parameters), self.attributes(&values));
        World { entries: values.entries, gravity, gains, parameters: parameters.to_vec(), attributes }
    }

    /// The attributes that the nonlinear equations depend on.
    pub fn attributes(&self, values: &Values) -> Vec<f64> {
        self.attributes.iter().map(|&at| values.definition(at)).collect()
    }

    /// The matrices with a convention.
    pub fn world_with(&self, convention: &Convention) -> World {
        let mut parameters = self.parameters.clone();
        convention.change_parameters(&mut parameters);
        let old = self.world_of(&parameters);
        let mut own = World::default();
        convention.change_matrices(&old, &mut own, self.formulas.count);
        own
    }
}

/// The entries that a gain is taken from, and its share in each.
pub fn entries_of(gain: &Gain, info: &ModelInfo, parameters: &[f64]) -> Vec<(usize, f64)> {
    let entry = |row: usize| index(gain.matrix, row, gain.column, info.coordinates.len());
    let shares = gain.input.shares(info, parameters).into_iter().enumerate();
    shares.filter(|(_, share)| *share != 0.0).map(|(row, share)| (entry(row), share)).collect()
}
