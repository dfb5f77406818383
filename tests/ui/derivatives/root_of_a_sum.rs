carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, >= 0;
        }
        derivatives;
        coordinates {
            theta: rad;
        }
        M = [[m*1 [m]*sqrt(l^2 + 3*l*1 [m])]];
    }
}

fn main() {}
