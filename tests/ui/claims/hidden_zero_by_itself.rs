carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            g: N/kg, >= 0, gravity;
        }

        let I = m*l^2;
        let d = sin(l/l)^2 + cos(l/l)^2 - 1;
        let e = d/d;
        assert e == 1;

        coordinates {
            theta: rad;
        }

        M = [[I]];
        K0 = [[m*l]];
    }
}

fn main() {}
