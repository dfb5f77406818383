//! The README's coin, which does not ask for derivatives: it works everywhere else, and says what to add.

use carvallo::{Model, Sensitivity, SensitivityError};
use carvallo_design::Shipped;

carvallo::model! {
    /// A coin that rolls: it stays up while it is fast.
    pub model Coin {
        parameters { r: m, > 0; m: kg, > 0; g: N/kg, >= 0, gravity; }
        mechanism {
            wheel D: mass m, at (0, 0, -r), radius r, axial m*r^2/2, radial m*r^2/4;
            free D: lean phi, yaw psi;
        }
        coordinates { phi "lean": rad; psi "yaw": rad; }
        set euro { r = 11.625 mm; m = 7.5 g; g = 9.81; }
    }
}

/// As the command line lists what `each_model!` has.
static COIN: Shipped = Shipped::of::<2, Coin>();

#[test]
fn the_command_line_takes_it_and_refuses_sensitivities_alone() {
    let values = Coin::EURO.to_array();
    let equations = COIN.equations(&values).expect("valid parameters");
    let stability = equations.stability(Coin::EURO.g).expect("an answer");
    // Textbooks: a uniform disc stays up where v^2 > g r/3.
    let expected = (9.81 * 0.011625 / 3.0_f64).sqrt();
    let found = stability.critical_speeds[0].speed;
    assert!((found - expected).abs() < 1e-15, "{found} is not {expected}");

    let message = COIN.sensitivity(&values).expect_err("no derivatives");
    assert!(message.contains("`Coin` was compiled without derivatives; add `derivatives;`"), "{message}");
}

#[test]
fn the_library_tells_before_and_while_the_program_runs() {
    assert_eq!(Coin::EURO.derivatives(), None);
    let error = Sensitivity::of_any(&Coin::EURO).expect_err("no derivatives");
    assert_eq!(error, SensitivityError::WithoutDerivatives { model: "Coin" });

    let whipple = carvallo_models::Whipple::BENCHMARK;
    assert_eq!(Sensitivity::of_any(&whipple), Sensitivity::of(&whipple));
}
