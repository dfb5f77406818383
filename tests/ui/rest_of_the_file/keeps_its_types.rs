//! One mistake in the declaration, and a file that uses the model: nothing else is wrong with it.

#![deny(warnings)]

carvallo::model! {
    pub model Rod {
        parameters {
            /// The length.
            l: m, > 0;
            m: kg, > 0;
            g: N/kg, gravity;
        }
        let inertia = m*L^2;
        coordinates { phi: rad; delta: rad; }
        M = [[inertia, 0], [0, inertia]];
        K0 = [[l*m, 0], [0, l*m]];
        set short { l = 1; m = 2; g = 9.81; }
    }
}

fn lean<M: carvallo::Model<2>>(model: &M) -> M::Scalar {
    model.coefficients().m[(0, 0)]
}

fn main() {
    let rod = Rod { l: 2.0, ..Rod::SHORT };
    let RodMatrices { m, k0 } = Rod::from_array(rod.to_array()).matrices();
    println!("{} {:?} {:?}", lean(&rod.cast::<f32>()), m[0][1] + k0[1][1], carvallo::Model::gravity(&rod));
    println!("{:?}", carvallo::Model::validate(&rod));
}
