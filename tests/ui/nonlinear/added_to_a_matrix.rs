carvallo::model! {
    pub model Disc {
        parameters {
            r: m, > 0;
            m: kg, > 0;
            g: N/kg, >= 0, gravity;
            d: N*m*s;
        }
        mechanism {
            wheel D: mass m, at (0, 0, -r), radius r, axial m*r^2/2, radial m*r^2/4;
            free D: lean phi, yaw psi;
        }
        nonlinear;
        add C0 = [[d, 0], [0, 0]];
        coordinates { phi: rad; psi: rad; }
    }
}

fn main() {}
