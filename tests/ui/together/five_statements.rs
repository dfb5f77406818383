carvallo::model! {
    pub model Pendulum {
        parameters {
            m kg, > 0;
            l: m, > 0, long;
        }
        let mut I = m*l^2;
        let J = I.powi(2);
        const X: f64 = 1.0;
        coordinates {
            theta: rad;
        }
        M = [[I*J]]
        K0 = [[if m { l }]];
    }
}

fn main() {}
