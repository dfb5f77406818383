//! Attributes of Rust on models and parameters, and a parameter set that is the default.

#![deny(warnings)]

use serde::{Deserialize, Serialize};

carvallo::model! {
    /// With traits that every model derives among others.
    #[derive(Clone, Serialize, Deserialize, std::fmt::Debug, PartialOrd)]
    #[serde(deny_unknown_fields, rename_all = "UPPERCASE")]
    #[cfg_attr(all(), derive(Copy), must_use)]
    #[cfg_attr(any(), derive(NoSuchTrait))]
    pub model Pendulum {
        parameters {
            m: kg, > 0;
            /// Length.
            #[serde(rename = "length", alias = "λ")]
            l: m, > 0;
        }
        coordinates { theta: rad; }
        M = [[m*l^2]];
        set seconds { m = 1; l = 0.994; }
        /// Documentation above.
        #[default]
        /// And below.
        set metre { m = 2; l = 1; }
    }
}

// Without a default set, it may be derived: all parameters are zero.
carvallo::model! {
    #[derive(Default)]
    model Zero {
        parameters { m: kg, > 0; }
        coordinates { q: m; }
        M = [[m]];
        set one { m = 1; }
    }
}

// Using what is deprecated is no mistake of the generated code.
carvallo::model! {
    #[deprecated = "there is a better one"]
    pub model Old {
        parameters {
            m: kg, > 0;
            #[deprecated]
            l: m, > 0;
        }
        coordinates { theta: rad; }
        M = [[m*l^2]];
        #[default]
        set unit { m = 1; l = 1; }
    }
}

macro_rules! declare {
    ($(#[$attribute:meta])* $name:ident) => {
        carvallo::model! {
            $(#[$attribute])*
            pub model $name {
                parameters { m: kg, > 0; }
                coordinates { q: m; }
                M = [[m]];
                $(#[$attribute])*
                set one { m = 1; }
            }
        }
    };
}
declare! {
    /// Documentation of both.
    First
}
macro_rules! derive {
    ($(#[$attribute:meta])* $name:ident) => {
        carvallo::model! {
            $(#[$attribute])*
            pub model $name {
                parameters { m: kg, > 0; }
                coordinates { q: m; }
                M = [[m]];
            }
        }
    };
}
derive! {
    /// With what an outer macro was given.
    #[derive(Serialize)]
    Second
}

/// What holds a model, as people do.
#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
struct Experiment<T: carvallo::Scalar = f64> {
    pendulum: Pendulum<T>,
}

fn main() {
    let pendulum = Pendulum { m: 0.5, l: 0.25 };
    assert_eq!(serde_json::to_string(&pendulum).unwrap(), r#"{"M":0.5,"length":0.25}"#);
    assert_eq!(serde_json::from_str::<Pendulum>(r#"{"M":0.5,"λ":0.25}"#).unwrap(), pendulum);
    let error = serde_json::from_str::<Pendulum>(r#"{"M":0.5,"length":0.25,"g":9.81}"#).unwrap_err();
    assert!(error.to_string().starts_with("unknown field `g`, expected"), "{error}");
    assert!(Pendulum { m: 1.0, l: 2.0 } > pendulum);

    // In a number type that nothing else says, and in others.
    assert_eq!(Pendulum::default().matrices().m, [[2.0]]);
    assert_eq!(Pendulum::<f32>::default(), Pendulum { m: 2.0_f32, l: 1.0 });
    assert_eq!(Pendulum { m: 3.0, ..Default::default() }.l, 1.0);
    assert_eq!(Experiment::<f32>::default().pendulum.l, 1.0_f32);
    assert_eq!(Experiment { pendulum: Pendulum::METRE }, Experiment::default());
    const DEFAULT: Pendulum = Pendulum::default();
    assert_eq!(DEFAULT, Pendulum::METRE);
    assert!(Pendulum::INFO.sets[1].docs == "Documentation above.\nAnd below.");
    assert_eq!(Zero::<f64>::default().m, 0.0);
    assert_eq!(Zero::ONE.m, 1.0);

    assert_eq!(First::INFO.docs, "Documentation of both.");
    assert_eq!(serde_json::to_string(&Second { m: 2.0 }).unwrap(), r#"{"m":2.0}"#);
}
