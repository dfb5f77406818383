carvallo::model! {
    pub model Disc {
        parameters {
            r: m, < 0, along z;
            m: kg, > 0;
            Ia: kg*m^2, > 0;
            It: kg*m^2, > 0;
            g: N/kg, >= 0, gravity;
        }

        mechanism {
            wheel D "disc": mass m, at (0, 0, -r), radius r, axial Ia, radial It;
            free D: lean phi, yaw psi;
        }

        coordinates {
            phi: rad;
            psi: rad;
        }
    }
}

fn main() {}
