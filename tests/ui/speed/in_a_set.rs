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
        K = [[0, -(f + r)], [0, -(a*f - b*r)]];

        set golf { m = 1000; I = 1200; a = 1; b = 1.4; f = 90000; r = 90000; v = 20; }
    }
}

fn main() {}
