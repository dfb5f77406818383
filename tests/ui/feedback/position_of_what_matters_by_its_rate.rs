carvallo::model! {
    pub model Rod {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            k: N*m;
        }

        coordinates {
            phi: rad, only rate; delta: rad;
        }

        M = [[m*l^2, 0], [0, m*l^2]];
        feedback T on delta = -k*phi;
    }
}

fn main() {}
