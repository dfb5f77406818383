carvallo::model! {
    pub model Pendulum {
        parameters {
            pi: kg, > 0;
        }
        coordinates {
            theta: rad;
        }
        M = [[pi]];
    }
}

fn main() {}
