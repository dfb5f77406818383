carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        let I = 2(m + l);
        coordinates {
            theta: rad;
        }
        M = [[I]];
    }
}

fn main() {}
