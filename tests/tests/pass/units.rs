//! Units as people write them, in declarations that are right.

#![deny(warnings)]

carvallo::model! {
    model Units {
        parameters {
            m: kg, > 0 g, <= 2 t;
            l: m, in [1 mm, 2 km];
            a: rad, in (-90 deg, 90 deg);
            d: N/(m/s), >= 0;
            k: kg*s^-2;
            f: 1/s;
            p: Pa;
            g: N/kg, >= 0, gravity;
        }

        // 36 km/h is 10 m/s, and twice the root of 25 [cm^2] is 0.1 m.
        let u = 36 [km/h];
        let b = 2*sqrt(25 [cm^2]);

        require m > 500 g;
        require l + b > 0;

        coordinates {
            y: m;
            psi: rad;
        }

        M = [[m + d*u/(f^2*l), 0], [0, m*l*b*cos(a + 30 [deg])]];
        C0 = [[d + 3 [N*s/m], 0], [0, 0]];
        Kc = [[k, 0], [0, p*l^3]];

        set example {
            m = 1500 g;
            l = 250 cm;
            a = 15 deg;
            d = 0.5*3 N*s/m;
            k = 2 kN/m;
            f = 120 1/min;
            p = 0;
            g = 9.81;
            M = [[3.0, 0], [0, 0.265165042944955]];
            C0 = [[4.5, 0], [0, 0]];
            Kc = [[2e3, 0], [0, 0]];
        }
    }
}

fn main() {
    let example = Units::EXAMPLE;
    assert_eq!(example.to_array(), [1.5, 2.5, 0.261_799_387_799_149_44, 1.5, 2000.0, 2.0, 0.0, 9.81]);
    let said = |result: Result<(), carvallo::ParameterError>| result.map_err(|error| error.to_string());
    let small = carvallo::Model::validate(&Units { m: 0.4, ..example });
    assert_eq!(said(small), Err("Units: `m` is 0.4 kg; it must be > 0.5".into()));
    let requirements: &[carvallo::RequirementInfo] = <Units as carvallo::Model<2>>::INFO.requirements;
    let required: Vec<_> = requirements.iter().map(|r| format!("{} [{}] {}", r.expression, r.unit, r.domain)).collect();
    assert_eq!(required, ["f [1/s] not 0", "m [kg] > 0.5", "l + b [m] > 0"]);
    let [[m11, _], [_, m22]] = *example.matrices().m;
    assert!((m11 - 3.0).abs() < 1e-15 && (m22 - 0.375 * core::f64::consts::FRAC_1_SQRT_2).abs() < 1e-16);
}
