//! A formula without a value, which only the symbolic stage finds, and a file that uses the model.

#![deny(warnings)]

carvallo::model! {
    model Rod {
        parameters { l: m, > 0; }
        coordinates { phi: rad; }
        M = [[1 [kg*m^3]/(l - l)]];
        set short { l = 1; }
    }
}

fn main() {
    println!("{:?}", Rod::SHORT.matrices().m);
    println!("{:?}", carvallo::Model::coefficients(&Rod { l: 2.0_f32 }));
}
