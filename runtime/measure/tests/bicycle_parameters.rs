//! Measured bicycles, against what BicycleParameters makes of the same measurements: `reference.py` wrote `data/*.tsv`.

use std::path::Path;

use carvallo_design::Design;

/// Of a parameter: its value, its standard deviation, and its correlations with those before it.
struct Reference {
    name: String,
    value: f64,
    deviation: f64,
    correlations: Vec<f64>,
}

fn data(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    std::fs::read_to_string(path).unwrap()
}

fn reference(bicycle: &str) -> Vec<Reference> {
    let line = |line: &str| {
        let mut cells = line.split('\t');
        let name = cells.next().unwrap().to_owned();
        let mut numbers = cells.map(|cell| cell.parse().unwrap());
        let [value, deviation] = [numbers.next().unwrap(), numbers.next().unwrap()];
        Reference { name, value, deviation, correlations: numbers.collect() }
    };
    data(&format!("{bicycle}.tsv")).lines().map(line).collect()
}

fn measured(bicycle: &str) -> Design {
    let label = format!("{bicycle}Measured.txt");
    let contents = data(&label).into_bytes();
    carvallo_measure::read(&label, contents).unwrap()
}

/// How far apart values, deviations and correlations are at most, relative to them; correlations as they are.
#[derive(Debug)]
struct Difference {
    value: f64,
    deviation: f64,
    correlation: f64,
}

fn difference(bicycle: &str) -> Difference {
    let (design, reference) = (measured(bicycle), reference(bicycle));
    assert_eq!(design.name, bicycle);
    let covariance = design.covariance.as_ref().unwrap();
    let mut largest = Difference { value: 0.0, deviation: 0.0, correlation: 0.0 };
    assert_eq!(reference.len(), design.parameters.len());
    for (index, (expected, given)) in reference.iter().zip(&design.parameters).enumerate() {
        assert_eq!(expected.name, design.info().parameters[index].name);
        largest.value = largest.value.max((given.value / expected.value - 1.0).abs());
        let deviation = given.deviation.as_ref().map_or(0.0, |deviation| deviation.value);
        assert_eq!(deviation == 0.0, expected.deviation == 0.0, "{bicycle}: {}", expected.name);
        if deviation > 0.0 {
            largest.deviation = largest.deviation.max((deviation / expected.deviation - 1.0).abs());
        }
        assert_eq!(expected.correlations.len(), index);
        for (other, correlation) in expected.correlations.iter().enumerate() {
            largest.correlation = largest.correlation.max((covariance.correlation(index, other) - correlation).abs());
        }
    }
    largest
}

/// With three orientations of each frame all is differentiated exactly on both sides.
#[test]
fn measured_bicycles_are_those_of_bicycle_parameters() {
    for bicycle in ["Browser", "Pista", "Balanceassistv1"] {
        let found = difference(bicycle);
        assert!(found.value < 1e-12 && found.deviation < 1e-11 && found.correlation < 1e-11, "{bicycle}: {found:?}");
    }
}

/// With more, `uncertainties` differentiates the pseudoinverse numerically.
#[test]
fn more_orientations_go_by_least_squares() {
    for bicycle in ["Rigid", "Gyro"] {
        let found = difference(bicycle);
        assert!(found.value < 1e-12 && found.deviation < 1e-6 && found.correlation < 1e-6, "{bicycle}: {found:?}");
    }
}

/// Moore's results of 2012 for the Browser, which ship, from the same periods: w, c, lam and so on.
#[test]
fn what_was_published_comes_out() {
    let design = measured("Browser");
    let shipped = carvallo_design::input::load(&carvallo_design::input::Request {
        parameters: Some("browser".to_owned()),
        ..Default::default()
    });
    for (given, published) in design.parameters.iter().zip(shipped.unwrap().parameters) {
        // They are printed with 12 digits.
        assert!((given.value / published.value - 1.0).abs() < 2e-11, "{given:?}, not {published:?}");
        let [found, published] = [given, &published].map(|given| given.deviation.as_ref().unwrap().value);
        assert!((found / published - 1.0).abs() < 2e-11, "{found}, not {published}");
    }
}

/// What is common to parameters reaches the matrices: those of a bicycle with its parameters taken to be independent differ by up
/// to half of the deviation.
#[test]
fn deviations_of_matrices_take_account_of_correlations() {
    for bicycle in ["Browser", "Pista", "Balanceassistv1"] {
        let design = measured(bicycle);
        let sensitivity = design.model.sensitivity(&design.values()).unwrap();
        let deviations = sensitivity.correlated_matrix_deviations(design.covariance.as_ref().unwrap()).unwrap();
        let (values, deviations) = (design.equations.matrices(), deviations.matrices());
        for (index, line) in data(&format!("{bicycle}Matrices.tsv")).lines().enumerate() {
            let [name, value, deviation] = line.split('\t').collect::<Vec<_>>()[..] else { panic!("{line}") };
            let entry = |matrices: &[(carvallo::MatrixName, Vec<Vec<f64>>)]| {
                let (_, rows) = matrices.iter().find(|(matrix, _)| matrix.name() == name).unwrap();
                rows[index % 4 / 2][index % 2]
            };
            for (found, expected) in [(entry(&values), value), (entry(&deviations), deviation)] {
                let expected: f64 = expected.parse().unwrap();
                assert!((found - expected).abs() <= 1e-11 * expected.abs(), "{bicycle}, {line}: {found}");
            }
        }
    }
}
