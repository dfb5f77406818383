carvallo::model! {
    pub model Pendulum {
        parameters {
            I: kg*m^2, >= 0;
            m: kg, > 0;
            l: m, > 0, along z;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "bob": mass m, at (0, 0, l), inertia [[I, 0, 0], [0, I, 0]];
            revolute theta: ground to B, through (0, 0, 0), along (1, 0, 0);
        }

        coordinates {
            theta: rad;
        }

        set example {
            I = 1;
            m = 1;
            l = 2;
            g = 9.81;
        }
    }
}

fn main() {}
