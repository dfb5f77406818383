//! The four matrices with all their derivatives, against the matrices alone.

use std::hint::black_box;

use carvallo::Scalar;
use carvallo_compare::Task;
use carvallo_models::{Whipple, WhippleMatrices, WhippleMechanism};
use carvallo_tests::chosen::WhippleChosen;
use carvallo_tests::designs;
use carvallo_tests::hand_written::{self, Float};
use carvallo_tests::peers::symplex::Symplex;

use crate::Summary;

const REPETITIONS: usize = 100;

pub fn add(summary: &mut Summary) {
    let design = designs::numbered(0);
    for_scalar(summary, "f64", &design, 6e-6);
    for_scalar(summary, "f32", &designs::narrowed(&design), 5e-3);
}

fn for_scalar<T: Float + Symplex>(summary: &mut Summary, scalar: &str, design: &Whipple<T>, step: f64) {
    let mechanism = WhippleMechanism::from_array(design.to_array());
    let chosen = WhippleChosen::from_array(design.to_array());
    let task = Task::new(format!("Four matrices and their Jacobian, {scalar}, one design"), REPETITIONS)
        .contender("ours, from bodies, no Jacobian", repeated(&mechanism, WhippleMechanism::matrices))
        .contender("ours, from bodies", repeated(&mechanism, WhippleMechanism::matrices_and_derivatives))
        .contender("ours, from bodies, in place", {
            let (mut matrices, mut derivatives) = mechanism.matrices_and_derivatives();
            repeated(&mechanism, move |design| {
                design.write_matrices_and_derivatives(&mut matrices, &mut derivatives);
                black_box((&matrices, &derivatives));
            })
        })
        .contender("ours, from formulas, no Jacobian", repeated(design, Whipple::matrices))
        .contender("ours, from formulas", repeated(design, Whipple::matrices_and_derivatives))
        .contender("ours, from formulas, in place", {
            let (mut matrices, mut derivatives) = design.matrices_and_derivatives();
            repeated(design, move |design| {
                design.write_matrices_and_derivatives(&mut matrices, &mut derivatives);
                black_box((&matrices, &derivatives));
            })
        })
        .contender(
            "ours, from formulas, those of M, K0 by w, c",
            repeated(&chosen, WhippleChosen::matrices_and_derivatives),
        )
        .contender("symplex-build 0.57", repeated(design, Symplex::entries_and_derivatives))
        .contender("by hand, central differences", repeated(design, |design| differences(design, step)));
    summary.run(task);
}

/// Leaves the result where it is returned, since copying a kilobyte would take as long as computing it.
fn repeated<D, R>(design: &D, mut compute: impl FnMut(&D) -> R) -> impl FnMut() {
    move || {
        for _ in 0..REPETITIONS {
            let result = compute(black_box(design));
            black_box(&result);
        }
    }
}

/// Appendix A by hand and its central differences, to some ten digits in `f64` and three in `f32`.
fn differences<T: Float + Scalar>(design: &Whipple<T>, step: f64) -> ([T; 16], [[T; 16]; 26]) {
    let scale = T::from_f64(0.5 / step);
    let step = T::from_f64(step);
    let mut derivatives = [[scale; 16]; 26];
    let parameters = design.to_array();
    for (parameter, derivatives) in derivatives.iter_mut().enumerate() {
        let [above, below] = [parameters[parameter] + step, parameters[parameter] - step].map(|value| {
            let mut parameters = parameters;
            parameters[parameter] = value;
            by_hand(&Whipple::from_array(parameters))
        });
        for (derivative, (above, below)) in derivatives.iter_mut().zip(above.into_iter().zip(below)) {
            *derivative = (above - below) * scale;
        }
    }
    (by_hand(design), derivatives)
}

fn by_hand<T: Float + Scalar>(design: &Whipple<T>) -> [T; 16] {
    let WhippleMatrices { m, c1, k0, k2 } = hand_written::matrices(design);
    let rows = [m[0], m[1], c1[0], c1[1], k0[0], k0[1], k2[0], k2[1]];
    std::array::from_fn(|entry| rows[entry / 2][entry % 2])
}
