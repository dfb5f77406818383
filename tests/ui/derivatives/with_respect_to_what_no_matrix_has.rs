fn main() {}

carvallo::model! {
    /// The derivatives with respect to a parameter that the matrix does not have.
    model Pendulum {
        parameters { mass: kg, > 0; length: m, > 0; g: N/kg, >= 0, gravity; damping: N*m*s, >= 0; }
        let inertia = mass*length^2;
        derivatives of M, K0 with respect to length, damping;
        coordinates { phi: rad; }
        M = [[inertia]];
        C0 = [[damping]];
        K0 = [[mass*length]];
    }
}
