carvallo::model! {
    pub model Pendulum {
        parameters {
            a: m, > 0;
            b: m, > 0;
            m: kg, > 0;
        }

        let p = (a/b + 1)^64;
        let q = (p - 1)^16;

        coordinates {
            theta: rad;
        }

        M = [[q*m*a^2]];
    }
}

fn main() {}
