carvallo::model! {
    pub model Arm {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            k: N*m;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body A: mass m, at (0, 0, -l), inertia 0;
            body B: mass m, at (0, 0, -2*l), inertia 0;
            revolute phi: ground to A, through (0, 0, 0), along (1, 0, 0);
            revolute delta: A to B, through (0, 0, -l), along (1, 0, 0);
        }

        coordinates {
            phi: rad; delta: rad;
        }

        feedback T on dleta = -k*phi;
    }
}

fn main() {}
