carvallo::model! {
    pub model Rod {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            k: N*m;
        }

        coordinates {
            phi: rad; delta: rad;
        }

        M = [[m*l^2, 0], [0, m*l^2]];
        C0 = [[k*rate(phi), 0], [0, 0]];
    }
}

fn main() {}
