carvallo::model! {
    /// A railway wheelset on its suspension, which hunts above a critical speed.
    ///
    /// Lateral displacement and yaw of a wheelset with conical wheels on straight track at the constant speed v, restrained
    /// by springs to a vehicle that does not move. Forces of creep are linear; those of gravity and of spin are left out.
    /// Axes: x forward, y to the right, z down. Forces of creep are divided by the speed, so there is no motion at rest to
    /// speak of.
    pub model Wheelset {
        source "Force balance of a wheelset on springs with linear creep, as in books on railway vehicles such as Wickens (2003), Fundamentals of Rail Vehicle Dynamics";

        parameters {
            /// Mass.
            m: kg, > 0;
            /// Moment of inertia in yaw.
            I: kg*m^2, > 0;
            /// Longitudinal creep coefficient of a wheel.
            f11: N, > 0;
            /// Lateral creep coefficient of a wheel.
            f22: N, > 0;
            /// Half of the distance of the contact points.
            b: m, > 0;
            /// Conicity of the wheels.
            lam "λ": 1, > 0;
            /// Radius of the wheels.
            r: m, > 0;
            /// Lateral stiffness of the suspension.
            ky: N/m, >= 0;
            /// Stiffness of the suspension in yaw.
            kpsi "kψ": N*m/rad, >= 0;
            /// Forward speed.
            v: m/s, speed;
        }

        derivatives;

        coordinates {
            /// Lateral displacement, positive to the right.
            y "lateral": m;
            /// Yaw, positive to the right.
            psi "yaw": rad;
        }

        symmetric M = [
            [m, 0],
            [0, I],
        ];
        C = [
            [2*f22/v, 0],
            [0, 2*f11*b^2/v],
        ];
        K = [
            [ky, -2*f22],
            [2*f11*b*lam/r, kpsi],
        ];

        set example "An example in round figures, of the size of a freight wagon's, of no vehicle that is" {
            m = 1250; I = 700; f11 = 10000000; f22 = 10000000; b = 0.7; lam = 0.15; r = 0.45; ky = 200000; kpsi = 200000;
        }
    }
}
