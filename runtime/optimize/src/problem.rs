//! What is asked for: a design, what of it may change, what is best, and what must be kept.

use carvallo_design::conventions::Varied;
use carvallo_design::input::warning_of_varied;
use carvallo_design::number::{shortest, with_unit};
use carvallo_design::{Design, Dual, Failure, Place};

use crate::bodies;
use crate::constraint::Constraint;
use crate::goal::{Goal, Measure};
use crate::range::{Range, naming};

/// What is asked for.
#[derive(Debug)]
pub struct Problem<'a> {
    /// Where it begins.
    pub design: &'a Design,
    /// What may change.
    pub ranges: Vec<Range>,
    /// What is best.
    pub goal: Goal,
    /// What must be kept, with what every bicycle keeps.
    pub constraints: Vec<Constraint>,
    /// How it is searched.
    pub settings: Settings,
    varied: Varied,
}

/// The name in front of a range, as it was given.
fn spelled(written: &str) -> &str {
    written.split('=').next().unwrap_or_default().trim()
}

/// How it is searched.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// The speeds that count, in m/s, from the lower to the higher one.
    pub speeds: [f64; 2],
    /// From how many designs the search begins: the given one, and others within the ranges.
    pub starts: u32,
    /// Of the generator of those others.
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Self { speeds: [0.0, 20.0], starts: 8, seed: 1 }
    }
}

impl<'a> Problem<'a> {
    /// A problem with constraints such as `xB >= 0.2`.
    ///
    /// # Errors
    /// If nothing may change, or a parameter has two ranges; if the design cannot be expressed by the names of what varies; if a
    /// constraint cannot be read; or if nothing of the model depends on the speed, of which the goal is.
    pub fn new(design: &'a Design, ranges: Vec<Range>, goal: Goal, keep: &[String]) -> Result<Self, Failure> {
        let info = design.info();
        if ranges.is_empty() {
            return Err(Failure::usage("nothing may change: expected ranges, such as --vary w=0.9:1.2"));
        }
        let naming = naming(ranges.iter().map(|range| range.written.as_str()), info);
        for (index, range) in ranges.iter().enumerate() {
            let name = range.parameter.name;
            let mut before = ranges[..index].iter();
            if let Some(first) = before.find(|other| range.varying.is_in_place_of(&other.varying, &naming)) {
                let message = match first.varying.is(&range.varying) {
                    true if spelled(&first.written) == spelled(&range.written) => {
                        format!("`{name}` has a range already")
                    }
                    true => {
                        let [own, other] = [range, first].map(|range| spelled(&range.written));
                        format!("`{own}` is `{other}`, which has a range already")
                    }
                    false => {
                        format!("`{name}` stands in the place of `{}`, which has a range, too", first.parameter.name)
                    }
                };
                return Err(Failure::at(Place::Option(format!("--vary {}", range.written)), message));
            }
        }
        let columns: Vec<_> = ranges.iter().map(|range| Some(&range.varying)).collect();
        let varied = Varied::new(design, &naming, &columns)
            .map_err(|message| Failure::usage(format!("{}: {message}", design.title())))?;
        if let Some(message) = varied.conflict().or_else(|| varied.fixed()) {
            return Err(Failure::usage(message));
        }
        if !matches!(goal.measure, Measure::Parameter(..)) && !design.model.depends_on_speed() {
            let message =
                format!("nothing in the model {} depends on the speed, so it has no {}", info.name, goal.measure);
            return Err(Failure::usage(message));
        }
        let values = design.values();
        let mut constraints = bodies::constraints(info, &varied.changing());
        for written in keep {
            constraints.push(Constraint::parse(written, info, &values, naming.convention())?);
        }
        let problem = Self { design, ranges, goal, constraints, settings: Settings::default(), varied };
        match problem.fixed_goal() {
            Some(message) => Err(Failure::usage(message)),
            None => Ok(problem),
        }
    }

