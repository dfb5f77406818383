carvallo::model! {
    pub model Bicycle {
        parameters {
            d: N*m*s, >= 0;
            w: m, > 0, along x;
            c: m, along x;
            r: m, > 0, along z;
            mB: kg, > 0;
            zB: m, < 0, along z;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "rear frame": mass mB, at (0, 0, zB), inertia [1 [kg*m^2], 0, 1 [kg*m^2]];
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
            zB = -1;
            g = 9.81;
        }
    }
}

fn main() {}
