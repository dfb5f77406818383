carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg,
            l: m,
        }
        coordinates {
            theta: rad;
        }
        M = [[1 [kg*m^2]]];
    }
}

fn main() {}
