carvallo::model! {
    pub model Car {
        parameters {
            r: m, > 0;
            m: kg, > 0;
            g: N/kg, >= 0, gravity;
            C: N, > 0;
        }
        mechanism {
            body B: mass m, at (0, 0, -r), inertia [m*r^2, m*r^2, m*r^2];
            wheel F on B: mass 0, at (r, 0, -r), radius r, axial 0, radial 0, cornering C;
            wheel L on B: mass 0, at (-r, -r, -r), radius r, axial 0, radial 0, cornering C;
            wheel R on B: mass 0, at (-r, r, -r), radius r, axial 0, radial 0, cornering C;
            free B: lateral y, yaw psi;
        }
        nonlinear;
        coordinates { y: m; psi: rad; }
    }
}

fn main() {}
