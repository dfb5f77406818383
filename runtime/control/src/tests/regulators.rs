//! Regulators, against gains that `regulators.py` finds with SciPy, and against closed forms.

use carvallo_design::{Design, Failure, input};
use nalgebra::DMatrix;

use super::{benchmark, design};
use crate::{Ports, Regulator, Riccati, Schedule, Weights};

/// SciPy itself errs in the last digits.
const BOUND: f64 = 1e-9;

fn regulator(design: &Design, speed: f64, inputs: &[&str], weights: &[&str]) -> Result<Regulator, Failure> {
    Regulator::new(design, speed, &read(design, inputs, weights)?)
}

pub fn read(design: &Design, inputs: &[&str], weights: &[&str]) -> Result<Weights, Failure> {
    let ports = Ports::of(design);
    let inputs: Vec<usize> = inputs.iter().map(|name| ports.input(name).expect("an input")).collect();
    let weights: Vec<String> = weights.iter().map(|weight| (*weight).to_owned()).collect();
    Weights::read(&weights, &ports, &inputs)
}

fn matrices(text: &str) -> Design {
    input::read("matrices.json", text.as_bytes().to_vec()).expect("matrices")
}

#[test]
fn gains_are_those_of_scipy() {
    let lines = include_str!("regulators.tsv").lines().filter(|line| !line.starts_with('#'));
    assert_eq!(lines.clone().count(), 15);
    for line in lines {
        let [model, set, speed, inputs, weights, gains, growth] = line.split('\t').collect::<Vec<_>>()[..] else {
            panic!("seven columns: {line}");
        };
        let design = design(model, set);
        let inputs: Vec<&str> = inputs.split(',').collect();
        let weights: Vec<&str> = weights.split(',').filter(|weight| !weight.is_empty()).collect();
        let found = regulator(&design, speed.parse().expect("a speed"), &inputs, &weights).expect("a regulator");
        let expected: Vec<f64> = gains.split(',').map(|gain| gain.parse().expect("a gain")).collect();
        let expected = DMatrix::from_row_slice(inputs.len(), expected.len() / inputs.len(), &expected);
        let error = (&found.gains - &expected).norm() / expected.norm();
        assert!(error < BOUND, "{line}: {error:e}, {}", found.gains);
        let growth: f64 = growth.parse().expect("a number");
        let last = found.eigenvalues.last().expect("eigenvalues").re;
        assert!((last - growth).abs() < 1e-8 * found.eigenvalues[0].norm(), "{line}: {last}");
        assert!(found.residual < 1e-13, "{line}: {:e}", found.residual);
    }
}

/// `x'' = u` with all weights 1: the gains are 1 and sqrt(3) (Anderson & Moore 1990, section 3.2).
#[test]
fn a_double_integrator_has_a_closed_form() {
    let of = |rows: [f64; 4]| DMatrix::from_row_slice(2, 2, &rows);
    let [a, g, q] = [[0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0]].map(of);
    let Riccati { solution, residual } = Riccati::new(&a, &g, &q).expect("a solution");
    let root = f64::sqrt(3.0);
    assert!((solution - of([root, 1.0, 1.0, root])).norm() < 1e-14);
    assert!(residual < 1e-15, "{residual:e}");
}

