fn main() {}

carvallo::model! {
    /// The derivatives with respect to a definition.
    model Pendulum {
        parameters { mass: kg, > 0; length: m, > 0; g: N/kg, >= 0, gravity; damping: N*m*s, >= 0; }
        let inertia = mass*length^2;
        derivatives with respect to inertia;
        coordinates { phi: rad; }
        M = [[inertia]];
        C0 = [[damping]];
        K0 = [[mass*length]];
    }
}
