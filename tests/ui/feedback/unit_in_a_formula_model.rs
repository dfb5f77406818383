carvallo::model! {
    pub model Rod {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            k: N*m;
        }

        coordinates {
            phi: rad; x: m;
        }

        M = [[m*l^2, m*l], [m*l, m]];
        feedback F on x = -k*phi;
    }
}

fn main() {}
