carvallo::model! {
    pub model Oscillator {
        parameters {
            g: N/kg, >= 0, gravity;
            m: kg, > 0;
            d: N*s/m, >= 0;
        }

        mechanism {
            body B "block": mass m, at (0, 0, 0), inertia 0;
            prismatic x: ground to B, along (1, 0, 1), damper d;
            force F "push" on x;
        }

        coordinates {
            x: m;
        }

        set example {
            g = 9.81;
            m = 1;
            d = 3;
        }
    }
}

fn main() {}
