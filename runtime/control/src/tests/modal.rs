//! Modal controllability and observability, by scipy 1.17 (`scipy.linalg.eig(A, left=True)` of what `carvallo statespace` prints);
//! where they are lost, by sympy: the resultant of the two entries of a row, or a column, of M s² + v C1 s + g K0 + v² K2.

use carvallo::Complex;

use super::{benchmark, design};
use crate::{ModalAnalysis, Port, Ports, lost};

/// An eigenvalue, and the cosines of inputs and outputs.
type Row = ([f64; 2], &'static [f64], &'static [f64]);

fn hold(model: &str, set: &str, speed: f64, [inputs, outputs]: [&[&str]; 2], rows: &[Row]) {
    let design = design(model, set);
    let ports = Ports::of(&design);
    let inputs = inputs.iter().map(|name| ports.input(name).expect("an input")).collect();
    let outputs = outputs.iter().map(|name| ports.output(name).expect("an output")).collect();
    let values: Vec<Complex<f64>> = rows.iter().map(|(value, ..)| Complex::new(value[0], value[1])).collect();
    let found = ModalAnalysis::new(&design, inputs, outputs).at(speed, &values).expect("measures");
    assert_eq!(found.len(), rows.len());
    for (found, (value, controllability, observability)) in found.iter().zip(rows) {
        for (found, expected) in [(&found.controllability, controllability), (&found.observability, observability)] {
            let close = found.iter().zip(*expected).all(|(a, b)| (a - b).abs() < 1e-11);
            assert!(close && found.len() == expected.len(), "{model} {value:?}: {found:?} is not {expected:?}");
        }
    }
}

#[test]
fn cosines_are_those_of_eigenvectors_of_the_state_matrix() {
    let bicycle: [Row; 3] = [
        (
            [-14.078389692798233, 0.0],
            &[0.6069387393585516, 0.5409197960071368],
            &[0.00016186740605523482, 0.07085215239686873, 0.05488538012550981],
        ),
        (
            [-0.7753418821958487, 4.464867713788227],
            &[0.07003744254346182, 0.06485613862227223],
            &[0.13151945826836375, 0.17069294584939587, 0.16899424019628642],
        ),
        (
            [-0.32286642900408385, 0.0],
            &[0.0458832747331665, 0.0436514600887796],
            &[0.8748119592761536, 0.37456912317956853, 0.372586462440755],
        ),
    ];
    hold("Whipple", "benchmark", 5.0, [&["Tphi", "Tdelta"], &["phi", "delta", "psi_rate"]], &bicycle);
    let motorcycle: [Row; 3] = [
        (
            [-57.5398809328184, 0.0],
            &[0.0005066564809331623, 0.01186769842974158],
            &[0.012611436923517148, 0.3873791227356525, 0.026305656799465168],
        ),
        (
            [-4.550048253346443, 16.195441733744094],
            &[0.005418670328445678, 0.016352301597024683],
            &[0.03248666936807151, 0.5026221177428551, 0.006638119013004852],
        ),
        (
            [0.08308742198646787, 0.0],
            &[0.008405276829080436, 0.028689081424542916],
            &[0.8925047294312558, 0.42177826454886036, 0.01901827268015769],
        ),
    ];
    hold("Motorcycle", "standard", 20.0, [&["Tdelta", "Fy"], &["phi", "psi_rate", "er"]], &motorcycle);
}

#[test]
fn coordinates_of_first_order_and_of_rates_have_their_modes() {
    let wheel: [Row; 2] = [
        (
            [-2.152452936245961, 0.0],
            &[0.9568330571410743, 0.28991182501457546],
            &[0.3923404772501622, 0.36455196826224934],
        ),
        (
            [-0.010730053616150183, 0.7783745294962796],
            &[0.3783128329939025, 0.316945521410799],
            &[0.3490696393011561, 0.8968342709437532],
        ),
    ];
    hold("TowedWheel", "example", 2.0, [&["Tpsi", "Fy"], &["psi", "y"]], &wheel);
    let car: [Row; 2] = [
        (
            [-2.0369923110623347, 0.0],
            &[0.02986692537690714, 0.9995538838744665],
            &[0.9998062728349008, 0.01968290628906098],
        ),
        (
            [-1.0446437574146425, 0.0],
            &[0.01968290628906098, 0.9998062728349008],
            &[0.9995538838744665, 0.02986692537690714],
        ),
    ];
    hold("Car", "oversteering", 20.0, [&["Fy", "Tpsi"], &["y_rate", "psi_rate"]], &car);
}

/// The matrices are those that Meijaard et al. (2007) print with 14 decimals.
#[test]
fn a_bicycle_is_lost_to_its_rider_at_four_speeds() {
    let bicycle = benchmark();
    let ports = Ports::of(&bicycle);
    let input = |name: &str| Port::Input(ports.input(name).expect("an input"));
    let output = |name: &str| Port::Output(ports.output(name).expect("an output"));
    let expected: [(Port, &[(f64, f64)]); 4] = [
        (input("Tphi"), &[(0.595732633399066, 3.426829386009529), (2.60735402300071, -2.872135583808463)]),
        (input("Tdelta"), &[(0.0250778535121912, 3.13466385808362), (1.41102435675689, -3.13466385808362)]),
        (output("phi"), &[(0.333929039134733, -6.078711191170209), (5.38639508448078, -14.84483954202708)]),
        (output("delta"), &[(1.01682595793391, -3.13466385808362)]),
    ];
    for (port, expected) in expected {
        let found = lost(&bicycle, port, 10.0).expect("speeds");
        assert_eq!(found.len(), expected.len(), "{port:?}: {found:?}");
        for (found, (speed, eigenvalue)) in found.iter().zip(expected) {
            assert!((found.speed - speed).abs() < 1e-11, "{port:?}: {found:?} is not at {speed}");
            assert!((found.eigenvalue.re - eigenvalue).abs() < 1e-10, "{port:?}: {found:?} is not {eigenvalue}");
        }
    }
}

/// Where the smallest singular value of [A - s, B], and of the same with C below, is least, by numpy and the search of scipy, which
/// sees no less than 1e-7 of the speed; at the speeds found here they are 1.2e-15 and 7e-16.
#[test]
fn a_motorcycle_is_lost_where_the_matrix_of_hautus_is_singular() {
    let motorcycle = design("Motorcycle", "standard");
    let ports = Ports::of(&motorcycle);
    let torque = Port::Input(ports.input("Tdelta").expect("an input"));
    let lean = Port::Output(ports.output("phi").expect("an output"));
    for (port, speed, eigenvalue) in [(torque, 2.456069425508662, -3.5235), (lean, 1.9956233438363864, -16.8404)] {
        let found = lost(&motorcycle, port, 20.0).expect("speeds");
        assert_eq!(found.len(), 1, "{found:?}");
        assert!(
            (found[0].speed - speed).abs() < 1e-7 && (found[0].eigenvalue.re - eigenvalue).abs() < 1e-4,
            "{found:?}"
        );
    }
}

#[test]
fn integrals_are_no_modes() {
    let bicycle = benchmark();
    let output = Ports::of(&bicycle).output("psi").expect("an output");
    let failure = ModalAnalysis::new(&bicycle, vec![1], vec![output]).at(5.0, &[]).unwrap_err();
    assert_eq!(failure.to_string(), "--outputs psi: `psi` is an integral, which no mode is of; its rate is `psi_rate`");
}
