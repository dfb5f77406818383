carvallo::model! {
    /// A skateboard with a rider who stands still on it: one degree of freedom, the tilt of the board.
    ///
    /// Each truck turns about its king pin, which passes through the middle of its axle, with a wheel at either end. All
    /// four wheels stay on the ground and do not slip, so that tilting steers both axles. Trucks and wheels have no mass;
    /// board and rider are one rigid body. Axes: origin on the ground below the rear axle, x forward, y to the right, z
    /// down.
    pub model Skateboard {
        source "Mechanism: Hubbard (1979), J. Appl. Mech. 46, 931-936; Kremnev & Kuleshov (2010), DCDS-S 3, 85-103";

        parameters {
            /// Wheel base, from axle to axle.
            L: m, > 0, along x;
            /// Half of the track, from the middle of an axle to a wheel.
            b: m, > 0, along y;
            /// Radius of the wheels.
            r: m, > 0, along z;
            /// Angle of the front king pin above the horizontal, rising forward.
            lamF "λF": rad, in (0, pi/2), about y;
            /// Angle of the rear king pin above the horizontal, rising backward.
            lamR "λR": rad, in (0, pi/2), about y;
            /// Stiffness of the front truck about its king pin.
            kF: N*m, >= 0;
            /// Stiffness of the rear truck about its king pin.
            kR: N*m, >= 0;
            /// Mass of board and rider.
            m: kg, > 0;
            /// Centre of mass, forward of the rear axle.
            x: m, along x;
            /// Centre of mass, above the axles.
            h: m, along z;
            /// Moment of inertia of board and rider about their centre of mass, in roll.
            Ixx: kg*m^2, >= 0;
            /// Moment of inertia of board and rider about their centre of mass, in pitch.
            Iyy: kg*m^2, >= 0, unused;
            /// Moment of inertia of board and rider about their centre of mass, in yaw.
            Izz: kg*m^2, >= 0, unused;
            /// Product of inertia of board and rider about their centre of mass.
            Ixz: kg*m^2, along x*z;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "board and rider": mass m, at (x, 0, -r - h), inertia [[Ixx, 0, Ixz], [0, Iyy, 0], [Ixz, 0, Izz]];
            body TF "front truck": massless;
            body TR "rear truck": massless;
            wheel FL "front left" on TF: mass 0, at (L, -b, -r), radius r, axial 0, radial 0;
            wheel FR "front right" on TF: mass 0, at (L, b, -r), radius r, axial 0, radial 0;
            wheel RL "rear left" on TR: mass 0, at (0, -b, -r), radius r, axial 0, radial 0;
            wheel RR "rear right" on TR: mass 0, at (0, b, -r), radius r, axial 0, radial 0;

            free B: lean gamma;
            revolute deltaF: B to TF, through (L, 0, -r), along (cos(lamF), 0, -sin(lamF)), spring kF;
            revolute deltaR: B to TR, through (0, 0, -r), along (cos(lamR), 0, sin(lamR)), spring kR;

            force T "tilt torque" on gamma;
        }

        derivatives;

        coordinates {
            /// Tilt of the board, to the right.
            gamma "tilt": rad;
        }

        set example "An adult on a board; the figures are an example" {
            L = 0.8; b = 0.1; r = 0.03; lamF = 45 deg; lamR = 45 deg; kF = 50; kR = 50;
            m = 75; x = 0.42; h = 0.9; Ixx = 9; Iyy = 9; Izz = 1; Ixz = 0; g = 9.81;
        }
    }
}