    /// That the goal is a parameter that does not change, if it is.
    fn fixed_goal(&self) -> Option<String> {
        let Measure::Parameter(quantity) = self.goal.measure else { return None };
        let count = self.ranges.len();
        let changes = |share: f64| {
            let varied = self.at(&vec![share; count]);
            let (values, slopes) = (self.values(&varied).ok()?, self.slopes(&varied));
            let by = |slopes: &Vec<f64>| {
                let own = |at: usize| Dual { value: values[at], slope: slopes[at] };
                quantity.value(self.design.info(), &own).is_some_and(|value| value.slope != 0.0)
            };
            Some(slopes.iter().any(by))
        };
        // Where there is no such design in the middle, and where it does not change there by chance, it may elsewhere.
        let is_fixed = [0.5, 0.31].into_iter().all(|share| changes(share) == Some(false));
        let names: Vec<String> = self.ranges.iter().map(|range| format!("`{}`", range.parameter.name)).collect();
        is_fixed.then(|| format!("`{}` does not change with {}", self.goal.measure, names.join(", ")))
    }

    /// The same, searched in another way.
    ///
    /// # Errors
    /// If no speeds count, or there is no start.
    pub fn with(self, settings: Settings) -> Result<Self, Failure> {
        let [low, high] = settings.speeds;
        if !(low >= 0.0 && low < high && high.is_finite()) {
            let [low, high] = [low, high].map(shortest);
            return Err(Failure::usage(format!(
                "the speeds that count are from {low} to {high} m/s; they must ascend from 0"
            )));
        }
        if settings.starts == 0 {
            return Err(Failure::usage("the search has no start: expected 1 or more"));
        }
        Ok(Self { settings, ..self })
    }

    /// What varies by other names than those of the model, what is kept with it, and what follows.
    pub fn note(&self) -> Option<String> {
        self.varied.note()
    }

    /// That the design lies outside of ranges, so that the search begins elsewhere.
    pub fn outside(&self) -> Option<String> {
        let outside = |(at, range): (usize, &Range)| {
            let before = self.before(at).filter(|before| !(range.low..=range.high).contains(before))?;
            let [before, end] =
                [before, range.at(range.share(before))].map(|value| with_unit(value, range.parameter.unit));
            Some(format!(
                "`{}` is {before}, beyond its range, of which the search begins at {end}",
                range.parameter.name
            ))
        };
        let found: Vec<String> = self.ranges.iter().enumerate().filter_map(outside).collect();
        (!found.is_empty()).then(|| found.join("; "))
    }

    /// Ranges whose ends seem to be in another unit than that of their parameter, of each once.
    pub fn warnings(&self) -> Vec<String> {
        let given = |range: usize| self.before(range).unwrap_or(self.ranges[range].high);
        let warning = |(varied, range): (usize, &Range)| {
            let end = if range.high >= -range.low { range.high } else { range.low };
            let values: Vec<f64> =
                (0..self.ranges.len()).map(|at| if at == varied { end } else { given(at) }).collect();
            warning_of_varied(&range.parameter, end, self.design.info(), &self.values(&values).ok()?)
        };
        self.ranges.iter().enumerate().filter_map(warning).collect()
    }

    /// The value that the given design has of the parameter of a range, if it is known.
    pub fn before(&self, range: usize) -> Option<f64> {
        match self.ranges[range].varying.position() {
            Some(position) => Some(self.design.parameters[position].value),
            None => self.varied.start(range),
        }
    }

    /// The values of the parameters with ranges at shares of these.
    pub(crate) fn at(&self, shares: &[f64]) -> Vec<f64> {
        self.ranges.iter().zip(shares).map(|(range, share)| range.at(*share)).collect()
    }

    /// All parameters of the model at values of those with ranges.
    ///
    /// # Errors
    /// If there is no such design.
    pub(crate) fn values(&self, varied: &[f64]) -> Result<Vec<f64>, String> {
        let mut values = self.design.values();
        self.varied.put(|range| Some(varied[range]), &mut values)?;
        Ok(values)
    }

    /// The derivatives of all parameters of the model by the share of each range; zero where there are none.
    pub(crate) fn slopes(&self, varied: &[f64]) -> Vec<Vec<f64>> {
        let count = self.ranges.len();
        let found = self.varied.derivatives(count, |range| Some(varied[range]));
        let mut slopes = found.unwrap_or_else(|_| vec![vec![0.0; self.design.parameters.len()]; count]);
        for (slopes, range) in slopes.iter_mut().zip(&self.ranges) {
            slopes.iter_mut().for_each(|slope| *slope *= range.high - range.low);
        }
        slopes
    }
}
