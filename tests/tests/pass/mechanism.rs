//! Mechanisms whose parts are named like words of the declaration, and one without any motion beside its coordinate.

#![deny(warnings)]

carvallo::model! {
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            l: m, > 0, along z;
            g: N/kg, >= 0, gravity;
        }
        mechanism {
            body B: mass m, at (0, 0, l), inertia 0;
            revolute theta: ground to B, through (0, 0, 0), along (1, 0, 0);
        }
        coordinates { theta: rad; }
        set bob { m = 3; l = 2; g = 9.81; }
    }
}

// Only in places.
carvallo::model! {
    model Words {
        parameters {
            mass: kg, > 0;
            radius: m, > 0, along z;
            axial: kg*m^2, >= 0;
            radial: kg*m^2, >= 0;
            inertia: kg*m^2, >= 0;
            wheel: m, > 0, along x;
            forces: rad, in (-90 deg, 90 deg), about y;
            damper: N*m*s, >= 0;
            gravity: N/kg, >= 0, gravity;
        }
        let at = 2*radius;
        mechanism {
            body free: mass mass, at (wheel/2, 0, -at), inertia [inertia, 0, inertia];
            body to: mass mass, at (wheel, 0, -at), inertia [inertia, 0, inertia];
            wheel body on free: mass 0, at (0, 0, -radius), radius radius, axial axial, radial radial;
            wheel on on to: mass 0, at (wheel, 0, -radius), radius radius, axial axial, radial radial;
            free free: lean lean;
            revolute fix: free to to, through (wheel, 0, 0), along (sin(forces), 0, cos(forces)), damper damper;
            force force on fix;
        }
        coordinates { lean: rad; fix: rad; }
    }
}

fn main() {
    let matrices = Pendulum::BOB.matrices();
    assert_eq!((*matrices.m, *matrices.k0), ([[12.0]], [[6.0]]));
    let words = Words {
        mass: 1.0,
        radius: 0.3,
        axial: 0.1,
        radial: 0.05,
        inertia: 0.2,
        wheel: 1.0,
        forces: 0.0,
        damper: 2.0,
        gravity: 9.81,
    };
    assert_eq!(words.matrices().c0, [[0.0, 0.0], [0.0, 2.0]]);
    // A wheel that rolls at unit speed turns by the inverse of its radius, about an axis to the right: backward.
    assert!((words.kinematics().wheel_on.speed + 1.0 / 0.3_f64).abs() < 1e-12);
}
