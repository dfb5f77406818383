carvallo::model! {
    /// A car with a trailer, which snakes above a critical speed.
    ///
    /// Car and trailer are one rigid body each, joined by a ball at which only yaw takes part, on tyres whose side forces are
    /// linear in slip. What two front wheels do is in one, and so it is for the trailer; its load on the ball is that of its
    /// centre of mass. Axes: origin on the ground below the centre of mass of the car, x forward, y to the right, z down.
    pub model CarTrailer {
        source "Mechanism of the single-track car with a trailer, as in Hac, Fulk & Chen (2008), SAE 2008-01-1228";

        parameters {
            /// Mass of the car.
            m: kg, > 0;
            /// Moment of inertia of the car about its centre of mass, in yaw.
            I: kg*m^2, > 0;
            /// From the centre of mass of the car forward to the front axle.
            a: m, > 0, along x;
            /// From the centre of mass of the car backward to the rear axle.
            b: m, > 0, along x;
            /// From the centre of mass of the car backward to the ball.
            h: m, > 0, along x;
            /// Mass of the trailer.
            mT: kg, > 0;
            /// Moment of inertia of the trailer about its centre of mass, in yaw.
            IT: kg*m^2, > 0;
            /// From the ball backward to the centre of mass of the trailer.
            e: m, along x;
            /// From the ball backward to the axle of the trailer.
            l: m, > 0, along x;
            /// Cornering stiffness of the front axle of the car.
            Cf: N/rad, > 0;
            /// Cornering stiffness of the rear axle of the car, of both wheels.
            Cr: N/rad, > 0;
            /// Cornering stiffness of the axle of the trailer.
            CT: N/rad, > 0;
            /// Damping of yaw at the ball.
            d: N*m*s/rad, >= 0;
            /// Half of the track of the rear axle.
            t: m, > 0, along y;
            /// Radius of the wheels.
            r: m, > 0, along z;
            /// Gravitational field strength.
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            body B "car": mass m, at (0, 0, -r), inertia [I, I, I];
            body P "ball": massless;
            body T "trailer": mass mT, at (-h - e, 0, -r), inertia [IT, IT, IT];
            wheel F "front axle" on B: mass 0, at (a, 0, -r), radius r, axial 0, radial 0, cornering Cf;
            wheel L "rear left" on B: mass 0, at (-b, -t, -r), radius r, axial 0, radial 0, cornering Cr/2;
            wheel R "rear right" on B: mass 0, at (-b, t, -r), radius r, axial 0, radial 0, cornering Cr/2;
            wheel U "axle of the trailer" on T: mass 0, at (-h - l, 0, -r), radius r, axial 0, radial 0, cornering CT;

            free B: lateral y, yaw psi;
            revolute pitch: B to P, through (-h, 0, -r), along (0, 1, 0);
            revolute q: P to T, through (-h, 0, -r), along (0, 0, 1), damper d;
        }

        derivatives;

        coordinates {
            /// Lateral motion of the car, positive to the right: its rate is the velocity along the axes of the car.
            y "lateral": m;
            /// Yaw of the car, positive to the right.
            psi "yaw": rad;
            /// Angle of the trailer to the car, positive to the right.
            q "hitch": rad;
        }

        set caravan "A family car with a caravan, by estimate" {
            m = 1500; I = 2500; a = 1.2; b = 1.5; h = 2.4; mT = 1200; IT = 2200; e = 3.5; l = 3.7;
            Cf = 80000; Cr = 100000; CT = 70000; d = 0; t = 0.75; r = 0.3; g = 9.81;
        }

        set loaded_behind "The same with its load behind the axle of the caravan" {
            m = 1500; I = 2500; a = 1.2; b = 1.5; h = 2.4; mT = 1200; IT = 3200; e = 3.8; l = 3.7;
            Cf = 80000; Cr = 100000; CT = 70000; d = 0; t = 0.75; r = 0.3; g = 9.81;
        }
    }
}
