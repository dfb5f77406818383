//! A parameter and a coordinate that are being typed, and a file that uses the model.

#![deny(warnings)]

carvallo::model! {
    model Rod {
        parameters { l: m, > 0; mass: }
        coordinates { phi: rad; delta }
        M = [[mass*l^2, 0], [0, mass*l^2]];
        set short { l = 1; mass = 2; }
    }
}

fn main() {
    let rod = Rod { l: 2.0_f32, mass: 3.0 };
    let m: [[f32; 2]; 2] = rod.matrices().m.0;
    println!("{m:?} {:?} {:?}", Rod::SHORT, <Rod as carvallo::Model<2>>::INFO);
}
