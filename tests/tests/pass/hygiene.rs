//! A model among items that have the names of everything its code might reach for.

#![deny(warnings, missing_docs)]
#![allow(non_camel_case_types, non_upper_case_globals)]

#[allow(dead_code)]
mod names {
    pub struct T;
    pub struct f64;
    pub struct f32;
    pub struct str;
    pub struct usize;
    pub trait From {}
    pub trait Default {}
    pub trait Display {}
    pub enum Result {}
    pub enum Option {}
    pub enum Some {}
    pub enum Ok {}
    pub trait Clone {}
    pub trait Copy {}
    pub trait Model {}
    pub trait Scalar {
        fn sin_cos(&self) {}
        fn to_f64(&self) {}
    }
    impl<X> Scalar for X {}
    pub fn sin() {}
    pub fn sqrt() {}
    pub const values: u8 = 0;
    pub const name: u8 = 0;
    pub const formatter: u8 = 0;
    pub static parameter: u8 = 0;
    pub struct element;
    pub mod core {}
    pub mod std {}
    pub mod carvallo {}
}

mod model {
    #[allow(unused_imports)]
    use crate::names::*;

    ::carvallo::model! {
        /// A model with a type parameter's name.
        pub model T2 {
            parameters {
                e: 1, > 0;
                I: 1, > 0;
                Gamma: rad;
                x_: rad;
                t5: 1, > 0;
            }
            let E = sin(Gamma)*cos(Gamma) + sqrt(e)*tan(x_)/t5;
            let d0 = E + I;
            require e + I > 0;
            coordinates { T: rad; f64: m; }
            derivatives;
            M = [[d0*1 [kg*m^2], E*1 [kg*m]], [E*1 [kg*m], 2 [kg]]];
            C1 = [[0, e*1 [kg]], [0.5 [kg], 0]];
            set ok { e = 1; I = 2; Gamma = 0; x_ = 0; t5 = 1; }
        }
    }
}

mod called_like_a_type_parameter {
    ::carvallo::model! {
        model T {
            parameters { t: kg, > 0; }
            coordinates { q: m; }
            M = [[t]];
        }
    }

    pub fn mass() -> [[f64; 1]; 1] {
        T { t: 3.0 }.matrices().m.0
    }
}

fn main() {
    let model = model::T2::OK;
    assert_eq!(model.matrices().m, [[2.0, 0.0], [0.0, 2.0]]);
    assert_eq!(model.matrices().c1, [[0.0, 1.0], [0.5, 0.0]]);
    assert!(carvallo::Model::validate(&model).is_ok());
    assert_eq!(model::T2::set("OK"), Some(model));
    assert_eq!(model::T2::from(model.to_f32()), model);
    assert_eq!(model::T2::INFO.name, "T2");
    assert_eq!(model.to_string(), "e     = 1.0\nI     = 2.0\nGamma = 0.0 rad\nx_    = 0.0 rad\nt5    = 1.0");
    assert_eq!(called_like_a_type_parameter::mass(), [[3.0]]);
}
