//! A model whose formulas come from an outer macro: each fragment stays one value.

macro_rules! rod {
    ($name:ident, $inertia:expr) => {
        carvallo::model! {
            model $name {
                parameters { l: m, > 0; m: kg, > 0; }
                coordinates { theta: rad; }
                M = [[2 * $inertia]];
            }
        }
    };
}

rod!(Rod, m * l ^ 2 + m * l ^ 2 / 2);

fn main() {
    // 2 (m l^2 + m l^2 / 2), not 2 m l^2 + m l^2 / 2.
    assert_eq!(Rod { l: 2.0, m: 3.0 }.matrices().m, [[36.0]]);
}
