carvallo::model! {
    pub model Disc {
        parameters {
            r: m, along z;
            rho: m, along z;
            full: kg;
            hole: kg;
            Ia: kg*m^2;
            It: kg*m^2, >= 0;
            g: N/kg, >= 0, gravity;
        }

        let m = full - hole;

        mechanism {
            wheel D "disc": mass m, at (0, 0, -r), radius r, tyre rho, axial Ia, radial It;
            free D: lean phi, yaw psi;
        }

        coordinates {
            phi: rad;
            psi: rad;
        }

        set example {
            r = 0;
            rho = 0;
            full = 1;
            hole = 0.5;
            Ia = 0.1;
            It = 0.1;
            g = 9.81;
        }
    }
}

fn main() {}
