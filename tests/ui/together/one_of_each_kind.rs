carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            m: kg;
            spare: m;
            g: N/kg, >= 0, gravity;
        }

        let I = mass*l^2;
        let J = K;
        let K = J;
        let s = tg(l);

        coordinates {
            theta: rad;
        }

        M = [[I, J]];
        K0 = [[m*l*s]];

        set bob {
            m = 1;
            l = -2;
            length = 2;
            g = 9.81;
        }
    }
}

fn main() {}
