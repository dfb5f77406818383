//! The tables of recomputed facts in `data/`; the head of each says how it was found.

use carvallo::{Coefficients, States};

/// One eigenvalue of a published benchmark.
#[derive(Clone, Copy, Debug)]
pub struct Eigenvalue {
    /// The bicycle's name.
    pub bicycle: &'static str,
    /// Speed in m/s.
    pub speed: f64,
    /// Real and imaginary part in 1/s.
    pub value: nalgebra::Complex<f64>,
}

/// One critical speed of a bicycle.
#[derive(Clone, Copy, Debug)]
pub struct CriticalSpeed {
    /// The bicycle's name.
    pub bicycle: &'static str,
    /// `weave`, `capsize` or `double_root`.
    pub kind: &'static str,
    /// `stabilizes` or `destabilizes`; `merges` or `splits` at a double root.
    pub change: &'static str,
    /// Speed in m/s.
    pub speed: f64,
    /// The eigenvalue that is critical there, in 1/s.
    pub eigenvalue: nalgebra::Complex<f64>,
}

/// A critical speed of a model that ships.
#[derive(Clone, Copy, Debug)]
pub struct ModelSpeed {
    /// The model's name.
    pub model: &'static str,
    /// The name of its parameter set, as it is declared.
    pub set: &'static str,
    /// `weave`, `capsize` or `double_root`.
    pub kind: &'static str,
    /// The speed in m/s, with the digits that are to be trusted.
    pub digits: &'static str,
    /// `printed`, `closed form` or `recomputed`.
    pub known: &'static str,
    /// Who printed it or whose equations they are; empty where they are the model's own.
    pub source: &'static str,
}

impl ModelSpeed {
    /// The speed in m/s.
    pub fn speed(&self) -> f64 {
        number(self.digits)
    }

    /// Half a unit of the last digit, in m/s.
    pub fn half_a_unit(&self) -> f64 {
        let decimals = self.digits.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        0.5 * 10_f64.powi(-(decimals as i32))
    }

    /// The one of a model's critical speeds that this is: of its kind the nearest.
    pub fn find(&self, critical_speeds: &[carvallo::CriticalSpeed]) -> Option<carvallo::CriticalSpeed> {
        let distance = |critical: &carvallo::CriticalSpeed| (critical.speed - self.speed()).abs();
        let all = critical_speeds.iter().filter(|critical| kind_of(critical) == self.kind);
        all.min_by(|a, b| distance(a).total_cmp(&distance(b))).copied()
    }
}

fn kind_of(critical: &carvallo::CriticalSpeed) -> &'static str {
    match critical.kind {
        carvallo::CriticalKind::Weave => "weave",
        carvallo::CriticalKind::Capsize => "capsize",
        carvallo::CriticalKind::DoubleRoot => "double_root",
    }
}

/// A range of speeds in which a bicycle is stable by itself.
#[derive(Clone, Copy, Debug)]
pub struct StableRange {
    /// The bicycle's name.
    pub bicycle: &'static str,
    /// Lower end in m/s.
    pub from: f64,
    /// Upper end in m/s, if there is one.
    pub to: Option<f64>,
}

/// Equations of motion made of random integers.
#[derive(Clone, Debug)]
pub struct RandomSystem {
    /// The family, the number of coordinates, and a number.
    pub name: &'static str,
    /// The number of coordinates.
    pub coordinates: usize,
    /// Of each coordinate `both`, `position` or `rate`.
    pub states: Vec<&'static str>,
    /// M, C-1, C0, C1, Kc, K0, K1 and K2, row by row; nothing for a matrix that is zero.
    pub matrices: [Vec<f64>; 8],
    /// All of its critical speeds, ascending.
    pub critical_speeds: Vec<RandomSystemSpeed>,
}

/// One critical speed of random equations of motion.
#[derive(Clone, Copy, Debug)]
pub struct RandomSystemSpeed {
    /// `weave`, `capsize` or `double_root`.
    pub kind: &'static str,
    /// Speed in m/s.
    pub speed: f64,
    /// Frequency in 1/s.
    pub frequency: f64,
    /// `up` or `down`, or `-` where the real part has no finite derivative.
    pub way: &'static str,
}

impl RandomSystem {
    /// The gravitational field strength in N/kg.
    pub const GRAVITY: f64 = 2.0;

    /// The matrices.
    ///
    /// # Panics
    /// If there is another number of coordinates.
    pub fn coefficients<const N: usize>(&self) -> Coefficients<f64, N> {
        assert_eq!(self.coordinates, N, "the number of coordinates");
        let entry = |matrix: usize, i: usize, j: usize| self.matrices[matrix].get(N * i + j).copied().unwrap_or(0.0);
        let rows = std::array::from_fn(|matrix| std::array::from_fn(|i| std::array::from_fn(|j| entry(matrix, i, j))));
        let states = std::array::from_fn(|coordinate| match self.states[coordinate] {
            "position" => States::Position,
            "rate" => States::Rate,
            _ => States::Both,
        });
        Coefficients { states, ..Coefficients::from_rows(rows) }
    }
}

