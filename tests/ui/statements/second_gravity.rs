carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            h: N/kg, >= 0, gravity;
            g: N/kg, >= 0, gravity;
        }

        let I = m*l^2;

        coordinates {
            theta: rad;
        }

        M = [[I]];
        K0 = [[m*l*h/g]];

        set bob {
            m = 1;
            l = 2;
            h = 1;
            g = 9.81;
        }
    }
}

fn main() {}
