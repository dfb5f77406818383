//! The tables of recomputed facts in `data/`; the head of each says how it was found.

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

/// Stable ranges of all bicycles.
pub fn stable_ranges() -> Vec<StableRange> {
    let row = |[bicycle, from, to]: [&'static str; 3]| StableRange {
        bicycle,
        from: number(from),
        to: (to != "-").then(|| number(to)),
    };
    rows(include_str!("../data/stable_ranges.tsv")).map(row).collect()
}

fn rows<const N: usize>(table: &'static str) -> impl Iterator<Item = [&'static str; N]> {
    let lines = table.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| line.split('\t').collect::<Vec<_>>().try_into().expect("every column"))
}

fn number(text: &str) -> f64 {
    text.parse().expect("a decimal")
}
