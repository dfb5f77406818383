carvallo::model! {
    pub model Rotor {
        parameters {
            m: kg, > 0;
            c: N*s/m, >= 0;
            #[serde(skip)]
            v: m/s, speed;
        }
        coordinates {
            x: m;
        }
        M = [[m]];
        C = [[c + m*v*1 [1/m]]];
    }
}

fn main() {}
