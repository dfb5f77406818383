carvallo::model! {
    /// The Whipple-Carvallo bicycle with a rider whose upper body leans on a sprung and damped hip.
    ///
    /// Five rigid bodies (rear wheel R, rear frame with the rider's legs B, upper body U, front frame H, front wheel F),
    /// laterally symmetric, on knife-edged wheels that roll without slip on level ground. The hip axis lies along x. Axes:
    /// origin at the rear contact point, x forward, y to the right, z down.
    pub model WhippleLeaning {
        source "Mechanism: Moore (2012), Human Control of a Bicycle, dissertation, University of California, Davis, leaning rider";

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

            /// Height of the rider's hip axis, downward from the ground, so negative.
            zP: m, along z;
            /// Mass of the rider's upper body.
            mU: kg, >= 0;
            /// Centre of mass of the upper body, forward of the rear contact.
            xU: m, along x;
            /// Centre of mass of the upper body, downward.
            zU: m, along z;
            /// Moment of inertia of the upper body about its centre of mass, in roll.
            IUxx: kg*m^2, >= 0;
            /// Moment of inertia of the upper body about its centre of mass, in pitch.
            IUyy: kg*m^2, >= 0, unused;
            /// Moment of inertia of the upper body about its centre of mass, in yaw.
            IUzz: kg*m^2, >= 0;
            /// Product of inertia of the upper body about its centre of mass.
            IUxz: kg*m^2, along x*z;
            /// Stiffness of the hip.
            kU: N*m, >= 0;
            /// Damping of the hip.
            dU: N*m*s, >= 0;
        }

        mechanism {
            body B "rear frame and legs": mass mB, at (xB, 0, zB), inertia [[IBxx, 0, IBxz], [0, IByy, 0], [IBxz, 0, IBzz]];
            body H "front frame": mass mH, at (xH, 0, zH), inertia [[IHxx, 0, IHxz], [0, IHyy, 0], [IHxz, 0, IHzz]];
            body U "upper body": mass mU, at (xU, 0, zU), inertia [[IUxx, 0, IUxz], [0, IUyy, 0], [IUxz, 0, IUzz]];
            wheel R "rear wheel" on B: mass mR, at (0, 0, -rR), radius rR, axial IRyy, radial IRxx;
            wheel F "front wheel" on H: mass mF, at (w, 0, -rF), radius rF, axial IFyy, radial IFxx;

            free B: lean phi;
            revolute delta: B to H, through (w + c, 0, 0), along (sin(lam), 0, cos(lam));
            revolute theta: B to U, through (0, 0, zP), along (1, 0, 0), spring kU, damper dU;

            force Tphi "lean torque" on phi;
            force Tdelta "steer torque" on delta;
            force Ttheta "hip torque" on theta;
        }

        derivatives;
        nonlinear;

        coordinates {
            /// Lean of the rear frame, positive to the right.
            phi "lean": rad;
            /// Steer of the front frame relative to the rear frame, positive to the right.
            delta "steer": rad;
            /// Lean of the upper body relative to the rear frame, positive to the right.
            theta "upper body": rad;
        }

        set example "The benchmark of Meijaard et al. (2007), Table 1, with 40 kg of rear frame and rider as an upper body" {
            w = 1.02; c = 0.08; lam = pi/10; g = 9.81;
            rR = 0.3; mR = 2; IRxx = 0.0603; IRyy = 0.12;
            xB = 0.3; zB = -0.7; mB = 45; IBxx = 4.0; IByy = 5.5; IBzz = 1.8; IBxz = 1.2;
            xH = 0.9; zH = -0.7; mH = 4; IHxx = 0.05892; IHyy = 0.06; IHzz = 0.00708; IHxz = -0.00756;
            rF = 0.35; mF = 3; IFxx = 0.1405; IFyy = 0.28;
            zP = -0.85; mU = 40; xU = 0.3; zU = -1.125; IUxx = 1.6; IUyy = 1.6; IUzz = 0.6; IUxz = 0;
            kU = 600; dU = 60;
        }
    }
}
