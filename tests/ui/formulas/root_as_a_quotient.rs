carvallo::model! {
    pub model Pendulum {
        parameters {
            a: m, > 0;
            b: m, > 0;
            m: kg, > 0;
        }

        let p = (a/b)^(1/2);

        coordinates {
            theta: rad;
        }

        M = [[p*m*a^2]];
    }
}

fn main() {}
