//! A convention, or an entry that is mistaken, beside another cause.

use crate::conventions::{Convention, Effect};
use crate::machine::Machine;
use crate::predict::{Predictor, World};
use crate::relation::Relation;

/// What acts on matrices, with what must hold before it does.
pub struct Acting<'a> {
    pub convention: &'a Convention,
    /// Those that tell the most first.
    before: Vec<Relation>,
    gravity: f64,
    count: usize,
}

impl<'a> Acting<'a> {
    pub fn new(machine: &Machine, predictor: &Predictor, convention: &'a Convention) -> Self {
        let here = machine.world();
        let count = machine.formulas.count;
        let before = convention.assignments(count).map(|assignments| {
            let all = predictor.relations_of_open_loop(&here).into_iter();
            let mut before: Vec<Relation> = all.map(|own| own.before(&assignments)).collect();
            before.sort_by_key(|own| own.holds(&here.entries, here.gravity));
            before
        });
        Self { convention, before: before.unwrap_or_default(), gravity: here.gravity, count }
    }

    /// What it makes of matrices for the parameters as they are, if everything fits then, as far as it is tried.
    pub fn fitting(&self, old: &World, predictor: &Predictor) -> Option<World> {
        if !predictor.has_left() || !self.before.iter().all(|own| own.holds(&old.entries, self.gravity)) {
            return None;
        }
        let mut own = World::default();
        self.convention.change_matrices(old, &mut own, self.count);
        predictor.fits_if_tried(&own).then_some(own)
    }

    /// Whether it changes nothing that another one changes or uses, and the other way round.
    pub fn is_beside(&self, other: &Self) -> bool {
        let (Effect::Entries(own), Effect::Entries(others)) = (&self.convention.effect, &other.convention.effect)
        else {
            return false;
        };
        own.iter().all(|a| others.iter().all(|b| a.to != b.to && a.to != b.from && a.from != b.to))
    }
}
