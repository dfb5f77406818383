carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        derivatives;
        derivatives;
        coordinates {
            theta: rad;
        }
        M = [[m*l^2]];
    }
}

fn main() {}
