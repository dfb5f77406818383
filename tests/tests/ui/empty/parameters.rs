carvallo::model! {
    pub model Pendulum {
        parameters {
        }
        coordinates {
            theta: rad;
        }
        M = [[1]];
    }
}

fn main() {}
