//! Generated code beside code by hand: the same formulas proved equal, compared in digits, and timed.
//!
//! ```sh
//! cargo run --release -p carvallo --features derive --example comparing
//! ```

use std::hint::black_box;
use std::time::Instant;

carvallo::model! {
    /// Two point masses on massless rods, hanging one from the other. The second angle is that between the rods.
    pub model DoublePendulum {
        parameters {
            /// Lengths of the upper and of the lower rod.
            l1: m, > 0; l2: m, > 0;
            /// The masses at their ends.
            m1: kg, > 0; m2: kg, > 0;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }
        mechanism {
            body upper: mass m1, at (0, 0, l1), inertia 0;
            body lower: mass m2, at (0, 0, l1 + l2), inertia 0;
            revolute theta1: ground to upper, through (0, 0, 0), along (1, 0, 0);
            revolute theta2: upper to lower, through (0, 0, l1), along (1, 0, 0);
        }
        coordinates { theta1: rad; theta2: rad; }

        // What is derived is proved to be what stands here, each time this is compiled.
        assert M == [[m1*l1^2 + m2*(l1 + l2)^2, m2*l2*(l1 + l2)], [m2*l2*(l1 + l2), m2*l2^2]];
        assert K0 == [[m1*l1 + m2*(l1 + l2), m2*l2], [m2*l2, m2*l2]];
    }
}

/// The mass matrix and the stiffness for unit gravity, as one writes them.
fn by_hand(p: &DoublePendulum) -> [[[f64; 2]; 2]; 2] {
    let DoublePendulum { l1, l2, m1, m2, .. } = *p;
    let m12 = m2 * l2 * (l1 + l2);
    let k12 = m2 * l2;
    [
        [[m1 * l1.powi(2) + m2 * (l1 + l2).powi(2), m12], [m12, m2 * l2.powi(2)]],
        [[m1 * l1 + m2 * (l1 + l2), k12], [k12, m2 * l2]],
    ]
}

fn generated(p: &DoublePendulum) -> [[[f64; 2]; 2]; 2] {
    let DoublePendulumMatrices { m, k0 } = p.matrices();
    [m.0, k0.0]
}

fn main() {
    // A hundred thousand designs: each parameter from 0.1 to 2, by the fractional parts of multiples of irrational numbers.
    let part = |i: u32, irrational: f64| 0.1 + 1.9 * (f64::from(i) * irrational).fract();
    let designs: Vec<DoublePendulum> = (0..100_000)
        .map(|i| DoublePendulum {
            l1: part(i, 2_f64.sqrt()),
            l2: part(i, 3_f64.sqrt()),
            m1: part(i, 5_f64.sqrt()),
            m2: part(i, 7_f64.sqrt()),
            g: 9.81,
        })
        .collect();

    let difference = |design: &DoublePendulum| {
        let entries = |matrices: [[[f64; 2]; 2]; 2]| matrices.as_flattened().as_flattened().to_vec();
        let pairs = entries(generated(design)).into_iter().zip(entries(by_hand(design)));
        pairs.map(|(ours, theirs)| (ours / theirs - 1.0).abs() / f64::EPSILON).fold(0.0, f64::max)
    };
    let largest = designs.iter().map(difference).fold(0.0, f64::max);
    println!("{} designs differ by {largest} epsilons at most", designs.len());

    // Taking turns, so that whatever else the machine does hits both alike; the shortest of 50 rounds counts.
    let time = |function: fn(&DoublePendulum) -> [[[f64; 2]; 2]; 2]| {
        let start = Instant::now();
        for design in &designs {
            black_box(function(black_box(design)));
        }
        start.elapsed().as_secs_f64() / designs.len() as f64 * 1e9
    };
    let (mut ours, mut theirs) = (f64::INFINITY, f64::INFINITY);
    for _ in 0..50 {
        ours = ours.min(time(generated));
        theirs = theirs.min(time(by_hand));
    }
    println!("generated {ours:.2} ns, by hand {theirs:.2} ns for each design");
    if cfg!(debug_assertions) {
        println!("(without optimization: times mean something with --release)");
    }
}
