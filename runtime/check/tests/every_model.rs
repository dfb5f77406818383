//! Slips of parameters, in every model that ships and its first parameter set, from the matrices that were compiled.

use carvallo_check::check_machine;
use carvallo_check::given::{Given, Reading};
use carvallo_check::machine::Machine;
use carvallo_design::{MODELS, Shipped, WHIPPLE};

/// The matrices for parameters, to seven digits; `None` where they may not be.
fn given(model: &Shipped, parameters: &[f64]) -> Option<Given> {
    let equations = model.equations(parameters).ok()?;
    let matrices = equations.matrices().into_iter().filter(|(name, _)| model.info.matrices.contains(name));
    let reading = |value: &f64| Some(Reading::rounded(*value, 7));
    let rows = |rows: Vec<Vec<f64>>| rows.iter().map(|row| row.iter().map(reading).collect()).collect();
    Some(Given { matrices: matrices.map(|(name, own)| (name, rows(own))).collect(), ..Given::default() })
}

#[test]
fn another_value_of_a_parameter_is_found_in_every_model() {
    for model in MODELS {
        let info = model.info;
        let Some(set) = info.sets.first() else { continue };
        let machine = Machine::with(info, set.values).expect("formulas that can be read");
        let used = (0..info.parameters.len())
            .filter(|&at| info.parameters[at].used && info.gravity != Some(at) && set.values[at] != 0.0);
        let mut found = 0;
        for at in used {
            let mut changed = set.values.to_vec();
            changed[at] *= 1.25;
            let Some(given) = given(model, &changed) else { continue };
            let report = check_machine(&given, &machine).expect("a check");
            if report.agrees {
                continue;
            }
            let name = info.parameters[at].name;
            let all = report.explanations.iter().flat_map(|group| &group.explanations).flat_map(|own| &own.causes);
            let is_named = all.clone().any(|cause| cause.starts_with(&format!("{name} is ")));
            assert!(is_named, "{} {}: {name} = {}\n{report}", info.name, set.name, changed[at]);
            found += 1;
            if found == 3 {
                break;
            }
        }
        assert!(found > 0, "no parameter of {} shows in its matrices", info.name);
    }
}

/// A diameter for a radius is also twice the radius, and another value of it.
#[test]
fn another_value_is_told_once() {
    let set = WHIPPLE.info.sets[0];
    let radius = WHIPPLE.info.position("rF").expect("a radius");
    let mut changed = set.values.to_vec();
    changed[radius] *= 2.0;
    let machine = Machine::with(WHIPPLE.info, set.values).expect("formulas that can be read");
    let given = given(&WHIPPLE, &changed).expect("matrices");
    let report = check_machine(&given, &machine).expect("a check");
    let all = report.explanations.iter().flat_map(|group| &group.explanations).flat_map(|own| &own.causes);
    assert_eq!(all.filter(|cause| cause.starts_with("rF is ")).count(), 1, "{report}");
}
