carvallo::model! {
    pub model Bicycle {
        parameters {
            d: N*m*s, >= 0;
            w: m, > 0, along x;
            c: m, along x;
            r: m, > 0, along z;
            mB: kg, > 0;
            xB: m, along x;
            zB: m, < 0, along z;
        }

        mechanism {
            body B "rear frame": mass mB, at (xB, 0, zB), inertia 0;
            body H "front frame": massless;
            wheel R "rear wheel" on B: mass 0, at (0, 0, -r), radius r, axial 0, radial 0;
            wheel F "front wheel" on H: mass 0, at (w, 0, -r), radius r, axial 0, radial 0;
            free B: lean phi, yaw psi;
            revolute delta: B to H, through (w + c, 0, 0), along (0, 0, 1), damper d;
        }

        coordinates {
            phi "lean": rad;
            psi "yaw": rad;
        }

        set example {
            d = 1;
            w = 1;
            c = 0.1;
            r = 0.3;
            mB = 80;
            xB = 0.4;
            zB = -1;
        }
    }
}

fn main() {}
