carvallo::model! {
    pub model Wheelset {
        parameters {
            m: kg, > 0;
            I: kg*m^2, > 0;
            c: N*s/m, >= 0;
            k: N/m, > 0;
        }

        coordinates {
            y: m;
            yb: m;
        }

        M = [[m, 0, 0], [0, I, 0], [0, 0, m]];
        C0 = [[c, 0, -c], [0, 0, 0], [-c, 0, c]];
        K = [[k, 0, -k], [0, 0, 0], [-k, 0, k]];
    }
}

fn main() {}
