carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0, along z;
            g: N/kg, >= 0, gravity;
        }

        let h = 2*l;

        mechanism {
            body B "bob": mass m, at (0, 0, l), inertia 0;
            revolute theta: ground to B, through (0, 0, 0), along (1, 0, 0);
        }

        coordinates {
            theta: rad;
        }

        set example {
            m = 1;
            l = 2;
            g = 9.81;
        }
    }
}

fn main() {}
