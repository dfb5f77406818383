fn main() {}

carvallo::model! {
    /// The derivatives of a sum of matrices.
    model Pendulum {
        parameters { mass: kg, > 0; length: m, > 0; g: N/kg, >= 0, gravity; damping: N*m*s, >= 0; }
        let inertia = mass*length^2;
        derivatives of C;
        coordinates { phi: rad; }
        M = [[inertia]];
        C0 = [[damping]];
        K0 = [[mass*length]];
    }
}
