//! The formulas that models tell of themselves are what they compute: read back as declarations, they give the matrices.

use carvallo::{FormulaInfo, FormulaSubject, MatrixName, Model, ModelInfo, ParameterInfo, States};
use carvallo_compiler::check;
use carvallo_models::{Whipple, each_model};
use nalgebra::DMatrix;

/// What a model tells, as a declaration of its formulas.
fn declared(info: &ModelInfo) -> String {
    let parameter = |(position, parameter): (usize, &ParameterInfo)| {
        let ParameterInfo { name, unit, .. } = parameter;
        let gravity = if info.gravity == Some(position) { ", gravity" } else { "" };
        // One that only the kinematics depend on is used by the model, and not by these formulas.
        let uses = |text: &str| text.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == *name);
        let unused = if info.formulas.iter().any(|formula| uses(formula.text)) { "" } else { ", unused" };
        format!("{name}: {unit}{gravity}{unused};")
    };
    let parameters: String = info.parameters.iter().enumerate().map(parameter).collect();
    let only = |states: States| match states {
        States::Both => ", both",
        States::Position => ", only position",
        States::Rate => ", only rate",
    };
    let coordinates = info.coordinates.iter().map(|q| format!("{}: {}{};", q.name, q.unit, only(q.states)));
    let coordinates: String = coordinates.collect();
    let mut definitions = String::new();
    let n = info.coordinates.len();
    let mut matrices = vec![vec![vec!["0"; n]; n]; MatrixName::ALL.len()];
    for FormulaInfo { of, text, .. } in info.formulas {
        match of {
            FormulaSubject::Definition(name) | FormulaSubject::Attribute { name, .. } => {
                definitions += &format!("let {name} = {text};")
            }
            FormulaSubject::Entry(entry) => {
                for (matrix, row, column) in entry.places {
                    let entry = &mut matrices[*matrix as usize][*row][*column];
                    assert_eq!(*entry, "0", "{}: two formulas of {matrix}[{row}][{column}]", info.name);
                    *entry = text;
                }
            }
        }
    }
    let matrices = MatrixName::ALL.into_iter().zip(matrices).filter(|(name, _)| info.matrices.contains(name));
    let matrices = matrices.map(|(name, rows)| {
        let rows: Vec<String> = rows.iter().map(|row| format!("[{}]", row.join(", "))).collect();
        format!("{name} = [{}];", rows.join(", "))
    });
    let matrices: String = matrices.collect();
    format!("model Again {{ parameters {{ {parameters} }} {definitions} coordinates {{ {coordinates} }} {matrices} }}")
}

/// The largest distance of an entry from that of the model, in parts of its matrix.
fn compare<const N: usize, M: Model<N, Scalar = f64>>() -> f64 {
    let info = M::INFO;
    assert!(info.formulas.iter().any(|formula| matches!(formula.of, FormulaSubject::Entry(_))), "{}", info.name);
    let declaration = declared(info);
    let again = check(declaration.parse().expect("tokens")).unwrap_or_else(|error| panic!("{error}\n{declaration}"));
    // The units that are told are those that a declaration of the formulas has.
    let units: Vec<&str> = again.formulas.iter().map(|formula| &*formula.unit).collect();
    assert_eq!(info.formulas.iter().map(|formula| formula.unit).collect::<Vec<_>>(), units, "{}", info.name);
    let mut worst = 0.0_f64;
    let factors = [1.0, 1.01, 0.97, 1.03];
    for (set, shift) in info.sets.iter().flat_map(|set| (0..factors.len()).map(move |shift| (set, shift))) {
        let values = set.values.iter().enumerate().map(|(position, value)| match shift {
            0 => *value,
            _ => value * factors[(position + shift) % factors.len()],
        });
        let values: Vec<f64> = values.collect();
        let mut definitions: Vec<f64> = Vec::new();
        for formula in again.formulas_of_definitions() {
            definitions.push(formula.evaluate(&values, &definitions));
        }
        let coefficients = M::from_slice(&values).expect("a value for each parameter").coefficients();
        for name in MatrixName::ALL {
            let rows = again.matrices.iter().find(|(other, _)| other.name() == name.name()).map(|(_, rows)| rows);
            let entry =
                |row: usize, column: usize| rows.map_or(0.0, |rows| rows[row][column].evaluate(&values, &definitions));
            let expected = coefficients.matrix(name);
            let found = DMatrix::from_fn(N, N, entry);
            let scale = expected.amax().max(f64::MIN_POSITIVE);
            worst = found.iter().zip(expected.iter()).fold(worst, |worst, (a, b)| worst.max((a - b).abs() / scale));
        }
    }
    worst
}

#[test]
fn formulas_read_back_give_the_matrices_of_their_model() {
    for worst in each_model!(compare) {
        assert!(worst <= 1e-13, "{worst:e}");
    }
}

/// As Appendix A of the paper has them.
#[test]
fn the_bicycle_tells_its_formulas_as_they_are_declared() {
    let told: Vec<String> = <Whipple as Model<2>>::INFO.formulas.iter().map(ToString::to_string).collect();
    for expected in [
        "ITxz = IBxz + IHxz - mB*xB*zB - mH*xH*zH + mF*w*rF [kg*m^2]",
        "mu = (c/w)*cos(lam) [1]",
        "M_12 = M_21 = IAlx + mu*ITxz [kg*m^2]",
        "K2_22 = ((SA + SF*sin(lam))/w)*cos(lam) [kg]",
    ] {
        assert!(told.iter().any(|line| line == expected), "{expected} is not in {told:#?}");
    }
}
