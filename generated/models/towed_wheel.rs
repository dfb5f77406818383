carvallo::model! {
    /// A towed wheel that shimmies.
    ///
    /// A caster whose king pin is held by a lateral spring to a vehicle that runs straight at the speed v. The wheel does not
    /// slip sideways, so its lateral place moves as its yaw says: `y' = v psi`, a coordinate of first order. Whether it
    /// shimmies depends on the geometry and not on the speed: it is stable for `a (l - a) > I/m`.
    pub model TowedWheel {
        source "Schwab & Meijaard (2003), Dynamics of flexible multibody systems with non-holonomic constraints, Multibody System Dynamics 10, 107-123";

        parameters {
            /// Mass of wheel and fork.
            m: kg, > 0;
            /// Moment of inertia of wheel and fork about their centre of mass, in yaw.
            I: kg*m^2, > 0;
            /// From the contact point of the wheel forward to the king pin.
            l: m, > 0;
            /// From the contact point of the wheel forward to the centre of mass.
            a: m;
            /// Lateral stiffness of the support of the king pin.
            k: N/m, > 0;
            /// Forward speed.
            v: m/s, speed;
        }

        derivatives;

        coordinates {
            /// Yaw of the wheel, positive to the right.
            psi "yaw": rad;
            /// Lateral place of the contact point, positive to the right.
            y "place": m, only position;
        }

        M = [
            [I + m*a^2, 0],
            [0, 0],
        ];
        C = [
            [m*a*v, 0],
            [0, 1 [N*s/m]],
        ];
        K = [
            [k*l^2, k*l],
            [-1 [N*s/m]*v, 0],
        ];

        set example "Schwab & Meijaard (2003): k = 0.3 m/s^2, I = 0.21 m l^2, with the centre of mass in the middle" {
            m = 5; I = 1.05; l = 1; a = 0.5; k = 1.5;
        }
    }
}
