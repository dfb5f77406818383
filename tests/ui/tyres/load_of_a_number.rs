carvallo::model! {
    pub model Car {
        parameters {
            m: kg, > 0;
            I: kg*m^2, > 0;
            a: m, > 0;
            s: m, > 0;
            c: 1, > 0;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B: mass m, at (0, 0, -a), inertia [I, I, I];
            wheel F on B: mass 0, at (a, 0, -a), radius a, axial 0, radial 0, cornering c*load(2);
            wheel L on B: mass 0, at (-a, -s, -a), radius a, axial 0, radial 0, cornering c*load(L);
            wheel R on B: mass 0, at (-a, s, -a), radius a, axial 0, radial 0, cornering c*load(R);
            free B: lateral y, yaw psi;
        }

        coordinates {
            y: m; psi: rad;
        }
    }
}

fn main() {}
