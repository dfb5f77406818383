carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            g: N/kg, >= 0, gravity;
        }

        let I = m*l^^2;
        let s = sinn(l);

        coordinates {
            theta: rad;
        }

        M = [[I]]
        K0 = [[m*h*s]];

        set bob {
            m = 1;
            l = 2;

        }
    }
}

fn main() {}
