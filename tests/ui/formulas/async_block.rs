carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        let I = async { m*l^2 };
        coordinates {
            theta: rad;
        }
        M = [[I]];
    }
}

fn main() {}
