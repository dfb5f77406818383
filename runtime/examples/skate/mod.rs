//! The model of some of the examples: a bicycle of two point masses that balances itself without gyroscopic effects and
//! without trail (Kooijman, Meijaard, Papadopoulos, Ruina & Schwab 2011, Science 332, 339-342).

carvallo::model! {
    /// A rear and a front frame, each a point mass, on two wheels without mass.
    pub model Skate {
        parameters {
            /// Wheel base.
            w: m, > 0, along x;
            /// Trail.
            c: m, along x;
            /// Tilt of the steer axis.
            lam: rad, in (-90 deg, 90 deg), about y;
            /// Place of the rear mass, forward of the rear contact.
            xB: m, along x;
            /// Place of the rear mass, downward.
            zB: m, < 0, along z;
            /// Rear mass.
            mB: kg, > 0;
            /// Place of the front mass, forward of the rear contact.
            xH: m, along x;
            /// Place of the front mass, downward.
            zH: m, < 0, along z;
            /// Front mass.
            mH: kg, > 0;
            /// Radius of the wheels: it makes their spins alone, since they have no mass.
            r: m, > 0, along z;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }
        mechanism {
            body B "rear frame": mass mB, at (xB, 0, zB), inertia 0;
            body H "front frame": mass mH, at (xH, 0, zH), inertia 0;
            wheel R "rear wheel" on B: mass 0, at (0, 0, -r), radius r, axial 0, radial 0;
            wheel F "front wheel" on H: mass 0, at (w, 0, -r), radius r, axial 0, radial 0;
            free B: lean phi;
            revolute delta: B to H, through (w + c, 0, 0), along (sin(lam), 0, cos(lam));
        }
        derivatives;
        coordinates { phi "lean": rad; delta "steer": rad; }
        set published {
            w = 1; c = 0; lam = 5 deg; xB = 1.2; zB = -0.4; mB = 10; xH = 1.02; zH = -0.2; mH = 1;
            r = 0.1; g = 9.81;
        }
    }
}
