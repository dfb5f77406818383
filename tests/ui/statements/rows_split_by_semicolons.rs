carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        coordinates {
            theta: rad;
            phi: rad;
        }
        M = [[m, 0]; [0, l]];
    }
}

fn main() {}
