carvallo::model! {
    pub model Cart {
        parameters {
            m: kg, > 0;
            x: m, along x;
            z: m, along z;
            tilt: rad, about y;
        }

        let s = z*cos(tilt) + z*sin(tilt);

        coordinates {
            phi: rad, about x;
            delta: rad, about z;
        }

        M = [[m*z^2, -m*x*z], [-m*x*z, m*x^2]];
        K0 = [[m*z, m*s], [m*x, m*z]];
    }
}

fn main() {}
