carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            spare: m;
            g: N/kg, >= 0, gravity;
        }

        assert spare + l == l + spare;

        coordinates {
            theta: rad;
        }

        M = [[m*l^2]];
        K0 = [[m*l]];
    }
}

fn main() {}
