carvallo::model! {
    pub model Pendulum {
        parameters {
            Iyy: kg*m^2, >= 0;
            Ixx: kg*m^2, >= 0;
            m: kg, > 0;
            l: m, > 0, along z;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "bob": mass m, at (0, 0, l), inertia [Ixx, Iyy, 0];
            revolute theta: ground to B, through (0, 0, 0), along (1, 0, 0);
        }

        coordinates {
            theta: rad;
        }

        set example {
            Iyy = 1;
            Ixx = 1;
            m = 1;
            l = 2;
            g = 9.81;
        }
    }
}

fn main() {}
