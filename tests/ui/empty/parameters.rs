carvallo::model! {
    pub model Pendulum {
        parameters {
        }
        coordinates {
            theta: rad;
        }
        M = [[1 [kg*m^2]]];
    }
}

fn main() {}
