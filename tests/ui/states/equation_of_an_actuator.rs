carvallo::model! {
    pub model Cart {
        parameters {
            m: kg, > 0;
            kx: N/m;
            kv: N*s/m;
            tau: s, > 0;
        }

        coordinates {
            x: m;
            F: N, only position;
        }

        M = [[m, 0], [0, 0]];
        C = [[0, 0], [kv, tau]];
        K = [[0, -1], [kx, 1]];
    }
}

fn main() {}
