carvallo::model! {
    pub model Hanging {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            I: kg*m^2, > 0;
        }

        mechanism {
            body B: mass m, at (0, 0, l), inertia [I, I, I];
            ball N: ground to B, through (0, 0, 0), yaw a, lean a, pitch c;
        }

        coordinates {
            a: rad; c: rad;
        }
    }
}

fn main() {}
