carvallo::model! {
    pub model Wheel {
        parameters {
            m: kg, > 0;
            k: N/m, > 0;
            c: N*s/m, > 0;
        }

        coordinates {
            x: m;
            s: m;
        }

        M = [[m, 0], [0, 0]];
        C0 = [[c, c], [c, k/k*c - c]];
        Kc = [[k, -k], [-k, k]];
    }
}

fn main() {}
