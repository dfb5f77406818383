carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            #[cfg(test)]
            l: m, > 0;
        }
        coordinates {
            theta: rad;
        }
        M = [[m*l^2]];
        set bob { m = 1; l = 2; }
    }
}

fn main() {}
