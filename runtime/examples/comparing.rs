//! Generated code beside code by hand: the same formulas proved equal, compared in digits, counted, and timed.
//!
//! ```sh
//! cargo run --release -p carvallo --features derive --example comparing
//! cargo run --release -p carvallo --features derive --example comparing -- assembly   # needs objdump
//! cargo run --release -p carvallo --features derive --example comparing -- json
//! ```

use std::time::Duration;

use carvallo::{Number, Rows};
use carvallo_compare::{Limits, compare};

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

/// The mass matrix and the stiffness for unit gravity, as one writes them: for any number, so that it can be counted.
fn by_hand<T: Number>(p: &DoublePendulum<T>) -> DoublePendulumMatrices<T> {
    let DoublePendulum { l1, l2, m1, m2, .. } = *p;
    let m12 = m2 * l2 * (l1 + l2);
    let k12 = m2 * l2;
    DoublePendulumMatrices {
        m: Rows([[m1 * (l1 * l1) + m2 * ((l1 + l2) * (l1 + l2)), m12], [m12, m2 * (l2 * l2)]]),
        k0: Rows([[m1 * l1 + m2 * (l1 + l2), k12], [k12, m2 * l2]]),
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let comparison = compare!(DoublePendulum, by_hand).timed(Duration::from_millis(200));
    match std::env::args().nth(1).as_deref() {
        Some("assembly") => println!("{}", comparison.assembly()?),
        Some("json") => println!("{}", comparison.report()?.to_json()),
        _ => {
            let report = comparison.report()?;
            println!("{report}");
            report.assert(Limits { ulps: 4.0, operations_by_hand: Some(1.0), ..Limits::default() });
        }
    }
    Ok(())
}
