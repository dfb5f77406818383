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
        C = [[(f + r)/v, (a*f - b*r)/v], [(a*f - b*r)/v, (a^2*f + b^2*r)/v]];
        K = [[m*v^3/a^3*1 [s], 0], [0, 0]];
    }
}

fn main() {}
