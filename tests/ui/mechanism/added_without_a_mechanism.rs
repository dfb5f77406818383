carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            d: N*m*s, >= 0;
            g: N/kg, >= 0, gravity;
        }

        coordinates {
            theta: rad;
        }

        M = [[m*l^2]];
        add C0 = [[d]];
        K0 = [[m*l]];
    }
}

fn main() {}
