carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        coordinates {
            theta: rad;
        }
        M[0][0] = m*l^2;
    }
}

fn main() {}
