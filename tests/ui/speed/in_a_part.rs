carvallo::model! {
    pub model Car {
        parameters {
            m: kg, > 0;
            I: kg*m^2, > 0;
            a: m, > 0;
            b: m, > 0;
            f: N, > 0;
            r: N, > 0;
            v: m/s, speed;
        }

        coordinates {
            y "lateral": m;
            psi "yaw": rad;
        }

        M = [[m, 0], [0, I]];
        C0 = [[f/v, 0], [0, 0]];
        K = [[0, -(f + r)], [0, -(a*f - b*r)]];
    }
}

fn main() {}
