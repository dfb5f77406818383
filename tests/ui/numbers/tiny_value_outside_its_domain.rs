carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0, < 1e-220;
            l: m, > 0;
        }

        coordinates {
            theta: rad;
        }

        M = [[m*l^2]];

        set tiny {
            m = 1e-200;
            l = 1;
        }
    }
}

fn main() {}
