carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            g: N/kg, >= 0, gravity;
        }

        coordinates {
            theta: rad;
        }

        M = [[m*l^2]];
        K0 = [[m*l]];

        compare;
    }
}

fn main() {}
