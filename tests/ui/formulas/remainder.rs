carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        let I = m % l;
        coordinates {
            theta: rad;
        }
        M = [[I]];
    }
}

fn main() {}
