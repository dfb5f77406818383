carvallo::model! {
    pub model Cart {
        parameters {
            l: m, > 0;
            m: kg, > 0;
            h: m, > 0;
            r: m, > 0;
            b: m, > 0;
            I: kg*m^2, > 0;
            k: N*m, >= 0;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "cart": mass m, at (l, 0, -r), inertia [I, I, I];
            body P "pole": mass m, at (l, 0, -h), inertia 0;
            wheel L on B: mass 0, at (l, -b, -r), radius r, axial 0, radial 0;
            wheel R on B: mass 0, at (sqrt(l^2), b, -r), radius r, axial 0, radial 0;
            free B: yaw psi, pitch theta;
            revolute phi: B to P, through (l, 0, -r), along (1, 0, 0), spring k;
        }

        coordinates {
            phi: rad;
            theta: rad;
        }
    }
}

fn main() {}
