carvallo::model! {
    pub model Pendulum {
        coordinates {
            theta: rad;
        }

        M = [[2 [kg*m^2]]];
    }
}

fn main() {}
