carvallo::model! {
    /// A pendulum with a damped joint, hanging at rest.
    ///
    /// A point mass on a massless rod.
    pub model Pendulum {
        source "Newton's second law about the joint";

        parameters {
            /// Mass of the bob.
            m: kg, > 0;
            /// Length of the rod.
            l: m, > 0;
            /// Damping of the joint.
            c: N*m*s, >= 0;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }

        derivatives;

        coordinates {
            /// Angle of the rod from the vertical.
            theta "swing": rad;
        }

        symmetric M = [[m*l^2]];
        C0 = [[c]];
        symmetric K0 = [[m*l]];

        set seconds "a bob of 2 kg that passes its lowest point once a second, nearly" {
            m = 2; l = 0.994; c = 0.1; g = 9.81;
        }
    }
}
