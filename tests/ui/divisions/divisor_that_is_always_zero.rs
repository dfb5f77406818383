carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            g: N/kg, >= 0, gravity;
        }

        let d = l - l;

        coordinates {
            theta: rad;
        }

        M = [[m*l^2]];
        K0 = [[m*l^2/d]];

        set bob {
            m = 1;
            l = 2;
            g = 9.81;
        }
    }
}

fn main() {}
