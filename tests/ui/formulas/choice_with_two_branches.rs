carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        let I = if m { m*l^2 } else { l };
        coordinates {
            theta: rad;
        }
        M = [[I]];
    }
}

fn main() {}
