carvallo::model! {
    pub model Wheel {
        parameters {
            m: kg, > 0;
            k: N/m, > 0;
            c: N*s/m, > 0;
        }

        coordinates {
            x: m;
            s: m, only rate;
        }

        M = [[m, 0], [0, m - m]];
        C0 = [[0, 0], [0, c]];
        Kc = [[k, 0], [-k, 0]];
    }
}

fn main() {}
