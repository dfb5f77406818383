carvallo::model! {
    /// Three pipes in a row that carry a fluid, hanging: a garden hose with three hinges.
    ///
    /// Rigid pipes of equal length, the first hinged to a wall and each other one to the one before it, each hinge with a
    /// spring and a damper. The speed v is that of the fluid, which leaves at the free end along the last pipe; above a
    /// critical speed the pipes buckle or flutter.
    pub model ThreePipes {
        source "Hamilton's principle for a fluid that leaves the system, as Benjamin (1961) has it: Proc. R. Soc. A 261, 457-486";

        parameters {
            /// Length of each pipe.
            l: m, > 0;
            /// Mass of a pipe for each metre.
            m: kg/m, > 0;
            /// Mass of the fluid in it for each metre.
            f: kg/m, >= 0;
            /// Stiffness of each hinge.
            k: N*m/rad, >= 0;
            /// Damping of each hinge.
            c: N*m*s/rad, >= 0;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }

        let inertia = (m + f)*l^3;
        let weight = (m + f)*l^2;

        derivatives;

        coordinates {
            /// Angle of the first pipe from the vertical.
            first: rad;
            /// Angle of the second pipe from the vertical.
            second: rad;
            /// Angle of the third pipe from the vertical.
            third: rad;
        }

        symmetric M = [
            [7/3*inertia, 3/2*inertia, 1/2*inertia],
            [3/2*inertia, 4/3*inertia, 1/2*inertia],
            [1/2*inertia, 1/2*inertia, 1/3*inertia],
        ];
        symmetric C0 = [
            [2*c, -c, 0],
            [-c, 2*c, -c],
            [0, -c, c],
        ];
        C1 = [
            [f*l^2, 2*f*l^2, 2*f*l^2],
            [0, f*l^2, 2*f*l^2],
            [0, 0, f*l^2],
        ];
        symmetric Kc = [
            [2*k, -k, 0],
            [-k, 2*k, -k],
            [0, -k, k],
        ];
        symmetric K0 = [
            [5/2*weight, 0, 0],
            [0, 3/2*weight, 0],
            [0, 0, 1/2*weight],
        ];
        K2 = [
            [-f*l, 0, f*l],
            [0, -f*l, f*l],
            [0, 0, 0],
        ];

        set hose "a hose of rubber, by estimate" {
            l = 0.5; m = 0.2; f = 0.3; k = 0.5; c = 0.01; g = 9.81;
        }
    }
}
