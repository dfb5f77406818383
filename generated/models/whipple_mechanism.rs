carvallo::model! {
    /// The Whipple-Carvallo bicycle, derived from its bodies, joints and wheels.
    ///
    /// Four rigid bodies (rear wheel R, rear frame with a rigid rider B, front frame H, front wheel F), laterally
    /// symmetric, on knife-edged wheels that roll without slip on level ground. Axes: origin at the rear contact point,
    /// x forward, y to the right, z down, so that a centre of mass above the ground has z < 0.
    ///
    /// The declaration asserts that the matrices are those of Appendix A of the paper, which is proved when it is compiled.
    /// [`Whipple`](crate::Whipple) computes them from these formulas.
    pub model WhippleMechanism {
        source "Mechanism: Meijaard, Papadopoulos, Ruina & Schwab (2007), Proc. R. Soc. A 463, 1955-1982, section 3";

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
        }

        mechanism {
            body B "rear frame and rider": mass mB, at (xB, 0, zB), inertia [[IBxx, 0, IBxz], [0, IByy, 0], [IBxz, 0, IBzz]];
            body H "front frame": mass mH, at (xH, 0, zH), inertia [[IHxx, 0, IHxz], [0, IHyy, 0], [IHxz, 0, IHzz]];
            wheel R "rear wheel" on B: mass mR, at (0, 0, -rR), radius rR, axial IRyy, radial IRxx;
            wheel F "front wheel" on H: mass mF, at (w, 0, -rF), radius rF, axial IFyy, radial IFxx;

            free B: lean phi;
            revolute delta: B to H, through (w + c, 0, 0), along (sin(lam), 0, cos(lam));

            force Tphi "lean torque" on phi;
            force Tdelta "steer torque" on delta;
        }

        // Appendix A of the paper, to be compared with. The whole bicycle, about the rear contact point.
        let mT = mR + mB + mH + mF;
        let xT = (xB*mB + xH*mH + w*mF) / mT;
        let zT = (-rR*mR + zB*mB + zH*mH - rF*mF) / mT;
        let ITxx = IRxx + IBxx + IHxx + IFxx + mR*rR^2 + mB*zB^2 + mH*zH^2 + mF*rF^2;
        let ITxz = IBxz + IHxz - mB*xB*zB - mH*xH*zH + mF*w*rF;
        let ITzz = IRxx + IBzz + IHzz + IFxx + mB*xB^2 + mH*xH^2 + mF*w^2;

        // The front assembly A, about its centre of mass.
        let mA = mH + mF;
        let xA = (xH*mH + w*mF) / mA;
        let zA = (zH*mH - rF*mF) / mA;
        let IAxx = IHxx + IFxx + mH*(zH - zA)^2 + mF*(rF + zA)^2;
        let IAxz = IHxz - mH*(xH - xA)*(zH - zA) + mF*(w - xA)*(rF + zA);
        let IAzz = IHzz + IFxx + mH*(xH - xA)^2 + mF*(w - xA)^2;
        // Its centre of mass forward of the steer axis, and its inertia about that axis.
        let uA = (xA - w - c)*cos(lam) - zA*sin(lam);
        let IAll = mA*uA^2 + IAxx*sin(lam)^2 + 2*IAxz*sin(lam)*cos(lam) + IAzz*cos(lam)^2;
        let IAlx = -mA*uA*zA + IAxx*sin(lam) + IAxz*cos(lam);
        let IAlz = mA*uA*xA + IAxz*sin(lam) + IAzz*cos(lam);

        // Ratio of trail to wheel base, spin momenta of the wheels divided by the speed, a static moment.
        let mu = (c/w)*cos(lam);
        let SR = IRyy/rR;
        let SF = IFyy/rF;
        let ST = SR + SF;
        let SA = mA*uA + mu*mT*xT;

        derivatives;
        nonlinear;

        coordinates {
            /// Lean of the rear frame, positive to the right.
            phi "lean": rad;
            /// Steer of the front frame relative to the rear frame, positive to the right.
            delta "steer": rad;
        }

        assert M == [
            [ITxx, IAlx + mu*ITxz],
            [IAlx + mu*ITxz, IAll + 2*mu*IAlz + mu^2*ITzz],
        ];
        assert C1 == [
            [0, mu*ST + SF*cos(lam) + (ITxz/w)*cos(lam) - mu*mT*zT],
            [-(mu*ST + SF*cos(lam)), (IAlz/w)*cos(lam) + mu*(SA + (ITzz/w)*cos(lam))],
        ];
        assert K0 == [
            [mT*zT, -SA],
            [-SA, -SA*sin(lam)],
        ];
        assert K2 == [
            [0, ((ST - mT*zT)/w)*cos(lam)],
            [0, ((SA + SF*sin(lam))/w)*cos(lam)],
        ];

        #[default]
        set benchmark "Meijaard, Papadopoulos, Ruina & Schwab (2007), Table 1" {
            w = 1.02; c = 0.08; lam = pi/10; g = 9.81;
            rR = 0.3; mR = 2; IRxx = 0.0603; IRyy = 0.12;
            xB = 0.3; zB = -0.9; mB = 85; IBxx = 9.2; IByy = 11; IBzz = 2.8; IBxz = 2.4;
            xH = 0.9; zH = -0.7; mH = 4; IHxx = 0.05892; IHyy = 0.06; IHzz = 0.00708; IHxz = -0.00756;
            rF = 0.35; mF = 3; IFxx = 0.1405; IFyy = 0.28;

            // As they are printed: the formulas must give every digit.
            M = [[80.81722, 2.31941332208709], [2.31941332208709, 0.29784188199686]];
            C1 = [[0, 33.86641391492494], [-0.85035641456978, 1.68540397397560]];
            K0 = [[-80.95, -2.59951685249872], [-2.59951685249872, -0.80329488458618]];
            K2 = [[0, 76.59734589573222], [0, 2.65431523794604]];
        }

        set benchmark_2005 "Schwab, Meijaard & Papadopoulos (2005), ENOC 2005" {
            w = 1.02; c = 0.08; lam = atan(1/3); g = 9.81;
            rR = 0.3; mR = 2; IRxx = 0.06; IRyy = 0.12;
            xB = 0.3; zB = -0.9; mB = 85; IBxx = 9.2; IByy = 11; IBzz = 2.8; IBxz = 2.4;
            xH = 0.9; zH = -0.7; mH = 4; IHxx = 0.0546; IHyy = 0.06; IHzz = 0.0114; IHxz = -0.0162;
            rF = 0.35; mF = 3; IFxx = 0.14; IFyy = 0.28;

            // Printed with gravity in it, K0 is not among them.
            M = [[80.8121, 2.32343142623549], [2.32343142623549, 0.30126570934256]];
            C1 = [[0, 33.77386947593010], [-0.84823447825693, 1.70696539792387]];
            K2 = [[0, 76.40620875965657], [0, 2.67560553633218]];
        }

        /// A bicycle that balances itself without gyroscopic effects and without trail: two points of mass on skates.
        set two_mass_skate "Kooijman, Meijaard, Papadopoulos, Ruina & Schwab (2011), Science 332, 339-342" {
            w = 1; c = 0; lam = 5 deg; g = 9.81;
            rR = 0.1; mR = 0; IRxx = 0; IRyy = 0;
            xB = 1.2; zB = -0.4; mB = 10; IBxx = 0; IByy = 0; IBzz = 0; IBxz = 0;
            xH = 1.02; zH = -0.2; mH = 1; IHxx = 0; IHyy = 0; IHzz = 0; IHxz = 0;
            rF = 0.1; mF = 0; IFxx = 0; IFyy = 0;
        }
    }
}
