//! One mistake in a mechanism, and a file that uses what would be derived from it: nothing else is wrong with it.

#![deny(warnings)]

carvallo::model! {
    pub model Skate {
        parameters {
            w: m, > 0;
            h: m, > 0;
            m: kg, > 0;
            I: kg*m^2, > 0;
            g: N/kg, gravity;
        }
        mechanism {
            body B: mass m, at (w/2, 0, -h), inertia [I, I, I];
            body H: massless;
            wheel R on B: mass m, at (0, 0, -h), radius H, axial I, radial I;
            wheel F on H: mass m, at (w, 0, -h), radius h, axial I, radial I;
            free B: lean phi;
            revolute delta: B to H, through (w, 0, 0), along (0, 0, 1);
            force T on delta;
        }
        coordinates { phi: rad; delta: rad; }
        set one { w = 1; h = 1; m = 1; I = 1; g = 9.81; }
    }
}

fn main() {
    let kinematics: SkateKinematics<f32> = Skate::ONE.cast::<f32>().kinematics();
    let row: [f32; 1] = kinematics.forces[1];
    println!("{row:?} {:?} {:?}", kinematics.yaw.at(1.0, &[0.0; 2], &[0.0; 2], 0.0), kinematics.wheel_R.speed);
}