/// `x'' = k x + u` of any size and in any units: `K = k + sqrt(k^2 + q)` with the weight q on x alone.
#[test]
fn sizes_do_not_matter() {
    for (k, mass, q) in
        [(1e-6, 1.0_f64, 1e-9), (1e6_f64, 1.0, 1.0), (1.0, 1e-9, 1.0), (1.0, 1e9, 1e-3), (9.81, 85.0, 1e12)]
    {
        let pendulum = matrices(&format!(r#"{{"M": [[{mass:?}]], "Kc": [[{:?}]]}}"#, -k * mass));
        let weights = [format!("q1={q:?}"), format!("Fq1={:?}", mass.powi(-2))];
        let found = regulator(&pendulum, 0.0, &["q1"], &weights.each_ref().map(String::as_str)).expect("a regulator");
        let gain = k + f64::sqrt(k * k + q);
        let expected = [gain * mass, f64::sqrt(2.0 * gain) * mass];
        for (found, expected) in found.gains.iter().zip(expected) {
            assert!((found - expected).abs() < 1e-11 * expected, "{k} {mass} {q}: {found}, expected {expected}");
        }
    }
}

#[test]
fn what_cannot_be_stabilized_is_refused() {
    // Two inverted pendulums, of which one is driven.
    let two = matrices(r#"{"M": [[1, 0], [0, 1]], "Kc": [[-1, 0], [0, -4]]}"#);
    let refused = regulator(&two, 0.0, &["q1"], &[]).unwrap_err().to_string();
    let expected = "Matrices matrices.json: Fq1 does not reach the mode with the eigenvalue 2.0000/s, which does not die away by \
                    itself: no gains stabilize it";
    assert_eq!(refused, expected);
    // One that stands and one that hangs.
    let seen = matrices(r#"{"M": [[1, 0], [0, 1]], "Kc": [[-1, 0], [0, 4]]}"#);
    let refused = regulator(&seen, 0.0, &["q1", "q2"], &["q1=1"]).unwrap_err().to_string();
    let expected = "Matrices matrices.json: no weight sees the mode with the eigenvalue (0.0000 ± 2.0000 i)/s, which neither grows \
                    nor dies away: a weight on one of its coordinates is needed";
    assert_eq!(refused, expected);
    assert!(regulator(&seen, 0.0, &["q1", "q2"], &["q1=1", "q2_rate=1"]).is_ok());
    // Of a bicycle, at the one speed at which no torque on the steer catches a fall.
    let bicycle = benchmark();
    let first = |speed: f64| regulator(&bicycle, speed, &["Tdelta"], &[]).map(|found| found.gains[0]);
    let (mut low, mut high) = (0.01, 0.1);
    assert!(first(low).expect("gains") > 0.0 && first(high).expect("gains") < 0.0);
    let refused = loop {
        let middle = 0.5 * (low + high);
        match first(middle) {
            Ok(gain) if gain > 0.0 => low = middle,
            Ok(_) => high = middle,
            Err(failure) => break failure.to_string(),
        }
        assert!(high - low > 1e-15, "from {low} to {high}");
    };
    assert!(refused.contains("Tdelta hardly reaches the mode with the eigenvalue 3."), "{refused}");
}

#[test]
fn weights_are_read_with_all_mistakes() {
    let bicycle = benchmark();
    let texts = [
        "phi",
        "ph=1",
        "phi=-1",
        "lean=1",
        "phi=2",
        "Tphi=1",
        "Tdelta=0",
        "delta=x",
        "phi''=1",
        "delta=10 deg",
        "Tdelta=2 lb*ft",
    ];
    let found = read(&bicycle, &["Tdelta"], &texts).unwrap_err().to_string();
    let names = "phi, delta, psi, y, phi_rate, delta_rate, psi_rate, y_rate, phi_acceleration, delta_acceleration, \
                 psi_acceleration, y_acceleration";
    let no_unit = "must have no unit behind it: a weight is in the inverse square of the unit";
    let expected = [
        "10 problems".to_owned(),
        "--weight phi: expected NAME=VALUE, such as phi=10 or Tdelta=0.1".to_owned(),
        format!("--weight ph=1: `ph` is no output of Whipple; did you mean `phi`?\nthey are {names}"),
        "--weight phi=-1: the weight of an output is -1; it must be >= 0".to_owned(),
        "--weight phi=2: `phi` has a weight already".to_owned(),
        "--weight Tphi=1: `Tphi` is not among the inputs".to_owned(),
        "--weight Tdelta=0: the weight of an input is 0; it must be > 0".to_owned(),
        "--weight delta=x: `x` must be a finite number".to_owned(),
        "--weight phi''=1: `phi_acceleration` follows the inputs at once; expected a position or a rate".to_owned(),
        format!("--weight delta=10 deg: `10 deg` {no_unit} of `delta` in the SI"),
        format!("--weight Tdelta=2 lb*ft: `2 lb*ft` {no_unit} of `Tdelta` in the SI"),
    ];
    assert_eq!(found, expected.join("\n"));
}

#[test]
fn a_schedule_is_of_regulators_and_tells_where_it_fails_between_them() {
    let bicycle = benchmark();
    let weights = read(&bicycle, &["Tdelta"], &[]).expect("weights");
    let schedule = Schedule::new(&bicycle, &[4.0, 1.0, 2.0, 2.0], &weights).expect("a schedule");
    let speeds: Vec<Option<f64>> = schedule.regulators.iter().map(|regulator| regulator.space.speed).collect();
    assert_eq!(speeds, [Some(1.0), Some(2.0), Some(4.0)]);
    assert_eq!(schedule.regulators[1], Regulator::new(&bicycle, 2.0, &weights).expect("a regulator"));
    assert!(schedule.unstable.is_empty());
    // At some speed between them the torque reaches no unstable mode, and behind it has the opposite sign.
    let across = Schedule::new(&bicycle, &[0.0, 0.5, 1.0], &weights).expect("a schedule");
    assert_eq!(across.unstable, [[0.0, 0.5]]);
}
