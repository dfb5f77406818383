carvallo::model! {
    pub model Pendulum {
        parameters {
            self: kg, > 0;
            Self: m;
        }
        coordinates {
            theta: rad;
        }
        M = [[self*Self]];
    }
}

fn main() {}
