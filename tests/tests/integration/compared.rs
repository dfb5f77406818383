//! Functions by hand that declarations name. That these are tests, and pass, is what is tested.

use carvallo::{Coefficients, Model, Number, Rows};

carvallo::model! {
    model RigidPendulum {
        parameters { l: m, > 0; m: kg, > 0; J: kg*m^2, >= 0; g: N/kg, >= 0, gravity; }
        mechanism {
            body bob: mass m, at (0, 0, l), inertia [0, J, 0];
            revolute theta: ground to bob, through (0, 0, 0), along (0, 1, 0);
        }
        coordinates { theta: rad; }
        compare by_hand;
        compare hand::in_double: f64;
    }
}

fn by_hand<T: Number>(p: &RigidPendulum<T>) -> RigidPendulumMatrices<T> {
    let RigidPendulum { l, m, J, .. } = *p;
    RigidPendulumMatrices { m: Rows([[J + m * l * l]]), k0: Rows([[m * l]]) }
}

mod hand {
    pub fn in_double(p: &super::RigidPendulum) -> carvallo::Coefficients<f64, 1> {
        super::by_hand(p).into()
    }
}

/// The same statement with a fault in the function fails: by the macro that it is made of.
#[test]
fn a_fault_is_found() {
    fn wrong(p: &RigidPendulum) -> Coefficients<f64, 1> {
        let mut all = p.coefficients();
        all.m[(0, 0)] -= 2.0 * p.J;
        all
    }
    let report = carvallo_compare::compare!(RigidPendulum, wrong: f64).report().expect("designs");
    let [explanation] = &report.sides[1].explanations[..] else { panic!("{report}") };
    let slip = "\"J + l^2*m\" in Jyy_theta is \"-J + l^2*m\"";
    assert_eq!(explanation.causes, ["`J` has the opposite sign", slip], "{report}");
    assert_eq!(report.broken(carvallo_compare::Limits::default()), ["`wrong` differs in M_11"]);
}
