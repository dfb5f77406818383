carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        coordinates {
            theta: rad;
        }
        M = [[m*l^2]];
        nonlinear;
    }
}

fn main() {}
