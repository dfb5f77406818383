carvallo::model! {
    pub model Pendulum {
        parameters {
            type: kg, > 0;
            l: m, > 0;
        }
        let I = type*l^2;
        coordinates {
            theta: rad;
        }
        M = [[I + type]];
        set bob { type = 1; l = 2; }
    }
}

fn main() {}
