carvallo::model! {
    pub model Pendulum {
        parameters {
            gen: kg, > 0;
        }
        coordinates {
            theta: rad;
        }
        M = [[gen]];
    }
}

fn main() {}
