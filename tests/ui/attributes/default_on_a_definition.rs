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
        let twice = 2*l;
        assert twice == l + l;
    }
}

fn main() {}
