carvallo::model! {
    pub model Pendulum {
        parameters {
            r: m, > 0, along z;
            m: kg, > 0;
            l: m, > 0, along z;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "bob": mass m, at (0, 0, l), inertia 0;
            revolute theta: ground to B, through (0, 0, 0), along (1, 0, 0);
            wheel W on B: mass 0, at (0, 0, -r), radius r, axial 0, radial 0;
        }

        coordinates {
            theta: rad;
        }

        set example {
            r = 0.3;
            m = 1;
            l = 2;
            g = 9.81;
        }
    }
}

fn main() {}
