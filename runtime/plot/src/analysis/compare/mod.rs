//! Several designs beside each other: what differs, and which parameters make the difference of the critical speeds.

mod contributions;
mod path;
mod tracks;

use carvallo::{CriticalKind, CriticalSpeed};
use carvallo_design::{Design, Failure};

use self::contributions::integrate;
use self::path::Path;
use self::tracks::{Track, follow};
use crate::analysis::Analysis;

pub use self::tracks::{End, Event};

/// Designs to compare, the first of which the others are held against.
pub struct Comparison {
    /// At least two.
    pub designs: Vec<Compared>,
    /// One for each design but the first.
    pub differences: Vec<Difference>,
}

/// A design with what it is called among the others.
pub struct Compared {
    /// Different from those of the others.
    pub label: String,
    /// Everything about it along the speed.
    pub analysis: Analysis,
}

/// What makes a design differ from the first one.
pub enum Difference {
    /// The parameters with different values, by their positions in the model, and how each critical speed at which stability
    /// changes goes from one design to the other.
    Explained {
        /// Ascending.
        parameters: Vec<usize>,
        /// Weave or flutter speeds first, then capsize or divergence speeds, each ascending.
        ways: Vec<Way>,
    },
    /// There is no way from one to the other, and why.
    Unexplained(String),
}

/// What becomes of a critical speed on the straight path between the parameters of two designs.
pub enum Way {
    /// It goes all the way.
    Whole(Whole),
    /// It is one of the first design, and vanishes on the way.
    Lost {
        /// In the first design.
        from: CriticalSpeed,
        /// Where and how it vanishes.
        event: Event,
    },
    /// It is one of the other design, and appears on the way.
    Found {
        /// In the other design.
        to: CriticalSpeed,
        /// Where and how it appears.
        event: Event,
    },
}

/// A critical speed of both designs.
pub struct Whole {
    /// In the first design.
    pub from: CriticalSpeed,
    /// In the other one.
    pub to: CriticalSpeed,
    /// What each of the parameters that differ makes of the difference, in m/s.
    pub contributions: Vec<f64>,
    /// By how much their sum misses the difference, in m/s: rounding, and what the integration left.
    pub residual: f64,
}

impl Way {
    /// The critical speed that it is about: that of the first design, where it is one of both.
    pub fn critical(&self) -> &CriticalSpeed {
        match self {
            Self::Whole(Whole { from, .. }) | Self::Lost { from, .. } => from,
            Self::Found { to, .. } => to,
        }
    }

    fn whole(&self) -> Option<&Whole> {
        if let Self::Whole(whole) = self { Some(whole) } else { None }
    }
}

impl Difference {
    /// Those that go all the way.
    pub fn whole(&self) -> Vec<&Whole> {
        let Self::Explained { ways, .. } = self else { return Vec::new() };
        ways.iter().filter_map(Way::whole).collect()
    }

    /// The places among the parameters that differ of those that contribute, the largest contribution to any critical speed
    /// first.
    pub fn order(&self) -> Vec<usize> {
        let Self::Explained { parameters, .. } = self else { return Vec::new() };
        let whole = self.whole();
        let largest = |place: usize| whole.iter().map(|whole| whole.contributions[place].abs()).fold(0.0, f64::max);
        let mut order: Vec<usize> = (0..parameters.len()).filter(|&place| largest(place) > 0.0).collect();
        order.sort_by(|&a, &b| largest(b).total_cmp(&largest(a)));
        order
    }
}

impl Comparison {
    /// Compares designs with each other.
    ///
    /// The difference of a critical speed is the integral of its derivatives along the straight path between the parameters of
    /// two designs, `v(B) - v(A) = sum over i of (p_i(B) - p_i(A)) times the integral of dv/dp_i`; each term is what a
    /// parameter contributes. (For a linear dependence these are the effects one by one; where parameters act together, the
    /// path shares out what they do together.)
    ///
    /// # Errors
    /// If there are fewer than two designs.
    pub fn new(designs: Vec<Compared>) -> Result<Self, Failure> {
        let [first, others @ ..] = &designs[..] else {
            return Err(Failure::usage("there is nothing to compare: expected two designs or more"));
        };
        if others.is_empty() {
            return Err(Failure::usage("there is one design to compare: expected two or more"));
        }
        let differences = others.iter().map(|other| difference(&first.analysis, &other.analysis)).collect();
        Ok(Self { designs, differences })
    }

