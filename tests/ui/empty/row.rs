carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
        }
        coordinates {
            theta: rad;
        }
        M = [[]];
    }
}

fn main() {}
