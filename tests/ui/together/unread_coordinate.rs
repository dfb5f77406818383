carvallo::model! {
    pub model Masses {
        parameters {
            m: kg, > 0;
            k: N/m, > 0;
        }

        coordinates {
            x: m;
            2y: m;
        }

        M = [[m, 0], [0, m]];
        Kc = [[k, 0], [0, k]];
    }
}

fn main() {}
