carvallo::model! {
    pub model Pendulum {
        parameters {
            pub m: kg, > 0;
            l: m, > 0;
        }
        coordinates {
            theta: rad;
        }
        M = [[l^2*1 [kg]]];
    }
}

fn main() {}
