carvallo::model! {
    /// The typical section: a rigid wing on two springs in a flow, which diverges or flutters above a critical airspeed.
    ///
    /// Plunge and pitch of a wing of constant profile in a wind tunnel. The lift is that of a thin profile in a steady flow,
    /// 2 pi times the angle of attack, at the quarter chord; what the motion itself does to the flow is left out, and with
    /// it all damping, so that two pairs of imaginary eigenvalues meet where flutter begins. The speed v is that of the air.
    pub model TypicalSection {
        source "Equations of the typical section with steady lift, as in textbooks of aeroelasticity such as Hodges & Pierce, Introduction to Structural Dynamics and Aeroelasticity";

        parameters {
            /// Mass of the wing.
            m: kg, > 0;
            /// Moment of inertia about the elastic axis.
            I: kg*m^2, > 0;
            /// Semichord, half of the chord.
            b: m, > 0;
            /// Span of the wing.
            s: m, > 0;
            /// Elastic axis, behind the middle of the chord, in semichords.
            a: 1, in [-1, 1];
            /// Centre of mass, behind the middle of the chord, in semichords.
            e: 1, in [-1, 1];
            /// Stiffness of the spring in plunge.
            kh: N/m, >= 0;
            /// Stiffness of the spring in pitch.
            ktheta "kθ": N*m/rad, >= 0;
            /// Density of the air.
            rho "ρ": kg/m^3, >= 0;
        }

        let imbalance = m*b*(e - a);
        let lift = 2*pi*rho*b*s;
        let arm = b*(1/2 + a);

        require I - m*b^2*(e - a)^2 > 0;

        derivatives;

        coordinates {
            /// Plunge of the elastic axis, positive down.
            h "plunge": m;
            /// Pitch, positive with the nose up.
            theta "pitch": rad;
        }

        symmetric M = [
            [m, imbalance],
            [imbalance, I],
        ];
        symmetric Kc = [
            [kh, 0],
            [0, ktheta],
        ];
        K2 = [
            [0, lift],
            [0, -lift*arm],
        ];

        set dimensionless "mu = 20, r^2 = 6/25, sigma = 2/5, a = -1/5, e = -1/10; speeds are U/(b omega_theta)" {
            m = 1; I = 0.24; b = 1; s = 1; a = -0.2; e = -0.1; kh = 0.16; ktheta = 0.24; rho = 1/(20*pi);
        }
    }
}
