carvallo::model! {
    /// A disc that rolls without slip on level ground, upright and straight but for small lean and yaw.
    ///
    /// Its spin balances it: it falls over, slowly, unless v^2 > g r It m r^2/(Ia (Ia + m r^2)), which is g r/3 for a
    /// uniform disc and g r/4 for a hoop. Axes: origin at the contact point, x forward, y to the right, z down.
    pub model RollingDisc {
        source "Mechanism: Neimark & Fufaev (1972), Dynamics of Nonholonomic Systems";

        parameters {
            /// Radius.
            r: m, > 0, along z;
            /// Mass.
            m: kg, > 0;
            /// Axial moment of inertia, about the axle.
            Ia: kg*m^2, >= 0;
            /// Transverse moment of inertia, about a diameter.
            It: kg*m^2, > 0;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            wheel D "disc": mass m, at (0, 0, -r), radius r, axial Ia, radial It;
            free D: lean phi, yaw psi;
        }

        derivatives;
        nonlinear;

        coordinates {
            /// Lean, positive to the right.
            phi "lean": rad;
            /// Yaw, positive to the right.
            psi "yaw": rad, both;
        }

        set uniform "A uniform disc of 1 kg: Ia = m r^2/2, It = m r^2/4" {
            r = 0.3; m = 1; Ia = 0.045; It = 0.0225; g = 9.81;
        }

        set hoop "A hoop of 1 kg: Ia = m r^2, It = m r^2/2" {
            r = 0.3; m = 1; Ia = 0.09; It = 0.045; g = 9.81;
        }
    }
}
