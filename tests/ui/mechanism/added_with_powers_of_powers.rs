carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0, along z;
            d: N*m*s, >= 0;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body A "upper bob": mass m, at (0, 0, l), inertia 0;
            body B "lower bob": mass m, at (0, 0, 2*l), inertia 0;
            revolute alpha: ground to A, through (0, 0, 0), along (1, 0, 0);
            revolute beta: A to B, through (0, 0, l), along (1, 0, 0);
        }

        coordinates {
            alpha: rad;
            beta: rad;
        }

        add C0 = [[0, 0], [0, d*(((1 + d/(d + 1 [N*m*s]))^16)^16)^4]];
    }
}

fn main() {}
