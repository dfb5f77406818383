carvallo::model! {
    pub model Unicycle {
        parameters {
            r: m, > 0, along z;
            m: kg, > 0;
            k: N/m, > 0;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "frame": mass m, at (0, 0, -r), inertia [m*r^2, m*r^2, m*r^2];
            body H "hub": massless;
            wheel W "wheel" on H: mass m, at (0, 0, -r), radius r, axial m*r^2, radial m*r^2;
            prismatic s: B to H, along (0, 0, 1), spring k;
            free B: vertical z, yaw psi, lean phi, pitch theta;
        }

        coordinates {
            z: m;
            psi: rad;
            phi: rad;
            theta: rad;
        }
    }
}

fn main() {}
