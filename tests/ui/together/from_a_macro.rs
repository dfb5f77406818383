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

rod!(Rod, m * l * length);

fn main() {}
