carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0, along z;
            I: kg*m^2, > 0;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "bob": mass -m, at (0, 0, l), inertia [-I, I, I];
            revolute theta: ground to B, through (0, 0, 0), along (1, 0, 0);
        }

        coordinates {
            theta: rad;
        }
    }
}

fn main() {}
