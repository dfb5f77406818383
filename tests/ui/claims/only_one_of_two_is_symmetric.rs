carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            g: N/kg, >= 0, gravity;
        }

        let s = m*l;

        coordinates {
            theta: rad;
            phi: rad;
        }

        symmetric M = [[m*l^2, s*l], [l^2*m, m*l^2]];
        symmetric K0 = [[0, s], [-s, 0]];
    }
}

fn main() {}
