//! The eigenvalues of a design followed one by one along a parameter, with the names that their modes have along the speed.

use std::sync::{Arc, OnceLock};

use carvallo::{Branches, Complex, CriticalSpeed, CriticalValue, Mode, ModeValue, SystemError, Verdict};
use carvallo_design::Failure;

use super::along::AlongAnalysis;
use super::followed::Followed;
use super::reach::reach;
use super::{Eigenvalues, Row, is_bicycle, leans_and_steers};

/// Followed eigenvalues.
pub struct Traced<'a> {
    analysis: &'a AlongAnalysis,
    branches: Branches,
    /// The names of the branches at both ends of the range.
    ends: [Vec<Mode>; 2],
}

impl<'a> Traced<'a> {
    /// Follows them over the range.
    ///
    /// # Errors
    /// If there are no eigenvalues at some value.
    pub fn new(analysis: &'a AlongAnalysis) -> Result<Self, Failure> {
        let AlongAnalysis { design, range: [low, high], stability, .. } = analysis;
        let parameter = analysis.parameter;
        let (model, path, speed, low) = (design.model, analysis.path.clone(), analysis.speed.unwrap_or(0.0), *low);
        let told = Arc::new(OnceLock::new());
        let telling = Arc::clone(&told);
        // Branches begin at zero or above, as speeds do.
        let eigenvalues = move |place: f64| {
            let fail = |message| {
                let _ = telling.set(message);
                SystemError::NotFinite { quantity: parameter.name, value: low + place }
            };
            let values = path.at(low + place).map_err(fail)?;
            let gravity = model.info.gravity.map_or(0.0, |position| values[position]);
            model.equations(&values).map_err(fail)?.eigenvalues(speed, gravity)
        };
        let place = |&CriticalValue { kind, value, error, eigenvalue, change }: &CriticalValue| CriticalSpeed {
            kind,
            speed: value - low,
            error,
            eigenvalue,
            change,
        };
        let critical: Vec<CriticalSpeed> = stability.critical_values.iter().map(place).collect();
        let leans = leans_and_steers(model.info);
        let branches = Branches::follow(eigenvalues, &critical, [0.0, high - low], leans).map_err(|error| {
            let message = told.get().cloned().unwrap_or_else(|| error.to_string());
            Failure::Run(format!("{} along {}: {message}", design.title(), parameter.name))
        })?;
        let mut traced = Self { analysis, branches, ends: [Vec::new(), Vec::new()] };
        traced.ends = [low, *high].map(|end| {
            let values = traced.branches.at(end - low).unwrap_or_default();
            named(&values, &traced.modes(end))
        });
        Ok(traced)
    }

    /// The values at which eigenvalues meet, ascending.
    pub fn meetings(&self) -> impl Iterator<Item = f64> {
        self.branches.meetings().iter().map(|meeting| self.analysis.range[0] + meeting.speed)
    }

    /// The eigenvalues at each of the values, in the order of the branches.
    ///
    /// # Errors
    /// If they cannot be computed at one of them.
    pub fn rows(&self, values: &[f64]) -> Result<Vec<Row<Eigenvalues>>, Failure> {
        let bicycle = self.analysis.speed.is_some() && is_bicycle(self.analysis.design.info());
        let row = |&value: &f64| {
            let fail = |error: SystemError| self.analysis.failed(value, &error.to_string());
            let mut found = self.branches.at((value - self.analysis.range[0]).max(0.0)).map_err(fail)?;
            // Of a bicycle every mode has a name at every value.
            let modes = if bicycle { named(&found, &self.modes(value)) } else { Vec::new() };
            for (branch, found) in found.iter_mut().enumerate() {
                let name = modes.get(branch).copied().or_else(|| self.name(branch, value));
                if matches!(found.mode, Mode::Real | Mode::Oscillatory) || !modes.is_empty() {
                    found.mode = name.unwrap_or(found.mode);
                }
            }
            let verdict = self.analysis.stability.verdict(value).unwrap_or(Verdict::Marginal);
            Ok(Row { speed: value, values: Eigenvalues { values: found, verdict } })
        };
        values.iter().map(row).collect()
    }

    /// The name that a branch has at the end with fewer meetings on the way, if it has one.
    fn name(&self, branch: usize, value: f64) -> Option<Mode> {
        let place = value - self.analysis.range[0];
        let met = self.branches.meetings().iter().filter(|meeting| meeting.branches.contains(&branch));
        let (below, above): (Vec<_>, Vec<_>) = met.partition(|meeting| meeting.speed <= place);
        let [low, high] = self
            .ends
            .each_ref()
            .map(|end| end.get(branch).copied().filter(|mode| !matches!(mode, Mode::Real | Mode::Oscillatory)));
        if below.len() <= above.len() { low.or(high) } else { high.or(low) }
    }

