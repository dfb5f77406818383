carvallo::model! {
    pub model Mass {
        parameters {
            m: kg, > 0;
        }

        coordinates {
            x: m;
        }

        M = [[m]];

        set light {
            m = 1e-3_f64;
        }
    }
}

fn main() {}