/// The random equations of motion with their critical speeds.
pub fn random_systems() -> Vec<RandomSystem> {
    let mut speeds: std::collections::HashMap<_, Vec<_>> = std::collections::HashMap::new();
    for [name, kind, speed, frequency, way] in rows(include_str!("../data/random_systems_speeds.tsv")) {
        let speed = RandomSystemSpeed { kind, speed: number(speed), frequency: number(frequency), way };
        speeds.entry(name).or_default().push(speed);
    }
    let row = |columns: [&'static str; 11]| {
        let [name, coordinates, states, matrices @ ..] = columns;
        RandomSystem {
            name,
            coordinates: coordinates.parse().expect("a number of coordinates"),
            states: states.split(' ').collect(),
            matrices: matrices.map(|entries| entries.split_whitespace().map(number).collect()),
            critical_speeds: speeds.remove(name).unwrap_or_default(),
        }
    };
    let systems = rows(include_str!("../data/random_systems.tsv")).map(row).collect();
    assert!(speeds.is_empty(), "speeds of systems that there are not: {speeds:?}");
    systems
}

/// The derivatives of the critical speeds of the random equations of motion, and of the frequencies there, by system in the
/// order of its speeds.
pub fn random_derivatives() -> std::collections::HashMap<&'static str, Vec<[f64; 2]>> {
    let mut derivatives: std::collections::HashMap<_, Vec<_>> = std::collections::HashMap::new();
    for [name, _, speed, frequency] in rows(include_str!("../data/random_systems_derivatives.tsv")) {
        derivatives.entry(name).or_default().push([speed, frequency].map(number));
    }
    derivatives
}

/// Eigenvalues of the two benchmarks, ordered by real, then imaginary part.
pub fn eigenvalues() -> Vec<Eigenvalue> {
    let row = |[bicycle, speed, re, im]: [&'static str; 4]| Eigenvalue {
        bicycle,
        speed: number(speed),
        value: nalgebra::Complex::new(number(re), number(im)),
    };
    rows(include_str!("../data/eigenvalues.tsv")).map(row).collect()
}

/// Critical speeds of all bicycles, in the order of the speed.
pub fn critical_speeds() -> Vec<CriticalSpeed> {
    let row = |[bicycle, kind, change, speed, re, im]: [&'static str; 6]| CriticalSpeed {
        bicycle,
        kind,
        change,
        speed: number(speed),
        eigenvalue: nalgebra::Complex::new(number(re), number(im)),
    };
    rows(include_str!("../data/critical_speeds.tsv")).map(row).collect()
}

/// Critical speeds of the models that ship.
pub fn model_speeds() -> Vec<ModelSpeed> {
    let row = |[model, set, kind, digits, known, source]: [&'static str; 6]| ModelSpeed {
        model,
        set,
        kind,
        digits,
        known,
        source,
    };
    rows(include_str!("../data/published_speeds.tsv")).map(row).collect()
}

/// Stable ranges of all bicycles.
pub fn stable_ranges() -> Vec<StableRange> {
    let row = |[bicycle, from, to]: [&'static str; 3]| StableRange {
        bicycle,
        from: number(from),
        to: (to != "-").then(|| number(to)),
    };
    rows(include_str!("../data/stable_ranges.tsv")).map(row).collect()
}

/// A system whose eigenvalues spread over many orders of magnitude.
#[derive(Clone, Debug)]
pub struct SpreadEigenvalues {
    /// The number of coordinates.
    pub coordinates: usize,
    /// Sizes are from `10^-reach` to `10^reach`.
    pub reach: usize,
    /// M, C and K, each row by row.
    pub entries: Vec<f64>,
    /// In 1/s, in no order.
    pub values: Vec<nalgebra::Complex<f64>>,
}

/// Systems of three and four coordinates with their eigenvalues.
pub fn spread_eigenvalues() -> Vec<SpreadEigenvalues> {
    let row = |[coordinates, reach, entries, values]: [&'static str; 4]| {
        let value = |text: &str| {
            let (re, im) = text.split_once(',').expect("two parts");
            nalgebra::Complex::new(number(re), number(im))
        };
        SpreadEigenvalues {
            coordinates: coordinates.parse().expect("a number of coordinates"),
            reach: reach.parse().expect("a number of digits"),
            entries: entries.split(' ').map(number).collect(),
            values: values.split(' ').map(value).collect(),
        }
    };
    rows(include_str!("../data/spread_eigenvalues.tsv")).map(row).collect()
}

fn rows<const N: usize>(table: &'static str) -> impl Iterator<Item = [&'static str; N]> {
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| line.split('\t').collect::<Vec<_>>().try_into().expect("every column"))
}

fn number(text: &str) -> f64 {
    text.parse().expect("a decimal")
}