    /// The parameters, by name and unit, that all designs have and that differ, or with `all` every one, in the order of the
    /// models: each with its value in each design that has it.
    pub fn parameters(&self, all: bool) -> Vec<Parameter> {
        let mut parameters: Vec<Parameter> = Vec::new();
        for Compared { analysis, .. } in &self.designs {
            for info in analysis.design.info().parameters {
                if !parameters.iter().any(|known| known.info.name == info.name && known.info.unit == info.unit) {
                    let value = |compared: &Compared| {
                        let design = &compared.analysis.design;
                        let position = design.info().position(info.name)?;
                        let is_same = design.info().parameters[position].unit == info.unit;
                        is_same.then(|| design.parameters[position].value)
                    };
                    let values = self.designs.iter().map(value).collect();
                    let designs = self.designs.iter().map(|compared| &compared.analysis.design);
                    parameters.push(Parameter { info, values, largest: largest(designs, info.unit) });
                }
            }
        }
        parameters.retain(|parameter| all || parameter.is_common() && parameter.differs());
        parameters
    }
}

/// A parameter of several designs.
pub struct Parameter {
    /// What it is.
    pub info: &'static carvallo::ParameterInfo,
    /// Its value in each design that has it.
    pub values: Vec<Option<f64>>,
    /// The largest of all designs in its unit.
    largest: f64,
}

/// Values that differ by such a share of them, or such a part of the largest in their unit, differ by rounding, as that of a
/// parameter which was converted there and back.
const ROUNDING: [f64; 2] = [1e-12, 1e-14];

/// Whether two values differ by no more than rounding.
pub fn is_rounding(one: f64, other: f64, largest: f64) -> bool {
    (one - other).abs() <= ROUNDING[0] * one.abs().max(other.abs()) + ROUNDING[1] * largest
}

/// The largest value in a unit.
pub fn largest<'a>(designs: impl IntoIterator<Item = &'a Design>, unit: &str) -> f64 {
    let of = |design: &Design| {
        let all = design.info().parameters.iter().zip(&design.parameters);
        all.filter(|(info, _)| info.unit == unit).fold(0.0, |most: f64, (_, given)| most.max(given.value.abs()))
    };
    designs.into_iter().map(of).fold(0.0, f64::max)
}

impl Parameter {
    /// Whether all designs have it.
    pub fn is_common(&self) -> bool {
        self.values.iter().all(Option::is_some)
    }

    /// Whether it has not the same value in all designs.
    pub fn differs(&self) -> bool {
        let differs = |value: &Option<f64>| match (*value, self.values[0]) {
            (Some(value), Some(first)) => !is_rounding(value, first, self.largest),
            (value, first) => value != first,
        };
        self.values.iter().any(differs)
    }
}

fn difference(first: &Analysis, other: &Analysis) -> Difference {
    match explain(first, other) {
        Ok((parameters, ways)) => Difference::Explained { parameters, ways },
        Err(reason) => Difference::Unexplained(reason),
    }
}

fn explain(first: &Analysis, other: &Analysis) -> Result<(Vec<usize>, Vec<Way>), String> {
    let path = Path::new(&first.design, &other.design)?;
    if path.parameters.is_empty() {
        return Ok((Vec::new(), Vec::new()));
    }
    let mut tracks = follow(&path)?;
    tracks.retain(|track| track.begin.is_none() || track.end.is_none());
    let (whole, parts): (Vec<Track>, Vec<Track>) =
        tracks.into_iter().partition(|track| track.begin.is_none() && track.end.is_none());
    let integrals = integrate(&path, &whole)?;
    let mut ways: Vec<Way> = Vec::new();
    for (track, contributions) in whole.iter().zip(integrals) {
        let (from, to) = (track.first().critical, track.last().critical);
        let residual = contributions.iter().sum::<f64>() - (to.speed - from.speed);
        ways.push(Way::Whole(Whole { from, to, contributions, residual }));
    }
    ways.extend(parts.into_iter().filter_map(|track| match (track.begin, track.end) {
        (None, Some(event)) => Some(Way::Lost { from: track.first().critical, event }),
        (Some(event), None) => Some(Way::Found { to: track.last().critical, event }),
        _ => None,
    }));
    let rank = |way: &Way| match way.critical().kind {
        CriticalKind::Weave => 0,
        CriticalKind::Capsize => 1,
        CriticalKind::DoubleRoot => 2,
    };
    ways.sort_by(|a, b| rank(a).cmp(&rank(b)).then(a.critical().speed.total_cmp(&b.critical().speed)));
    Ok((path.parameters, ways))
}
