carvallo::model! {
    /// An inverted double pendulum: two links, one standing on the other, which lean to the right about axes along x.
    ///
    /// Axes: origin at the lower hinge, x forward, y to the right, z down, so that what is above it has z < 0. The second
    /// angle is that between the links.
    pub model DoublePendulum {
        source "Mechanism: Kibble & Berkshire (2004), Classical Mechanics, section 11.3, turned upside down";

        parameters {
            /// Length of the lower link, from hinge to hinge.
            l1: m, > 0, along z;
            /// Centre of mass of the lower link, above its hinge.
            a1: m, along z;
            /// Mass of the lower link.
            m1: kg, >= 0;
            /// Moment of inertia of the lower link about its centre of mass.
            I1: kg*m^2, >= 0;
            /// Centre of mass of the upper link, above its hinge.
            a2: m, along z;
            /// Mass of the upper link.
            m2: kg, >= 0;
            /// Moment of inertia of the upper link about its centre of mass.
            I2: kg*m^2, >= 0;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body lower: mass m1, at (0, 0, -a1), inertia [I1, 0, 0];
            body upper: mass m2, at (0, 0, -l1 - a2), inertia [I2, 0, 0];

            revolute theta1: ground to lower, through (0, 0, 0), along (1, 0, 0);
            revolute theta2: lower to upper, through (0, 0, -l1), along (1, 0, 0);

            force T1 "torque at the lower hinge" on theta1;
            force T2 "torque between the links" on theta2;
        }

        derivatives;
        nonlinear;

        coordinates {
            /// Lean of the lower link, to the right.
            theta1 "lower link": rad;
            /// Lean of the upper link relative to the lower one, to the right.
            theta2 "upper link": rad;
        }

        set rods "Two slender rods of 1 m and 1 kg" {
            l1 = 1; a1 = 0.5; m1 = 1; I1 = 1/12; a2 = 0.5; m2 = 1; I2 = 1/12; g = 9.81;
        }
    }
}
