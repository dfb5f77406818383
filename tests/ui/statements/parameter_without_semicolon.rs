carvallo::model! {
    pub model Mass {
        parameters {
            m: kg, > 0
            k: N/m, > 0
            l "ℓ": m, > 0;
        }

        coordinates {
            x: m;
        }

        M = [[m]];
        Kc = [[k*l^2/(l^2 + 1 [m^2])]];
    }
}

fn main() {}
