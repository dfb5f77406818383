//! Bodies that there cannot be: what the domains do not exclude is refused at run time, by name, value and requirement.

#![allow(non_snake_case)] // Names of the field.

use carvallo::{Domain, Model};
use carvallo_compiler::model::Origin;
use carvallo_models::WhippleTyres;

carvallo::model! {
    /// A wheel of which the declaration says nothing, with a hole.
    pub model HollowDisc {
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
            wheel D: mass m, at (0, 0, -r), radius r, tyre rho, axial Ia, radial It;
            free D: lean phi, yaw psi;
        }

        coordinates { phi: rad; psi: rad; }
    }
}

const DISC: HollowDisc = HollowDisc { r: 0.3, rho: 0.1, full: 2.0, hole: 1.0, Ia: 0.1, It: 0.05, g: 9.81 };

#[test]
fn bodies_that_there_cannot_be_are_refused_by_name() {
    assert_eq!(DISC.validate(), Ok(()));
    let edges = [
        HollowDisc { hole: 2.0, ..DISC },
        HollowDisc { Ia: 0.0, ..DISC },
        HollowDisc { rho: 0.0, ..DISC },
        HollowDisc { rho: 0.3, ..DISC },
    ];
    for edge in edges {
        assert_eq!(edge.validate(), Ok(()), "{edge:?}");
    }
    let cases = [
        (HollowDisc { hole: 2.5, ..DISC }, "`full - hole` is -0.5 kg; it must be >= 0"),
        (HollowDisc { r: 0.0, rho: 0.0, ..DISC }, "`r` is 0 m; it must be > 0"),
        (HollowDisc { r: -0.3, ..DISC }, "`r` is -0.3 m; it must be > 0"),
        (HollowDisc { Ia: -0.25, ..DISC }, "`Ia` is -0.25 kg*m^2; it must be >= 0"),
        (HollowDisc { rho: -0.1, ..DISC }, "`rho` is -0.1 m; it must be >= 0"),
        (HollowDisc { r: 0.25, rho: 0.5, ..DISC }, "`r - rho` is -0.25 m; it must be >= 0"),
    ];
    for (design, expected) in cases {
        let error = design.validate().expect_err(expected);
        assert_eq!(error.to_string(), format!("HollowDisc: {expected}"));
    }
}

#[test]
fn a_tyre_larger_than_its_wheel_is_refused_in_a_bicycle() {
    let design = WhippleTyres { rF: 0.25, rhoF: 0.5, ..WhippleTyres::BENCHMARK };
    assert_eq!(design.validate().unwrap_err().to_string(), "WhippleTyres: `rF - rhoF` is -0.25 m; it must be >= 0");
}

/// The requirements that a pendulum's mechanism makes, with `parameters` and a body of its own.
fn requirements(parameters: &str, body: &str) -> Vec<(String, String, String)> {
    let source = format!(
        "model Rod {{ parameters {{ {parameters} l: m, > 0; }} mechanism {{ body B: {body}; revolute q: ground to B, \
         through (0, 0, 0), along (1, 0, 0), spring 1 [N*m]; }} coordinates {{ q: rad; }} }}"
    );
    let compiled = carvallo_compiler::compile(source.parse().unwrap()).unwrap_or_else(|error| panic!("{error}"));
    let requirements = compiled.model.requirements.into_iter().map(|requirement| {
        let Origin::Mechanism(what) = requirement.origin else { panic!("{requirement:?}") };
        (what, requirement.text, requirement.domain.to_string())
    });
    requirements.collect()
}

#[test]
fn what_is_known_is_not_required_again() {
    assert_eq!(requirements("m: kg, >= 0; I: kg*m^2, > 0;", "mass m, at (0, 0, l), inertia [I, 2*I, m*l^2]"), []);
    // By a square, by a requirement, or since nothing is left.
    assert_eq!(requirements("k: kg;", "mass k^2/(1 [kg]), at (0, 0, l), inertia 0"), []);
    assert_eq!(requirements("m: kg, in [0, 5];", "mass m + 1 [kg], at (0, 0, l), inertia [0, 0, 0]"), []);
    let needed = |what: &str, text: &str| (what.to_string(), text.to_string(), ">= 0".to_string());
    assert_eq!(requirements("m: kg;", "mass m, at (0, 0, l), inertia 0"), [needed("the mass of `B`", "m")]);
    let moment = needed("the moment of inertia of `B`", "I - m*l^2/3");
    let about_its_end = "mass m, at (0, 0, l), inertia [I - m*l^2/3, m*l^2, 2*(I - m*l^2/3)]";
    assert_eq!(requirements("m: kg, > 0; I: kg*m^2, > 0;", about_its_end), std::slice::from_ref(&moment));
    let full = "mass m, at (0, 0, l), inertia [[I - m*l^2/3, -I, 0], [-I, m*l^2, -I], [0, -I, m*l^2]]";
    assert_eq!(requirements("m: kg, > 0; I: kg*m^2, > 0;", full), [moment]);
}

#[test]
fn shipped_models_require_of_bodies_what_their_domains_do_not_say() {
    let required = |info: &carvallo::ModelInfo| -> Vec<(&str, &str, Domain)> {
        info.requirements.iter().map(|known| (known.expression, known.unit, known.domain)).collect()
    };
    let tyres = ["rR - rhoR", "rF - rhoF"].map(|text| (text, "m", Domain::NONNEGATIVE));
    assert_eq!(required(WhippleTyres::INFO), tyres);
    assert_eq!(required(carvallo_models::RollingDisc::INFO), []);
}
