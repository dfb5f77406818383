carvallo::model! {
    pub model Pendulums {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            k: N/m, > 0;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body A: mass m, at (0, 0, l), inertia 0;
            body B: mass m, at (0, l, l), inertia 0;
            revolute a: ground to A, through (0, 0, 0), along (1, 0, 0);
            revolute b: ground to B, through (0, l, 0), along (1, 0, 0);
            hold lateral; link S: A to B, from (0, 0, l), to (0, l, l), spring k;
        }

        coordinates {
            a: rad;
            b: rad;
        }
    }
}

fn main() {}
