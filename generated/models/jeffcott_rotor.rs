carvallo::model! {
    /// A disc in the middle of an elastic shaft whose own damping turns with it: a Jeffcott rotor.
    ///
    /// Two coordinates, the displacements of the disc in axes that do not turn; the shaft turns from the first to the second.
    /// Damping of the surroundings always calms it, that of the shaft and of its fits drives the forward whirl above the
    /// spin rate sqrt(k/m) (1 + ce/ci), whatever the balance of the disc. The speed v is the circumferential speed at the
    /// radius R, so that the spin rate is v/R.
    pub model JeffcottRotor {
        source "Force balance of the Jeffcott rotor with rotating and non-rotating damping, as in textbooks of rotor dynamics";

        parameters {
            /// Mass of the disc.
            m: kg, > 0;
            /// Stiffness of the shaft at the disc.
            k: N/m, > 0;
            /// Damping of the surroundings, external or non-rotating.
            ce: N*s/m, >= 0;
            /// Damping of the shaft, internal or rotating.
            ci: N*s/m, >= 0;
            /// Radius at which the speed is that of the circumference.
            R: m, > 0;
        }

        let c = ce + ci;
        let circulation = ci/R;

        derivatives;

        coordinates {
            /// Displacement of the disc.
            y: m;
            /// Displacement of the disc across, to where the shaft turns from y.
            z: m;
        }

        symmetric M = [
            [m, 0],
            [0, m],
        ];
        symmetric C0 = [
            [c, 0],
            [0, c],
        ];
        symmetric Kc = [
            [k, 0],
            [0, k],
        ];
        K1 = [
            [0, circulation],
            [-circulation, 0],
        ];

        set example "An example in round figures, with the threshold at 250 rad/s, which is 7.5 m/s at the surface of the shaft" {
            m = 1; k = 10000; ce = 3; ci = 2; R = 0.03;
        }
    }
}
