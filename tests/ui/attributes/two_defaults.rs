carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
        }
        coordinates {
            theta: rad;
        }
        M = [[m*l^2]];
        #[default]
        set bob { m = 1; l = 2; }
        #[default]
        set rod { m = 1; l = 3; }
    }
}

fn main() {}
