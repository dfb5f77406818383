carvallo::model! {
    /// A bicycle that is steered at the rear: a Whipple bicycle run backwards, with its geometry mirrored.
    ///
    /// Four rigid bodies (front wheel F, main frame with a rigid rider B, steered frame H, steered rear wheel R),
    /// laterally symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the front
    /// contact point, x forward, y to the right, z down. Lengths along x are counted backward from the front contact, so
    /// that the parameters of a bicycle are those of the same bicycle run backwards.
    pub model RearSteered {
        source "Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3";

        parameters {
            /// Wheel base.
            w: m, > 0, along x;
            /// Distance by which the steer axis meets the ground behind the contact of the steered wheel.
            c: m, along x;
            /// Steer axis tilt: from the ground upward the axis leans forward by this angle.
            lam "λ": rad, in (-pi/2, pi/2), about y;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;

            /// Radius of the front wheel.
            rR: m, > 0, along z;
            /// Mass of the front wheel.
            mR: kg, >= 0;
            /// Radial moment of inertia of the front wheel; by symmetry also about the vertical.
            IRxx: kg*m^2, >= 0;
            /// Axial moment of inertia of the front wheel.
            IRyy: kg*m^2, >= 0;

            /// Centre of mass of the main frame and rider, behind the front contact.
            xB: m, along x;
            /// Centre of mass of the main frame and rider, downward.
            zB: m, along z;
            /// Mass of the main frame and rider.
            mB: kg, >= 0;
            /// Moment of inertia of the main frame and rider about its centre of mass, in roll.
            IBxx: kg*m^2, >= 0;
            /// Moment of inertia of the main frame and rider about its centre of mass, in pitch.
            IByy: kg*m^2, >= 0, unused;
            /// Moment of inertia of the main frame and rider about its centre of mass, in yaw.
            IBzz: kg*m^2, >= 0;
            /// Product of inertia of the main frame and rider about its centre of mass.
            IBxz: kg*m^2, along x*z;

            /// Centre of mass of the steered frame, behind the front contact.
            xH: m, along x;
            /// Centre of mass of the steered frame, downward.
            zH: m, along z;
            /// Mass of the steered frame.
            mH: kg, >= 0;
            /// Moment of inertia of the steered frame about its centre of mass, in roll.
            IHxx: kg*m^2, >= 0;
            /// Moment of inertia of the steered frame about its centre of mass, in pitch.
            IHyy: kg*m^2, >= 0, unused;
            /// Moment of inertia of the steered frame about its centre of mass, in yaw.
            IHzz: kg*m^2, >= 0;
            /// Product of inertia of the steered frame about its centre of mass.
            IHxz: kg*m^2, along x*z;

            /// Radius of the rear wheel.
            rF: m, > 0, along z;
            /// Mass of the rear wheel.
            mF: kg, >= 0;
            /// Radial moment of inertia of the rear wheel; by symmetry also about the vertical.
            IFxx: kg*m^2, >= 0;
            /// Axial moment of inertia of the rear wheel.
            IFyy: kg*m^2, >= 0;
        }

        mechanism {
            body B "main frame and rider": mass mB, at (-xB, 0, zB), inertia [[IBxx, 0, -IBxz], [0, IByy, 0], [-IBxz, 0, IBzz]];
            body H "steered frame": mass mH, at (-xH, 0, zH), inertia [[IHxx, 0, -IHxz], [0, IHyy, 0], [-IHxz, 0, IHzz]];
            wheel F "front wheel" on B: mass mR, at (0, 0, -rR), radius rR, axial IRyy, radial IRxx;
            wheel R "rear wheel" on H: mass mF, at (-w, 0, -rF), radius rF, axial IFyy, radial IFxx;

            free B: lean phi;
            revolute delta: B to H, through (-w - c, 0, 0), along (-sin(lam), 0, cos(lam));

            force Tphi "lean torque" on phi;
            force Tdelta "steer torque" on delta;
        }

        derivatives;

        coordinates {
            /// Lean of the main frame, positive to the right.
            phi "lean": rad;
            /// Steer of the steered frame relative to the main frame, positive to the right seen from above.
            delta "steer": rad;
        }

        set backwards "The benchmark of Meijaard et al. (2007), Table 1, run backwards" {
            w = 1.02; c = 0.08; lam = pi/10; g = 9.81;
            rR = 0.3; mR = 2; IRxx = 0.0603; IRyy = 0.12;
            xB = 0.3; zB = -0.9; mB = 85; IBxx = 9.2; IByy = 11; IBzz = 2.8; IBxz = 2.4;
            xH = 0.9; zH = -0.7; mH = 4; IHxx = 0.05892; IHyy = 0.06; IHzz = 0.00708; IHxz = -0.00756;
            rF = 0.35; mF = 3; IFxx = 0.1405; IFyy = 0.28;
        }
    }
}
