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

        assert C-1 == [[f + r, a*f - b*r], [a*f - b*r, a^2*f - b^2*r]];

        coordinates {
            y "lateral": m;
            psi "yaw": rad;
        }

        M = [[m, 0], [0, I]];
        C = [[(f + r)/v, (a*f - b*r)/v], [(a*f - b*r)/v, (a^2*f + b^2*r)/v]];
        K = [[0, -(f + r)], [0, -(a*f - b*r)]];
    }
}

fn main() {}
