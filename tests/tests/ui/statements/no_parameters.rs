carvallo::model! {
    pub model Pendulum {
        coordinates {
            theta: rad;
        }

        M = [[2]];
    }
}

fn main() {}
