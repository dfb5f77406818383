carvallo::model! {
    pub model Pendulum {
        parameters {
            k: N/m, >= 0;
            m: kg, > 0;
            l: m, > 0, along z;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "bob": mass m, at (0, 0, l), inertia 0;
            revolute theta: ground to B, through (0, 0, 0), along (1, 0, 0), spring k;
        }

        coordinates {
            theta: rad;
        }

        set example {
            k = 1;
            m = 1;
            l = 2;
            g = 9.81;
        }
    }
}

fn main() {}
