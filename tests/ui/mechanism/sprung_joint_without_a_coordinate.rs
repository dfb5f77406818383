carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0, along y;
            k: N*m/rad, > 0;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body A "arm": mass m, at (0, l, 0), inertia 0;
            body B "bob": mass m, at (0, l, 0), inertia 0;
            revolute theta: ground to A, through (0, 0, 0), along (0, 0, 1);
            revolute phi: A to B, through (0, 0, 0), along (1, 0, 0), spring k;
        }

        coordinates {
            theta: rad;
        }
    }
}

fn main() {}
