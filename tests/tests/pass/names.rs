//! Models with names in other scripts, names that mean something elsewhere, and models in odd places.

#![deny(warnings)]

carvallo::model! {
    pub model Fahrrad {
        parameters {
            λ: rad;
            質量: kg, > 0;
            länge: m, > 0;
        }
        let Trägheit = 質量*länge^2;
        coordinates { φ: rad; }
        M = [[Trägheit*cos(λ)]];
        set größe { λ = 0; 質量 = 2; länge = 3; }
    }
}

// What the symbolic engine has names of its own for.
carvallo::model! {
    model Symbols {
        parameters {
            e: 1; i: 1; I: 1; E: 1; Pi: 1; Gamma: 1; x_: 1; x__: 1; x0: 1; x1: 1; zeta: 1; log: 1; exp: 1; inf: 1; nan: 1;
        }
        coordinates { q: rad; }
        M = [[e + 2*i + 3*I + 4*E + 5*Pi + 6*Gamma + 7*x_ + 8*x__ + 9*x0 + 10*x1 + 11*zeta + 12*log + 13*exp + 14*inf
              + 15*nan]];
    }
}

// Words of the declaration itself, and of Rust, but only in places.
carvallo::model! {
    model Words {
        parameters {
            parameters: 1; source: 1; set: 1; require: 1; model: 1; gravity: 1; unused: 1; union: 1; macro_rules: 1;
            matrices: 1; coefficients: 1; values: 1; self_: 1; M: 1; K0: 1;
        }
        let info = parameters*source*set*require*model*gravity*unused;
        let C0 = union*macro_rules*matrices*coefficients*values*self_*M*K0;
        require set > 0;
        coordinates { v: rad; }
        M = [[info*C0]];
        set Words {
            parameters = 2; source = 1; set = 1; require = 1; model = 1; gravity = 1; unused = 1; union = 1;
            macro_rules = 1; matrices = 1; coefficients = 1; values = 1; self_ = 1; M = 1; K0 = 3;
        }
    }
}

fn main() {
    carvallo::model! {
        model Inside {
            parameters { m: kg; }
            coordinates { q: m; }
            M = [[m]];
        }
    }
    assert_eq!(Fahrrad::GRÖSSE.matrices().m, [[18.0]]);
    assert_eq!(Symbols::from_array([1.0; 15]).matrices().m, [[120.0]]);
    assert_eq!(Words::WORDS.matrices().m, [[6.0]]);
    assert_eq!(Inside { m: 2.0 }.matrices().m, [[2.0]]);
}
