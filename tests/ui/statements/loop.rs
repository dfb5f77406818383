carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        for i in 0..2 { let a = i; }
        coordinates {
            theta: rad;
        }
        M = [[m*l^2]];
    }
}

fn main() {}
