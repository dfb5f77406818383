carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            length: m, > 0;
            g: N/kg, >= 0, gravity;
        }

        let I = m*lenght^2;

        coordinates {
            theta: rad;
        }

        M = [[I]];
        K0 = [[m*length]];

        set bob {
            m = 1;
            length = 2;
            g = 9.81;
        }
    }
}

fn main() {}
