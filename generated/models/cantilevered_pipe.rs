carvallo::model! {
    /// A cantilevered pipe that carries a fluid, in its first four modes: it flutters above a critical speed.
    ///
    /// A slender elastic pipe, clamped where the fluid enters and free where it leaves, in a horizontal plane and without
    /// damping of its own. The deflection is a sum of the first four modes of the clamped beam (Galerkin), each with a
    /// mean square of one over the length, so that its end is deflected by twice its coordinate. The speed v is that of the
    /// fluid; textbooks have it as u = v l sqrt(f/EI), and the part of the fluid in the mass as beta = f/(m + f).
    pub model CantileveredPipe {
        source "Gregory & Paidoussis (1966), Unstable oscillation of tubular cantilevers conveying fluid, Proc. R. Soc. A 293, 512-527; integrals of the modes: Paidoussis, Fluid-Structure Interactions, vol. 1";

        parameters {
            /// Length.
            l: m, > 0;
            /// Flexural rigidity.
            EI: N*m^2, > 0;
            /// Mass of the pipe for each metre.
            m: kg/m, > 0;
            /// Mass of the fluid in it for each metre.
            f: kg/m, >= 0;
        }

        let mass = (m + f)*l;
        let stiffness = EI/l^3;
        let flow = f/l;

        // The roots of cos x cosh x = -1, and those times (sinh x - sin x)/(cosh x + cos x).
        let lam1 = 1.875104068711961166445308;
        let lam2 = 4.694091132974174576436392;
        let lam3 = 7.854757438237612564861009;
        let lam4 = 10.99554073487546699066735;
        let n1 = 0.7340955137589127558287828*lam1;
        let n2 = 1.018467318759219405032741*lam2;
        let n3 = 0.9992244965174282872163576*lam3;
        let n4 = 1.000033553251713398399016*lam4;

        derivatives;

        coordinates {
            /// Deflection in the first mode.
            first: m;
            /// Deflection in the second mode.
            second: m;
            /// Deflection in the third mode.
            third: m;
            /// Deflection in the fourth mode.
            fourth: m;
        }

        symmetric M = [
            [mass, 0, 0, 0],
            [0, mass, 0, 0],
            [0, 0, mass, 0],
            [0, 0, 0, mass],
        ];
        C1 = [
            [4*f, 8*f/((lam1/lam2)^2 - 1), 8*f/((lam1/lam3)^2 + 1), 8*f/((lam1/lam4)^2 - 1)],
            [8*f/((lam2/lam1)^2 - 1), 4*f, 8*f/((lam2/lam3)^2 - 1), 8*f/((lam2/lam4)^2 + 1)],
            [8*f/((lam3/lam1)^2 + 1), 8*f/((lam3/lam2)^2 - 1), 4*f, 8*f/((lam3/lam4)^2 - 1)],
            [8*f/((lam4/lam1)^2 - 1), 8*f/((lam4/lam2)^2 + 1), 8*f/((lam4/lam3)^2 - 1), 4*f],
        ];
        symmetric Kc = [
            [stiffness*lam1^4, 0, 0, 0],
            [0, stiffness*lam2^4, 0, 0],
            [0, 0, stiffness*lam3^4, 0],
            [0, 0, 0, stiffness*lam4^4],
        ];
        K2 = [
            [flow*n1*(2 - n1), 4*flow*(n2 - n1)/(-1 - (lam1/lam2)^2), 4*flow*(n3 - n1)/(1 - (lam1/lam3)^2), 4*flow*(n4 - n1)/(-1 - (lam1/lam4)^2)],
            [4*flow*(n1 - n2)/(-1 - (lam2/lam1)^2), flow*n2*(2 - n2), 4*flow*(n3 - n2)/(-1 - (lam2/lam3)^2), 4*flow*(n4 - n2)/(1 - (lam2/lam4)^2)],
            [4*flow*(n1 - n3)/(1 - (lam3/lam1)^2), 4*flow*(n2 - n3)/(-1 - (lam3/lam2)^2), flow*n3*(2 - n3), 4*flow*(n4 - n3)/(-1 - (lam3/lam4)^2)],
            [4*flow*(n1 - n4)/(-1 - (lam4/lam1)^2), 4*flow*(n2 - n4)/(1 - (lam4/lam2)^2), 4*flow*(n3 - n4)/(-1 - (lam4/lam3)^2), flow*n4*(2 - n4)],
        ];

        set beta_02 "beta = 0.2, with v = u" {
            l = 1; EI = 1; m = 4; f = 1;
        }

        set beta_05 "beta = 0.5, with v = u" {
            l = 1; EI = 1; m = 1; f = 1;
        }

        set beta_07 "beta = 0.7, with v = u: four modes lose their stability, regain and lose it" {
            l = 1; EI = 1; m = 3/7; f = 1;
        }
    }
}
