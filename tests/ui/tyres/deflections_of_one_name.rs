carvallo::model! {
    pub model Bicycle {
        parameters {
            w: m, > 0;
            h: m, > 0;
            r: m, > 0;
            m: kg, > 0;
            I: kg*m^2, > 0;
            C: N, > 0;
            s: m, > 0;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B: mass m, at (w/2, 0, -h), inertia [I, I, I];
            wheel R on B: mass 0, at (0, 0, -r), radius r, axial I, radial 0, cornering C, relaxation s, deflection e;
            wheel F on B: mass 0, at (w, 0, -r), radius r, axial I, radial 0, cornering C, relaxation s, deflection e;
            free B: lateral y, yaw psi, lean phi;
        }

        coordinates {
            y: m; psi: rad; phi: rad; e: m; f: m;
        }
    }
}

fn main() {}
