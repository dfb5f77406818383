carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0, along z;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "bob": mass m, at (0, 0, l), inertia [m*l^2, m*l^2, m*l^2];
            free B: lateral y, vertical z, yaw psi, lean phi, pitch theta;
        }

        coordinates {
            y: m;
            z: m;
            psi: rad;
            phi: rad;
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
