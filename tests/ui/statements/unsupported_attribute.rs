carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            g: N/kg, >= 0, gravity;
        }

        let I = m*l^2;

        coordinates {
            #[serde(default)]
            theta: rad;
        }

        M = [[I]];
        K0 = [[m*l]];

        set bob {
            m = 1;
            l = 2;
            g = 9.81;
        }
    }
}

fn main() {}
