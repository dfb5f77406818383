//! Frequency responses and margins, against python-control 0.10.2 (`stability_margins(…, returnall=True)`, `sys(1j*w)`,
//! `feedback`), and in closed form.

use carvallo::Verdict;

use super::{design, state_space};
use crate::{Margins, StateSpace, TransferFunction};

/// A channel with its input in another unit.
fn scaled(model: &str, set: &str, speed: f64, [input, output]: [&str; 2], factor: f64) -> StateSpace {
    let mut space = state_space(&design(model, set), speed, &[input], &[output]);
    space.b *= factor;
    space
}

struct Expected {
    channel: StateSpace,
    /// Frequency and factor; python-control finds others at 2e8 rad/s, where rounding is all that is left of the phase.
    gain: &'static [(f64, f64)],
    /// Frequency and degrees.
    phase: &'static [(f64, f64)],
    is_stable: bool,
    /// Frequency, gain and degrees, up to full turns.
    response: [(f64, f64, f64); 3],
}

#[test]
fn margins_and_responses_are_those_of_python_control() {
    for Expected { channel, gain, phase, is_stable, response } in [
        Expected {
            channel: scaled("Whipple", "benchmark", 5.0, ["Tdelta", "phi"], -20.0),
            gain: &[(4.654307374422681, 0.2360199856623864)],
            phase: &[(6.395340894592861, -54.46600671751452)],
            is_stable: false,
            response: [
                (0.3, 15.932617359658188, -43.8814115275712),
                (3.0, 3.835195804054283, -102.63967560728764),
                (30.0, 0.006212607567170387, 121.01675183422836),
            ],
        },
        Expected {
            channel: scaled("Whipple", "benchmark", 3.0, ["Tdelta", "delta"], 5.0),
            gain: &[(0.0, 1.0620497421583228), (1.2268424180587534, 0.984208021582216)],
            phase: &[(1.0624783585425848, -0.9257393975618982), (2.6455476369069584, 22.484497519032857)],
            is_stable: true,
            response: [
                (0.3, 0.9466945589349272, 178.97184013222466),
                (3.0, 0.9215220219656373, -150.8397971321376),
                (30.0, 0.02292917954920696, -162.49790840149586),
            ],
        },
        Expected {
            channel: scaled("Motorcycle", "standard", 20.0, ["Tdelta", "phi"], -500.0),
            gain: &[(0.0, 0.00814787652934808), (14.913022427638854, 1.167546163925642)],
            phase: &[(12.629177380277946, 24.487448700871965)],
            is_stable: true,
            response: [
                (0.3, 32.7613030238358, -106.68895967218765),
                (3.0, 3.430356201080424, -103.75651154001287),
                (30.0, 0.04276186245322257, 145.75406490004318),
            ],
        },
        Expected {
            channel: scaled("Whipple", "benchmark", 7.0, ["Tdelta", "psi_rate"], 3.0),
            gain: &[],
            phase: &[
                (0.8805021872168762, -102.72861422896997),
                (5.838217307781275, -153.30009009735969),
                (8.653853886027601, 132.87851167211426),
            ],
            is_stable: false,
            response: [
                (0.3, 2.590929782912012, 69.04849932657555),
                (3.0, 0.5884986419173638, 65.45687873166456),
                (30.0, 0.09070497285707498, -121.43772624225434),
            ],
        },
    ] {
        let what = format!("{:?} to {:?}", channel.inputs[0].name, channel.outputs[0].name);
        let found = Margins::new(&channel, 0, 0).expect("margins");
        let close = |found: f64, expected: f64| (found - expected).abs() <= 1e-9 * expected.abs().max(1.0);
        let factors: Vec<(f64, f64)> = found.gain.iter().map(|margin| (margin.frequency, margin.factor)).collect();
        let angles: Vec<(f64, f64)> =
            found.phase.iter().map(|margin| (margin.frequency, margin.angle.to_degrees())).collect();
        for (found, expected) in [(factors, gain), (angles, phase)] {
            let is_same = |(a, b): (&(f64, f64), &(f64, f64))| close(a.0, b.0) && close(a.1, b.1);
            let same = found.len() == expected.len() && found.iter().zip(expected).all(is_same);
            assert!(same, "{what}: {found:?} is not {expected:?}");
        }
        assert_eq!(found.closed_loop == Verdict::Stable, is_stable, "{what}");
        let function = TransferFunction::new(&channel, 0, 0).expect("a transfer function");
        for (frequency, gain, degrees) in response {
            let found = function.frequency_response(&[frequency])[0];
            assert!((found.gain - gain).abs() <= 1e-11 * gain, "{what}: {found:?} is not {gain}");
            let turns = (found.phase.to_degrees() - degrees) / 360.0;
            assert!((turns - turns.round()).abs() < 1e-11, "{what}: {found:?} is not {degrees}");
        }
    }
}