    /// The eigenvalues at a value with the names that they have along the speed; none where there are no names.
    fn modes(&self, value: f64) -> Vec<ModeValue> {
        let AlongAnalysis { design, speed, path, .. } = self.analysis;
        let Ok(values) = path.at(value) else { return Vec::new() };
        let gravity = design.info().gravity.map_or(0.0, |position| values[position]);
        let Some((speed, equations)) = speed.zip(design.model.equations(&values).ok()) else { return Vec::new() };
        let followed = equations.stability(gravity).and_then(|stability| {
            let to = reach(&stability, leans_and_steers(design.info())).max(speed);
            Followed::new(design.model, &*equations, gravity, &stability, to)
        });
        followed.and_then(|followed| followed.at(speed)).unwrap_or_default()
    }
}

/// The modes of some eigenvalues by others that are the same, in any order.
fn named(values: &[ModeValue], modes: &[ModeValue]) -> Vec<Mode> {
    if values.len() != modes.len() {
        return Vec::new();
    }
    let mut left: Vec<ModeValue> = modes.to_vec();
    let mut nearest = |value: Complex<f64>| {
        let distance = |place: &usize| (left[*place].value - value).norm();
        let place = (0..left.len()).min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
        Some(left.swap_remove(place).mode)
    };
    values.iter().filter_map(|value| nearest(value.value)).collect()
}

#[cfg(test)]
mod tests {
    use carvallo::Mode;
    use carvallo_design::input::{self, Request};

    use super::Traced;
    use crate::analysis::along::AlongAnalysis;

    fn along(model: &str, along: &str, speed: f64) -> AlongAnalysis {
        let request = Request { model: Some(model.to_owned()), ..Request::default() };
        AlongAnalysis::new(input::load(&request).unwrap(), &along.parse().unwrap(), Some(speed)).unwrap()
    }

    /// The benchmark, in which mB is 85 kg, has these eigenvalues at 5 m/s (Meijaard et al. 2007, Table 2).
    #[test]
    fn modes_of_a_bicycle_have_their_names() {
        let analysis = along("Whipple", "mB=60:120", 5.0);
        let traced = Traced::new(&analysis).unwrap();
        let rows = traced.rows(&[60.0, 85.0, 120.0]).unwrap();
        let published = [
            (Mode::Castering, -14.078_389_692_798_22, 0.0),
            (Mode::Capsize, -0.322_866_429_004_087, 0.0),
            (Mode::Weave, -0.775_341_882_195_845, 4.464_867_713_788_23),
            (Mode::Weave, -0.775_341_882_195_845, -4.464_867_713_788_23),
        ];
        for (mode, re, im) in published {
            let is_it = |value: &&carvallo::ModeValue| (value.value.re - re).hypot(value.value.im - im) < 1e-12;
            let found = rows[1].values.values.iter().find(is_it);
            assert_eq!(found.map(|found| found.mode), Some(mode), "{re} {im}: {:?}", rows[1].values.values);
        }
        // Each goes on as itself, and nothing meets.
        let modes = |row: usize| rows[row].values.values.iter().map(|value| value.mode).collect::<Vec<_>>();
        assert!(modes(0) == modes(1) && modes(1) == modes(2) && traced.meetings().count() == 0);
    }

    /// A steering damper takes the wobble away (Sharp 1971), which at 20 m/s is there without one; weave and capsize are named by
    /// what they are along the speed.
    #[test]
    fn modes_of_a_motorcycle_are_named_along_the_speed() {
        let analysis = along("Motorcycle", "K=0:30", 20.0);
        let rows = Traced::new(&analysis).unwrap().rows(&[0.0, 15.0, 30.0]).unwrap();
        for row in &rows {
            let count = |mode: Mode| row.values.values.iter().filter(|value| value.mode == mode).count();
            let counts = [Mode::Wobble, Mode::Weave, Mode::Capsize, Mode::Real].map(count);
            assert_eq!(counts, [2, 2, 1, 3], "{}: {:?}", row.speed, row.values.values);
        }
        let wobble =
            |row: usize| rows[row].values.values.iter().find(|value| value.mode == Mode::Wobble).unwrap().value.re;
        assert!(wobble(0) > 0.0 && wobble(1) < 0.0 && wobble(2) < wobble(1));
    }

    /// At 0.6843 m/s two real eigenvalues of the benchmark, whose mB is 85 kg, become the pair weave: at that speed they do so along
    /// the mass at 85 kg.
    #[test]
    fn pairs_form_where_they_do_along_the_speed() {
        let analysis = along("Whipple", "mB=20:200", 0.6843);
        let traced = Traced::new(&analysis).unwrap();
        let meetings: Vec<f64> = traced.meetings().collect();
        let near = |mass: &f64| (*mass - 85.0).abs() < 0.2;
        assert!(meetings.iter().any(near), "{meetings:?}");
    }
}
