carvallo::model! {
    pub model Arm {
        parameters {
            m: kg, > 0;
            a: kg*m^2, > 0;
            b: kg*m^2, > 0;
            c: kg*m^2, > 0;
            l: m, > 0;
        }

        mechanism {
            body A: massless;
            body B: massless;
            body C: massless;
            body D: massless;
            body E: massless;
            body F: massless;
            body G: mass m, at (l, 2*l, 3*l), inertia [a, b, c];
            revolute q1: ground to A, through (0, 0, 0), along (1, 0, 0);
            revolute q2: A to B, through (0, l, l), along (0, 1, 0);
            revolute q3: B to C, through (l, 0, 2*l), along (0, 0, 1);
            revolute q4: C to D, through (2*l, l, l), along (1, 1, 0);
            revolute q5: D to E, through (l, 3*l, 0), along (0, 1, 1);
            revolute q6: E to F, through (l, l, 3*l), along (1, 0, 2);
            revolute q7: F to G, through (2*l, 0, 0), along (1, 1, 3);
        }

        coordinates {
            q1: rad;
            q2: rad;
            q3: rad;
            q4: rad;
            q5: rad;
            q6: rad;
            q7: rad;
        }
    }
}

fn main() {}
