carvallo::model! {
    pub model Pendulum {
        parameters {
            I: kg*m^2, > 0;
            P: kg*m^2, along x*z;
            lam: rad, about y;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "bob": mass 0, at (0, 0, 0), inertia [[I, 0, P], [0, I, 0], [P, 0, I]];
            revolute theta: ground to B, through (0, 0, 0), along (cos(lam), 0, sin(lam)), spring 1 [N*m];
        }

        coordinates {
            theta: rad;
        }

        set example {
            I = 2;
            P = 2.5;
            lam = -0.7853981633974483;
            g = 9.81;
        }
    }
}

fn main() {}
