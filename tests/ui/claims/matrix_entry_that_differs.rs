carvallo::model! {
    pub model Skate {
        parameters {
            m: kg, > 0;
            h: m, > 0, along z;
            r: m, > 0, along z;
            w: m, > 0, along x, unused;
            g: N/kg, >= 0, gravity;
        }
        mechanism {
            body B: mass m, at (w/2, 0, -h), inertia 0;
            wheel R on B: mass 0, at (0, 0, -r), radius r, axial 0, radial 0;
            wheel F on B: mass 0, at (w, 0, -r), radius r, axial 0, radial 0;
            free B: lean phi;
        }
        coordinates { phi: rad; }
        assert M == [[m*h*r]];
    }
}

fn main() {}