/// By numpy's `unwrap` for the benchmark at 5 m/s, from 0.01 to 1000 rad/s. From one frequency to the next, a hundredth of a decade
/// away, weave turns the phase by 0.13 rad at most, 2.3 % of 4.5 rad/s by its real part.
#[test]
fn phases_do_not_jump() {
    let bicycle = scaled("Whipple", "benchmark", 5.0, ["Tdelta", "phi"], -20.0);
    let function = TransferFunction::new(&bicycle, 0, 0).expect("a transfer function");
    let frequencies = function.frequencies(Some([0.01, 1000.0]));
    let response = function.frequency_response(&frequencies);
    let (first, last) = (response[0], response[response.len() - 1]);
    assert!((first.phase.to_degrees() + 1.80664284).abs() < 1e-8, "{first:?}");
    assert!((last.phase.to_degrees() + 183.26501683).abs() < 1e-8, "{last:?}");
    assert!(response.windows(2).all(|pair| (pair[1].phase - pair[0].phase).abs() < 0.3));
    let headed = scaled("Whipple", "benchmark", 5.0, ["Tdelta", "psi"], 1.0);
    let function = TransferFunction::new(&headed, 0, 0).expect("a transfer function");
    let response = function.frequency_response(&function.frequencies(None));
    let begin = response[0].phase.to_degrees();
    // A negative gain at rest, behind an integral.
    assert!((begin - 90.0).abs() < 2.0, "{begin}");
    assert!(response.windows(2).all(|pair| (pair[1].phase - pair[0].phase).abs() < 0.3));
}

/// Of `1/(s² + 4)` the gain is one at the roots of 3, where it is positive, and of 5; the loop swings at the root of 5.
#[test]
fn an_undamped_loop_is_marginal() {
    let mut space = state_space(&design("Pendulum", "seconds"), 0.0, &["Ttheta"], &["theta"]);
    space.a = nalgebra::DMatrix::from_row_slice(2, 2, &[0.0, 1.0, -4.0, 0.0]);
    space.b = nalgebra::DMatrix::from_row_slice(2, 1, &[0.0, 1.0]);
    let margins = Margins::new(&space, 0, 0).expect("margins");
    let found: Vec<(f64, f64)> = margins.phase.iter().map(|margin| (margin.frequency, margin.angle)).collect();
    for ((frequency, angle), expected) in found.iter().zip([(3_f64.sqrt(), std::f64::consts::PI), (5_f64.sqrt(), 0.0)])
    {
        assert!((frequency - expected.0).abs() < 1e-14 && (angle - expected.1).abs() < 1e-14, "{found:?}");
    }
    assert_eq!((found.len(), margins.closed_loop), (2, Verdict::Marginal));
}

/// Of two equal masses between three equal springs, `G(s) = s (s^2 + 2) / ((s^2 + 1) (s^2 + 3))` from a force to the rate of the mass
/// that it acts on, and `s / ((s^2 + 1) (s^2 + 3))` to that of the other one: both are imaginary on the axis, so that no gain makes
/// them -1.
#[test]
fn rates_of_undamped_motions_have_no_gain_margins() {
    let mut space = state_space(&design("Pendulum", "seconds"), 0.0, &["Ttheta"], &["theta"]);
    let rows = [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, -2.0, 1.0, 0.0, 0.0, 1.0, -2.0, 0.0, 0.0];
    space.a = nalgebra::DMatrix::from_row_slice(4, 4, &rows);
    for (own, scale) in [(2, 1.0), (3, 1.0), (2, 3.7), (3, -0.31)] {
        space.b = nalgebra::DMatrix::from_row_slice(4, 1, &[0.0, 0.0, scale, 0.0]);
        space.c = nalgebra::DMatrix::from_fn(1, 4, |_, at| f64::from(u8::from(at == own)));
        let margins = Margins::new(&space, 0, 0).expect("margins");
        assert_eq!(margins.gain, [], "{own} {scale}");
    }
}

/// The gain of `k / (s (s + 1) (s + 2))` may be 6: its phase is -180 degrees at the root of two.
#[test]
fn a_textbook_loop_has_its_margin() {
    let mut space = state_space(&design("Pendulum", "seconds"), 0.0, &["Ttheta"], &["theta"]);
    space.a = nalgebra::DMatrix::from_row_slice(3, 3, &[0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, -2.0, -3.0]);
    space.b = nalgebra::DMatrix::from_row_slice(3, 1, &[0.0, 0.0, 1.5]);
    space.c = nalgebra::DMatrix::from_row_slice(1, 3, &[1.0, 0.0, 0.0]);
    let margins = Margins::new(&space, 0, 0).expect("margins");
    let gain = margins.nearest_gain().expect("a gain margin");
    assert_eq!(margins.gain.len(), 1);
    assert!((gain.frequency - 2_f64.sqrt()).abs() < 1e-14 && (gain.factor - 4.0).abs() < 1e-13, "{gain:?}");
    assert!(margins.closed_loop == Verdict::Stable && margins.nearest_phase().expect("a phase margin").angle > 0.0);
}

/// Near a pole with little damping a response is a circle of the diameter of its largest gain, here `1 / (c w)`, in the complex plane;
/// with points of a hundredth of a decade alone it would be a triangle.
#[test]
fn resonances_are_round() {
    let space = state_space(&design("Pendulum", "seconds"), 0.0, &["Ttheta"], &["theta"]);
    let function = TransferFunction::new(&space, 0, 0).expect("a transfer function");
    let response = function.frequency_response(&function.frequencies(None));
    let largest = response.iter().map(|point| point.gain).fold(0.0, f64::max);
    // The damping is 0.1 N m s; stiffness and inertia are 9.81 times 1.988 kg m and 1.976072 kg m^2.
    let undamped = f64::sqrt(9.81 * 1.988 / 1.976072);
    assert!((largest - 1.0 / (0.1 * undamped)).abs() < 1e-3, "{largest}");
    for pair in response.windows(2) {
        assert!((pair[1].value() - pair[0].value()).norm() < 0.05 * largest, "{pair:?}");
    }
}
