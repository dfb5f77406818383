carvallo::model! {
    pub model Bicycle {
        parameters {
            w: m, > 0;
            c: m;
            h: m, > 0;
            r: m, > 0;
            m: kg, > 0;
            I: kg*m^2, > 0;
            k: N*m*s;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B: mass m, at (w/3, 0, -h), inertia [I, I, I];
            body H: mass m/9, at (w, 0, -h), inertia [I/9, I/9, I/9];
            wheel R on B: mass 0, at (0, 0, -r), radius r, axial I, radial 0;
            wheel F on H: mass 0, at (w, 0, -r), radius r, axial I, radial 0;
            free B: lean phi;
            revolute delta: B to H, through (w + c, 0, 0), along (0, 0, 1);
        }

        coordinates {
            phi: rad; delta: rad;
        }

        feedback T on delta = -k*rate(R);
    }
}

fn main() {}
