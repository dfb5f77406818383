carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            g: N/kg, >= 0, gravity;
        }

        coordinates {
            theta: rad;
            phi: rad;
        }

        symmetric M = [[m*l^2, m*l^2/2], [m*l^2, m*l^2]];
        K0 = [[m*l, 0], [0, 0]];
    }
}

fn main() {}
