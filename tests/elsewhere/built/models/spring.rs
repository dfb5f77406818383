carvallo::model! {
    /// A mass on a spring.
    pub model Spring {
        parameters {
            /// The mass.
            m: kg, > 0;
            k: N/m, >= 0;
            alpha: rad;
        }
        let stiffness = k*sin(alpha)^2 + k*cos(alpha)/2;
        require k + m*1 [Hz^2] > 0;
        derivatives;
        coordinates { x: m; }
        M = [[m]];
        Kc = [[stiffness]];
        set soft { m = 2; k = 3; alpha = 0; }
    }
}
