carvallo::model! {
    /// A pendulum upside down on two wheels, as balancing robots and the Segway are: it stands only where a motor balances it.
    ///
    /// Two wheels on one axle that roll without slip, and a body above it. The motors act between body and wheels; forward
    /// motion, pitch and yaw take part. A positive torque, about y, drives a wheel backward and pitches the body forward.
    /// In the matrices `x` is of a point of the body, as declared; in the nonlinear equations `x` and `y` are of where the left wheel
    /// touches the ground, to first order `x - r*theta + b*psi` of that `x`.
    /// Axes: origin on the ground below the axle, x forward, y to the right, z down.
    pub model WheeledPendulum {
        source "Mechanism: Grasser, D'Arrigo, Colombi & Rufer (2002), JOE: a mobile, inverted pendulum, IEEE Trans. Ind. Electron. 49, 107-114";

        parameters {
            /// Mass of the body.
            m: kg, > 0;
            /// Centre of mass of the body, above the axle.
            l: m, > 0, along z;
            /// Moment of inertia of the body about its centre of mass, in pitch.
            Iyy: kg*m^2, >= 0;
            /// Moment of inertia of the body about its centre of mass, in yaw.
            Izz: kg*m^2, >= 0;
            /// Mass of each wheel.
            mW: kg, >= 0;
            /// Axial moment of inertia of each wheel.
            Ia: kg*m^2, >= 0;
            /// Radial moment of inertia of each wheel, about a diameter.
            Ir: kg*m^2, >= 0;
            /// Radius of the wheels.
            r: m, > 0, along z;
            /// Half of the track, from the middle of the axle to a wheel.
            b: m, > 0, along y;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "body": mass m, at (0, 0, -r - l), inertia [0, Iyy, Izz];
            wheel L "left wheel" on B: mass mW, at (0, -b, -r), radius r, axial Ia, radial Ir;
            wheel R "right wheel" on B: mass mW, at (0, b, -r), radius r, axial Ia, radial Ir;

            free B: forward x, pitch theta, yaw psi;

            force TL "torque of the left motor" on L;
            force TR "torque of the right motor" on R;
        }

        derivatives;
        nonlinear;

        coordinates {
            /// Forward motion, beside that at the speed v, of the point of the body that is on the ground when it is upright.
            x "forward": m;
            /// Pitch of the body, positive backward.
            theta "pitch": rad;
            /// Yaw, positive to the right.
            psi "yaw": rad;
        }

        set robot "A robot of the size of a boot, by estimate" {
            m = 0.6; l = 0.07; Iyy = 0.001; Izz = 0.0011; mW = 0.03; Ia = 0.000024; Ir = 0.000012; r = 0.04; b = 0.07; g = 9.81;
        }

        set transporter "A transporter with a rider who stands still, by estimate" {
            m = 110; l = 0.9; Iyy = 12; Izz = 2; mW = 5; Ia = 0.08; Ir = 0.045; r = 0.24; b = 0.28; g = 9.81;
        }
    }
}
