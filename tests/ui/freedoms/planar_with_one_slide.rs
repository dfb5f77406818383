carvallo::model! {
    pub model Hanging {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            I: kg*m^2, > 0;
        }

        mechanism {
            body B: mass m, at (0, 0, l), inertia [I, I, I];
            planar P: ground to B, through (0, 0, l), slides a along (1, 0, 0), turns c;
        }

        coordinates {
            a: m; c: rad;
        }
    }
}

fn main() {}
