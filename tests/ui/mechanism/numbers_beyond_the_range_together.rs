carvallo::model! {
    model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0;
            g: N/kg, >= 0, gravity;
        }
        mechanism {
            body B: mass 1e200*m, at (0, 0, -1e200*l), inertia 0;
            revolute q: ground to B, through (0, 0, 0), along (1, 0, 0);
        }
        coordinates { q: rad; }
    }
}

fn main() {}
