carvallo::model! {
    pub model Wheel {
        parameters {
            m: kg, > 0;
            k: N/m, > 0;
            c: N*s/m, > 0;
        }

        coordinates {
            x: m;
            s: m, only position;
        }

        M = [[m, 0], [0, 0]];
        C0 = [[0, 0], [0, c*k]];
        Kc = [[k, -k], [-k, k]];
    }
}

fn main() {}
