carvallo::model! {
    pub model Cart {
        parameters {
            m: kg, > 0;
            c: N, > 0;
            v: m/s, speed;
        }

        mechanism {
            body B: mass m, at (0, 0, 0), inertia 0;
            prismatic x: ground to B, along (0, 1, 0);
        }

        coordinates {
            x: m;
        }

        C = [[c/v]];
    }
}

fn main() {}
