carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, in [0, 0], != 0;
            l: m, > 0;
            g: N/kg, >= 0, gravity;
        }

        coordinates {
            theta: rad;
        }

        M = [[m*l^2]];
        K0 = [[m*l]];
    }
}

fn main() {}
