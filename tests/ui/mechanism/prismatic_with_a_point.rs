carvallo::model! {
    pub model Oscillator {
        parameters {
            m: kg, > 0;
            k: N/m, >= 0;
            d: N*s/m, >= 0;
        }

        mechanism {
            body B "block": mass m, at (0, 0, 0), inertia 0;
            prismatic x: ground to B, through (0, 0, 0), along (1, 0, 0), spring k, damper d;
            force F "push" on x;
        }

        coordinates {
            x: m;
        }

        set example {
            m = 1;
            k = 2;
            d = 3;
        }
    }
}

fn main() {}
