carvallo::model! {
    /// A motorcycle on tyres that slip, whose side forces follow slip and camber over a length: two bodies, of which the front
    /// one steers, with wheels in their masses.
    ///
    /// Axes: origin on the ground below the centre of mass of the rear part, x forward, y to the right, z down. The steering takes
    /// the load of the front wheel that is given with the parameters, `Zf`, and not the one that follows from the masses.
    pub model Motorcycle {
        source "Sharp (1971), The stability and control of motorcycles, J. Mech. Eng. Sci. 13, 316-329";

        parameters {
            /// Mass of the front part, with its wheel.
            Mf: kg, > 0;
            /// Mass of the rear part, with its wheel and the rider.
            Mr: kg, > 0;
            /// Moment of inertia of the rear part about a longitudinal axis, at its centre of mass.
            Irx: kg*m^2, >= 0;
            /// Moment of inertia of the rear part about a vertical axis.
            Irz: kg*m^2, >= 0;
            /// Product of inertia of the rear part: what the product of lean and yaw rates is multiplied by in the kinetic
            /// energy, with the opposite sign.
            Crxz: kg*m^2;
            /// Moment of inertia of the front part about an axis perpendicular to the steer axis, forward.
            Ifx: kg*m^2, >= 0;
            /// Moment of inertia of the front part about an axis along the steer axis.
            Ifz: kg*m^2, >= 0;
            /// Moment of inertia of the front wheel about its axle.
            ify: kg*m^2, >= 0;
            /// Moment of inertia of the rear wheel about its axle, with that of the engine as it is geared.
            iry: kg*m^2, >= 0;
            /// Distance of the origin from the steer axis.
            a: m, > 0;
            /// Distance of the rear contact point behind the origin.
            b: m, > 0;
            /// Distance of the centre of mass of the front part ahead of the steer axis.
            e: m;
            /// Height of the centre of mass of the front part, along the steer axis, over the foot of the perpendicular from
            /// the origin.
            f: m;
            /// Height of the centre of mass of the rear part.
            h: m, > 0;
            /// Radius of the front wheel.
            Rf: m, > 0;
            /// Radius of the rear wheel.
            Rr: m, > 0;
            /// Distance of the front contact point behind the steer axis.
            t: m;
            /// Tilt of the steer axis from the vertical.
            eps "ε": rad, in (-90 deg, 90 deg);
            /// Cornering stiffness of the front tyre.
            Cf1: N, > 0;
            /// Camber stiffness of the front tyre.
            Cf2: N, >= 0;
            /// Cornering stiffness of the rear tyre.
            Cr1: N, > 0;
            /// Camber stiffness of the rear tyre.
            Cr2: N, >= 0;
            /// Damping of the steering.
            K: N*m*s, >= 0;
            /// Relaxation length of both tyres.
            sigma "σ": m, > 0;
            /// Load of the front wheel.
            Zf: N, >= 0;
            /// Gravitational field strength.
            g: N/kg, > 0, gravity;
        }

        let s = sin(eps);
        let c = cos(eps);
        let l = (a - t)/c;
        let k = (a + e)*c - f*s;
        let j = (a + e)*s + f*c;
        let load = (b*(Mf + Mr) + k*Mf)/(b + l);
        let rest = load - Zf/g;

        require b + l > 0;

        mechanism {
            body rear "rear part": mass Mr, at (0, 0, -h), inertia [[Irx, 0, -Crxz], [0, 0, 0], [-Crxz, 0, Irz]];
            body front "front part": mass Mf, at (k, 0, -j), inertia [
                [Ifx*c^2 + Ifz*s^2, 0, (Ifz - Ifx)*s*c],
                [0, 0, 0],
                [(Ifz - Ifx)*s*c, 0, Ifx*s^2 + Ifz*c^2],
            ];
            wheel R "rear wheel" on rear: mass 0, at (-b, 0, -Rr), radius Rr, axial iry, radial 0,
                cornering Cr1, camber Cr2, relaxation sigma, deflection er;
            wheel F "front wheel" on front: mass 0, at (l, 0, -Rf), radius Rf, axial ify, radial 0,
                cornering Cf1, camber Cf2, relaxation sigma, deflection ef;

            free rear: lateral y, yaw psi, lean phi;
            revolute delta: rear to front, through (a/c, 0, 0), along (s, 0, c), damper K;

            force Tdelta "steer torque" on delta;
        }

        derivatives;

        coordinates {
            /// Lateral motion of the origin, to the right; its rate is along the axes of the machine.
            y "lateral": m;
            /// Yaw, to the right.
            psi "yaw": rad;
            /// Lean to the right.
            phi "lean": rad;
            /// Steer angle of the front part, to the right.
            delta "steer": rad;
            /// Deflection of the rear tyre.
            er "rear tyre": m;
            /// Deflection of the front tyre.
            ef "front tyre": m;
        }

        // The load that is given takes the place of the one that follows from the masses.
        add symmetric K0 = [
            [0, 0, 0, 0, 0, 0],
            [0, 0, 0, 0, 0, 0],
            [0, 0, 0, rest*t, 0, 0],
            [0, 0, rest*t, rest*t*s, 0, 0],
            [0, 0, 0, 0, 0, 0],
            [0, 0, 0, 0, 0, 0],
        ];

        set standard "Sharp (1971), case 1: in slug, ft and lb, made SI by 14.5939 kg and 0.3048 m" {
            Mf = 2.1*14.5939; Mr = 14.9*14.5939;
            Irx = 23*14.5939*0.3048^2; Irz = 15.54*14.5939*0.3048^2; Crxz = 1.28*14.5939*0.3048^2;
            Ifx = 0.91*14.5939*0.3048^2; Ifz = 0.326*14.5939*0.3048^2;
            ify = 0.53*14.5939*0.3048^2; iry = 0.775*14.5939*0.3048^2;
            a = 3.112*0.3048; b = 1.574*0.3048; e = 0.08*0.3048; f = 0.093*0.3048; h = 2.02*0.3048;
            Rf = 0.3048; Rr = 0.3048; t = 0.38*0.3048; eps = 0.4715;
            Cf1 = 2512*14.5939*0.3048; Cf2 = 211*14.5939*0.3048; Cr1 = 3559*14.5939*0.3048; Cr2 = 298*14.5939*0.3048;
            K = 5*14.5939*0.3048^2; sigma = 0.8*0.3048; Zf = 226*14.5939*0.3048; g = 32.2*0.3048;
        }
    }
}
