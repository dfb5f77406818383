//! Critical speeds of the models that ship, beside all that is printed, known in closed form or recomputed of them, and the time
//! that all critical speeds of a parameter set take.
//!
//! ```text
//! cargo run --profile bench -p carvallo-tools --no-default-features --bin published
//! ```
//!
//! The facts are those of `tests/data/published_speeds.tsv`, which the tests assert. Times are the shortest of several rounds,
//! on one core.

use std::hint::black_box;
use std::time::{Duration, Instant};

use carvallo::{Coefficients, Model, Stability, Verdict};
use carvallo_models::{Motorcycle, TowedWheel, each_model};
use carvallo_tests::facts::model_speeds;
use carvallo_tests::published::{EIGENVALUES_1971, FOOT, units_off};

fn main() {
    let header = ["critical speed", "known", "m/s", "ours", "difference", "all, µs", "source"];
    print(header);
    let empty: Vec<&str> = each_model!(compare).into_iter().flatten().collect();
    for (known, ours) in ["0.3", "0.7"].into_iter().zip(towed_wheel_limits()) {
        let difference = ours - known.parse::<f64>().unwrap_or(f64::NAN);
        let [ours, difference] = [format!("{ours:?}"), format!("{difference:.1e}")];
        print(["TowedWheel, a/l", "printed", known, &ours, &difference, "", "Schwab & Meijaard (2003)"]);
    }
    println!("\nWithout a critical speed: {}.", empty.join(", "));
    println!(
        "Of the 24 eigenvalues that Sharp (1971) prints, the farthest is {:.2} units of its last digit off.",
        sharp_off()
    );
}

fn print([speed, known, published, ours, difference, time, source]: [&str; 7]) {
    println!("{speed:<42} {known:<11} {published:<21} {ours:<20} {difference:>10} {time:>8}  {source}");
}

/// Prints the rows of a model; its name if it has none.
fn compare<const N: usize, M: Model<N, Scalar = f64>>() -> Option<&'static str> {
    let facts = model_speeds();
    let mut is_empty = true;
    for set in M::INFO.sets {
        let model = M::from_slice(set.values).expect("a value for each parameter");
        let (coefficients, gravity) = (model.coefficients(), model.gravity().unwrap_or(0.0));
        let stability = Stability::new(&coefficients, gravity).expect("an answer");
        let mut time = format!("{:.1}", measure(&coefficients, gravity).as_secs_f64() * 1e6);
        for fact in facts.iter().filter(|fact| fact.model == M::INFO.name && fact.set == set.name) {
            is_empty = false;
            let ours = fact.find(&stability.critical_speeds).expect("one of its kind").speed;
            let label = format!("{}, {}, {}", fact.model, fact.set, fact.kind);
            let [speed, difference] = [format!("{ours:?}"), format!("{:.1e}", ours - fact.speed())];
            print([&label, fact.known, fact.digits, &speed, &difference, &std::mem::take(&mut time), fact.source]);
        }
    }
    is_empty.then_some(M::INFO.name)
}

/// How long all critical speeds of a design take.
fn measure<const N: usize>(coefficients: &Coefficients<f64, N>, gravity: f64) -> Duration {
    const ROUNDS: usize = 5;
    const ROUND: Duration = Duration::from_millis(20);
    let round = |_| {
        let start = Instant::now();
        let mut count = 0;
        while start.elapsed() < ROUND {
            black_box(Stability::new(black_box(coefficients), gravity)).expect("an answer");
            count += 1;
        }
        start.elapsed() / count
    };
    (0..ROUNDS).map(round).min().unwrap_or_default()
}

/// The places of the centre of mass of the towed wheel between which it is stable, in parts of its length: by bisection.
fn towed_wheel_limits() -> [f64; 2] {
    let is_stable = |part: f64| {
        let wheel = TowedWheel { a: part * TowedWheel::EXAMPLE.l, ..TowedWheel::EXAMPLE };
        let stability = Stability::new(&wheel.coefficients(), 0.0).expect("an answer");
        stability.verdict(1.0) == Ok(Verdict::Stable)
    };
    [0.1, 0.9].map(|mut outside| {
        let mut inside = 0.5;
        while f64::abs(inside - outside) > 4.0 * f64::EPSILON {
            let middle = (inside + outside) / 2.0;
            *(if is_stable(middle) { &mut inside } else { &mut outside }) = middle;
        }
        inside
    })
}

/// The largest distance from a printed eigenvalue, in units of its last digit.
fn sharp_off() -> f64 {
    let motorcycle = Motorcycle::STANDARD;
    let off = EIGENVALUES_1971.into_iter().flat_map(|(speed, printed)| {
        let system = motorcycle.coefficients().at(speed * FOOT, motorcycle.g);
        let found = system.and_then(|system| system.eigenvalues()).expect("a regular system");
        printed.map(|printed| units_off(&found, printed))
    });
    off.fold(0.0, f64::max)
}
