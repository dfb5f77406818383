carvallo::model! {
    pub model Pendulum {
        parameters {
            a: m, > 0;
            b: m, > 0;
            m: kg, > 0;
        }

        coordinates {
            theta: rad;
        }

        M = [[(((a/b + 1)^64)^64)^64*m*a^2]];
    }
}

fn main() {}
