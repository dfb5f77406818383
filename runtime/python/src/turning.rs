//! The steady turns of one design.

use carvallo::Complex;
use carvallo::turns::Turn;
use carvallo_design::units::Units;
use carvallo_plot::analysis::simulation::Quantity;
use carvallo_plot::analysis::turns::{Families, Family, end, verdict};
use carvallo_plot::picture::draw_turns;
use pyo3::prelude::*;

use crate::designs::Designs;
use crate::loaded::raise;
use crate::one::About;

/// A curve of turns; lists run over the turns.
#[derive(IntoPyObject)]
pub struct Curve {
    /// The capsize speed at which it begins in m/s, if it begins at one.
    capsize: Option<f64>,
    begin: String,
    end: String,
    /// In m/s.
    speed: Vec<f64>,
    /// In m; none where the machine runs straight.
    radius: Vec<Option<f64>>,
    verdict: Vec<&'static str>,
    /// In 1/s.
    eigenvalues: Vec<Vec<Complex<f64>>>,
    positions: Vec<(&'static str, Vec<f64>)>,
    rates: Vec<(&'static str, Vec<f64>)>,
}

fn told(families: &Families, family: &Family) -> Curve {
    let turns = family.turns.iter();
    // Adding zero turns -0 into 0.
    let named = |told: &[(usize, Quantity)], of: fn(&Turn) -> &[f64]| {
        let values = |place: usize| family.turns.iter().map(|turn| of(turn)[place] + 0.0).collect();
        told.iter().map(|(place, quantity)| (quantity.name, values(*place))).collect()
    };
    Curve {
        capsize: family.capsize,
        begin: end(family.begin),
        end: end(family.end),
        speed: turns.clone().map(|turn| turn.speed).collect(),
        radius: turns.clone().map(|turn| turn.radius.is_finite().then_some(turn.radius)).collect(),
        verdict: turns.clone().map(verdict).collect(),
        eigenvalues: turns.map(|turn| turn.eigenvalues.clone()).collect(),
        positions: named(&families.positions, |turn| &turn.positions),
        rates: named(&families.rates, |turn| &turn.rates),
    }
}

#[pymethods]
impl Designs {
    /// The curves of turns, or of them the turns with the given steers in rad.
    fn turns(&self, py: Python<'_>, about: About, steers: Option<Vec<f64>>) -> PyResult<Vec<Curve>> {
        let described = self.described(py, about)?;
        let find = || {
            let design = described.build()?;
            let families = Families::new(&design, steers.as_deref())?;
            Ok(families.families.iter().map(|family| told(&families, family)).collect())
        };
        py.detach(find).map_err(raise)
    }

    /// The curves of turns, as SVG.
    fn turns_svg(&self, py: Python<'_>, about: About) -> PyResult<String> {
        let described = self.described(py, about)?;
        py.detach(|| Ok(draw_turns(&Families::new(&described.build()?, None)?, &Units::default()).svg())).map_err(raise)
    }
}
