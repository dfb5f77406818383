carvallo::model! {
    pub model Bicycle {
        parameters {
            w: m, > 0, along x;
            c: m, along x;
            r: m, > 0, along z;
            mB: kg, > 0;
            xB: m, along x;
            zB: m, < 0, along z;
            mH: kg, > 0;
            xH: m, along x;
            zH: m, < 0, along z;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "rear frame": mass mB, at (xB, 0, zB), inertia 0;
            body H "front frame": mass mH, at (xH, 0, zH), inertia 0;
            wheel R "rear wheel" on B: mass 0, at (0, 0, -r), radius r, axial 0, radial 0;
            wheel F "front wheel" on H: mass 0, at (w, 0, -r), radius r, axial 0, radial 0;
            free B: lean phi;
            revolute delta: B to H, through (w + c, 0, 0), along (0, 0, 1);
            body U "rider": mass mH, at (xH, 0, zH), inertia 0;
            prismatic x: B to U, along (1, 0, 0);
        }

        coordinates {
            phi "lean": rad;
            delta "steer": rad;
            x: m;
        }

        set example {
            w = 1;
            c = 0.1;
            r = 0.3;
            mB = 80;
            xB = 0.4;
            zB = -1;
            mH = 5;
            xH = 0.9;
            zH = -0.7;
            g = 9.81;
        }
    }
}

fn main() {}
