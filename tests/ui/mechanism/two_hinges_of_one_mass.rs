carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0, along z;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body A: massless;
            body B: mass m, at (0, 0, 3*l), inertia 0;
            revolute x: ground to A, through (0, 0, 0), along (1, 0, 0);
            revolute y: A to B, through (0, 0, l), along (1, 0, 0);
        }

        coordinates {
            x: rad;
            y: rad;
        }
    }
}

fn main() {}
