carvallo::model! {
    /// The single-track car of the textbooks: two axles on tyres whose side force is proportional to slip, at a constant speed.
    ///
    /// Axes: origin at the centre of mass, x forward, y to the right, z down. Only the rates of its coordinates are states: the
    /// lateral velocity along the axes of the car, and the yaw rate.
    pub model Car {
        source "The single-track car of the textbooks, after Riekert & Schunck (1940), Zur Fahrmechanik des gummibereiften Kraftfahrzeugs, Ingenieur-Archiv 11, 210-224";

        parameters {
            /// Mass.
            m: kg, > 0;
            /// Moment of inertia about the vertical axis.
            I: kg*m^2, > 0;
            /// Distance of the front axle ahead of the centre of mass.
            a: m, > 0;
            /// Distance of the rear axle behind the centre of mass.
            b: m, > 0;
            /// Cornering stiffness of the front axle, of both wheels together.
            Cf: N, > 0;
            /// Cornering stiffness of the rear axle, of both wheels together.
            Cr: N, > 0;
            v: m/s, speed;
        }

        derivatives;

        coordinates {
            /// Lateral motion, to the right.
            y "lateral": m, only rate;
            /// Yaw, to the right.
            psi "yaw": rad, only rate;
        }

        symmetric M = [[m, 0], [0, I]];
        C = [
            [(Cf + Cr)/v, (a*Cf - b*Cr)/v + m*v],
            [(a*Cf - b*Cr)/v, (a^2*Cf + b^2*Cr)/v],
        ];

        set oversteering "a public exercise: m = 1400, a = 1.14, b = 1.33, Cf = 25000, Cr = 21000, Iz = 2420" {
            m = 1400; I = 2420; a = 1.14; b = 1.33; Cf = 25000; Cr = 21000;
        }

        set understeering "the same with its axles exchanged" {
            m = 1400; I = 2420; a = 1.33; b = 1.14; Cf = 21000; Cr = 25000;
        }
    }
}
