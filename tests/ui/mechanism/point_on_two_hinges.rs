carvallo::model! {
    pub model Point {
        parameters {
            m: kg, > 0;
            a: m, > 0, along y;
        }

        mechanism {
            body A "link": massless;
            body B "point": mass m, at (0, a, 0), inertia 0;
            revolute q1: ground to A, through (0, 0, 0), along (0, 0, 1);
            revolute q2: A to B, through (0, a/2, 0), along (0, 0, 1);
        }

        coordinates {
            q1: rad;
            q2: rad;
        }
    }
}

fn main() {}
