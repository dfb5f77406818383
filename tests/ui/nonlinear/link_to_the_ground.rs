carvallo::model! {
    pub model Disc {
        parameters {
            r: m, > 0;
            m: kg, > 0;
            g: N/kg, >= 0, gravity;
            k: N/m, >= 0;
        }
        mechanism {
            body B: mass m, at (0, 0, -r), inertia 0;
            wheel D on B: mass m, at (0, 0, -r), radius r, axial m*r^2/2, radial m*r^2/4;
            free B: lean phi, yaw psi, pitch theta;
            link S: B to ground, from (0, 0, -r), to (r, 0, 0), spring k;
        }
        nonlinear;
        coordinates { phi: rad; psi: rad; theta: rad; }
    }
}

fn main() {}
