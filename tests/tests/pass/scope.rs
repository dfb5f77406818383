//! Models among items that have the names of everything their code might declare, call or match on.

#![deny(warnings, missing_docs)]

/// Items of a user's crate, each the name of something in generated code.
#[allow(clippy::all, dead_code, missing_docs, non_camel_case_types, non_upper_case_globals)]
pub mod names {
    // A constant cannot be shadowed by a variable or a parameter of a function.
    pub const t0: Unit = Unit;
    pub const t1: Unit = Unit;
    pub const t2: Unit = Unit;
    pub const t5: f32 = 0.0;
    pub const mT: f32 = 0.0;
    pub const values: Unit = Unit;
    pub const matrices: Unit = Unit;
    pub const info: Unit = Unit;
    pub const name: Unit = Unit;
    pub const formatter: Unit = Unit;
    pub const parameters: Unit = Unit;
    pub const other: Unit = Unit;
    pub const f: Unit = Unit;
    pub static s: u8 = 0;
    pub static c: u8 = 0;
    pub struct l;
    pub struct m;
    pub struct Unit;

    pub struct Some(Unit);
    pub struct Ok(Unit);
    pub struct Err(Unit);
    pub struct None;
    pub struct T;
    pub struct U;
    pub struct Scalar;
    pub struct Model;
    pub struct Coefficients;
    pub struct Option<X>(X);
    pub struct Result<X>(X);
    pub struct f64;
    pub struct usize;
    pub struct str;
    pub mod core {}
    pub mod std {}
    pub mod carvallo {}
    pub fn sin() {}
    pub fn sqrt() {}

    /// Methods for all types, by value, which come before those that take a reference.
    pub trait Methods: Sized {
        fn sin(self) {}
        fn cos(self) {}
        fn sin_cos(self) {}
        fn sqrt(self) {}
        fn len(self) {}
        fn copy_from_slice(self, _: &[u8]) {}
        fn from_f64(self) {}
        fn to_f64(self) {}
        fn to_array(self) {}
        fn to_f32(self) {}
        fn set(self) {}
        fn cast(self) {}
        fn write_parameters(self) {}
        fn from_array(self) {}
        fn matrices(self) {}
        fn validate(self) {}
        fn require(self) {}
        fn clone(self) {}
        fn eq(self) {}
        fn fmt(self) {}
        fn add(self) {}
        fn mul(self) {}
        fn neg(self) {}
    }
    impl<X> Methods for X {}

    #[macro_export]
    #[doc(hidden)]
    macro_rules! vec {
        () => {
            compile_error!("not this one")
        };
    }
    #[macro_export]
    #[doc(hidden)]
    macro_rules! panic {
        () => {
            compile_error!("not this one")
        };
    }
}

mod models {
    #[allow(unused_imports)]
    use crate::names::*;
    #[allow(unused_imports)]
    use crate::{panic, vec};

    ::carvallo::model! {
        /// A model that needs all kinds of statements.
        pub model Whipple {
            parameters {
                l: 1, > 0;
                m: 1, > 0;
                s: rad;
                values: 1;
                g: N/kg, gravity;
            }
            let mT = sqrt(m)*sin(s) + values*tan(s)/l;
            let t5 = mT*cos(s) + (m + values)^2 + 3*l;
            let info = 1/t5 + m/t5;
            require m + mT + t5 > 0;
            coordinates { f64: rad; T: m; }
            M = [[m*1 [kg*m^2], mT*info*1 [kg*m]], [mT*info*1 [kg*m], t5*1 [kg]]];
            C1 = [[0, -mT^2*t5*1 [kg]], [0.5 [kg], l*1 [kg/m]]];
            K0 = [[-m*1 [kg*m], info*1 [kg]], [0, mT*1 [kg/m]]];
            set ok { l = 1; m = 4; s = 0; values = 0; g = 9.81; }
        }
    }

    // A second one beside it, and one that has the letter of a type parameter.
    ::carvallo::model! {
        pub model WhippleToo {
            parameters { l: kg, > 0; }
            coordinates { q: m; }
            M = [[l]];
        }
    }
}

mod letter {
    ::carvallo::model! {
        pub model U {
            parameters { u: kg, > 0; }
            coordinates { q: m; }
            M = [[u]];
        }
    }
}

fn in_a_function() -> [[f64; 1]; 1] {
    #[allow(non_upper_case_globals, dead_code)]
    const t0: u8 = 0;
    carvallo::model! {
        model Inside {
            parameters { l: m, > 0; }
            let twice = 2*l;
            coordinates { q: m; }
            M = [[twice^2*1 [kg/m^2]]];
            set one { l = 1; }
        }
    }
    Inside::ONE.matrices().m.0
}

macro_rules! declare {
    ($($name:ident $parameter:ident;)*) => {
        $(carvallo::model! {
            /// Declared by a macro.
            model $name {
                parameters { $parameter: m, > 0; }
                let square = $parameter^2;
                coordinates { q: m; }
                M = [[square*1 [kg/m^2]]];
            }
        })*
    };
}
declare! { First l; Second t1; }

fn main() {
    use carvallo::Model;
    let ok = models::Whipple::OK;
    assert_eq!(ok.matrices().m, [[4.0, 0.0], [0.0, 19.0]]);
    assert_eq!(ok.matrices().c1, [[0.0, 0.0], [0.5, 1.0]]);
    assert!(ok.validate().is_ok());
    assert_eq!(models::Whipple::set("Ok"), Some(ok));
    assert_eq!(models::Whipple::<f64>::from(ok.to_f32()), ok.cast::<f32>().cast());
    assert_eq!(models::Whipple::INFO.name, "Whipple");
    assert_eq!(ok.to_string().lines().last(), Some("g      = 9.81 N/kg"));
    assert_eq!(models::Whipple::from_array(ok.to_array()), ok);
    assert_eq!(models::Whipple::from_slice(&[1.0]).map_err(|error| error.found), Err(1));
    let mut values = [0.0; 5];
    assert!(ok.write_to(&mut values).is_ok());
    assert_eq!(values, ok.to_array());
    assert_eq!(models::WhippleToo { l: 2.0 }.matrices().m, [[2.0]]);
    assert_eq!(letter::U { u: 2.0 }.cast::<f32>().matrices().m, [[2.0_f32]]);
    assert_eq!(in_a_function(), [[4.0]]);
    assert_eq!(First { l: 3.0 }.matrices().m, [[9.0]]);
    assert_eq!(Second { t1: 3.0 }.matrices().m, [[9.0]]);
}
