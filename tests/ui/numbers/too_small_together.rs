carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        let I = m*l^2/1e200/1e200;
        coordinates {
            theta: rad;
        }
        M = [[I]];
    }
}

fn main() {}
