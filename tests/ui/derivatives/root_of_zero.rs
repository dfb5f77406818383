carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m^2, >= 0;
        }
        derivatives;
        coordinates {
            theta: rad;
        }
        M = [[m*sqrt(l)*1 [m]]];
    }
}

fn main() {}
