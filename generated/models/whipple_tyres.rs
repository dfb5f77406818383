carvallo::model! {
    /// The Whipple-Carvallo bicycle on tyres whose cross-sections are circles.
    ///
    /// Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
    /// symmetric. The rims of the wheels are parts of tori that roll without slip on level ground: the radii rR and rF of
    /// the wheels reach from the centre to the ground, and those of the cross-sections, rhoR and rhoF, are parts of them.
    /// Axes: origin at the rear contact point, x forward, y to the right, z down.
    pub model WhippleTyres {
        source "Mechanism: a bicycle on tyres with circular cross-sections, as in Meijaard & Schwab (2006), Linearized equations for an extended bicycle model, III European Conference on Computational Mechanics";

        parameters {
            /// Wheel base.
            w: m, > 0, along x;
            /// Trail: positive when the front contact is behind the point where the steer axis meets the ground.
            c: m, along x;
            /// Steer axis tilt: 90 degrees minus the head angle.
            lam "λ": rad, in (-pi/2, pi/2), about y;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;

            /// Radius of the rear wheel.
            rR: m, > 0, along z;
            /// Mass of the rear wheel.
            mR: kg, >= 0;
            /// Radial moment of inertia of the rear wheel; by symmetry also about the vertical.
            IRxx: kg*m^2, >= 0;
            /// Axial moment of inertia of the rear wheel.
            IRyy: kg*m^2, >= 0;

            /// Centre of mass of the rear frame and rider, forward of the rear contact.
            xB: m, along x;
            /// Centre of mass of the rear frame and rider, downward.
            zB: m, along z;
            /// Mass of the rear frame and rider.
            mB: kg, >= 0;
            /// Moment of inertia of the rear frame and rider about its centre of mass, in roll.
            IBxx: kg*m^2, >= 0;
            /// Moment of inertia of the rear frame and rider about its centre of mass, in pitch.
            IByy: kg*m^2, >= 0, unused;
            /// Moment of inertia of the rear frame and rider about its centre of mass, in yaw.
            IBzz: kg*m^2, >= 0;
            /// Product of inertia of the rear frame and rider about its centre of mass.
            IBxz: kg*m^2, along x*z;

            /// Centre of mass of the front frame, forward of the rear contact.
            xH: m, along x;
            /// Centre of mass of the front frame, downward.
            zH: m, along z;
            /// Mass of the front frame.
            mH: kg, >= 0;
            /// Moment of inertia of the front frame about its centre of mass, in roll.
            IHxx: kg*m^2, >= 0;
            /// Moment of inertia of the front frame about its centre of mass, in pitch.
            IHyy: kg*m^2, >= 0, unused;
            /// Moment of inertia of the front frame about its centre of mass, in yaw.
            IHzz: kg*m^2, >= 0;
            /// Product of inertia of the front frame about its centre of mass.
            IHxz: kg*m^2, along x*z;

            /// Radius of the front wheel.
            rF: m, > 0, along z;
            /// Mass of the front wheel.
            mF: kg, >= 0;
            /// Radial moment of inertia of the front wheel; by symmetry also about the vertical.
            IFxx: kg*m^2, >= 0;
            /// Axial moment of inertia of the front wheel.
            IFyy: kg*m^2, >= 0;

            /// Radius of the cross-section of the rear tyre.
            rhoR: m, >= 0;
            /// Radius of the cross-section of the front tyre.
            rhoF: m, >= 0;
        }

        mechanism {
            body B "rear frame and rider": mass mB, at (xB, 0, zB), inertia [[IBxx, 0, IBxz], [0, IByy, 0], [IBxz, 0, IBzz]];
            body H "front frame": mass mH, at (xH, 0, zH), inertia [[IHxx, 0, IHxz], [0, IHyy, 0], [IHxz, 0, IHzz]];
            wheel R "rear wheel" on B: mass mR, at (0, 0, -rR), radius rR, tyre rhoR, axial IRyy, radial IRxx;
            wheel F "front wheel" on H: mass mF, at (w, 0, -rF), radius rF, tyre rhoF, axial IFyy, radial IFxx;

            free B: lean phi;
            revolute delta: B to H, through (w + c, 0, 0), along (sin(lam), 0, cos(lam));

            force Tphi "lean torque" on phi;
            force Tdelta "steer torque" on delta;
        }

        derivatives;
        nonlinear;

        coordinates {
            /// Lean of the rear frame, positive to the right.
            phi "lean": rad;
            /// Steer of the front frame relative to the rear frame, positive to the right.
            delta "steer": rad;
        }

        #[default]
        set benchmark "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1; tyres are examples" {
            w = 1.02; c = 0.08; lam = pi/10; g = 9.81;
            rR = 0.3; mR = 2; IRxx = 0.0603; IRyy = 0.12;
            xB = 0.3; zB = -0.9; mB = 85; IBxx = 9.2; IByy = 11; IBzz = 2.8; IBxz = 2.4;
            xH = 0.9; zH = -0.7; mH = 4; IHxx = 0.05892; IHyy = 0.06; IHzz = 0.00708; IHxz = -0.00756;
            rF = 0.35; mF = 3; IFxx = 0.1405; IFyy = 0.28; rhoR = 0.02; rhoF = 0.02;
        }

        set benchmark_2005 "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005; tyres are examples" {
            w = 1.02; c = 0.08; lam = atan(1/3); g = 9.81;
            rR = 0.3; mR = 2; IRxx = 0.06; IRyy = 0.12;
            xB = 0.3; zB = -0.9; mB = 85; IBxx = 9.2; IByy = 11; IBzz = 2.8; IBxz = 2.4;
            xH = 0.9; zH = -0.7; mH = 4; IHxx = 0.0546; IHyy = 0.06; IHzz = 0.0114; IHxz = -0.0162;
            rF = 0.35; mF = 3; IFxx = 0.14; IFyy = 0.28; rhoR = 0.02; rhoF = 0.02;
        }
    }
}
