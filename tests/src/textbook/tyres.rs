//! The Whipple bicycle on tyres of circular cross-section.
//!
//! Its wheels are tori: rR and rF stay the outer radii, the heights of the centres of the upright wheels, and the
//! tyres' crowns have the radii rhoR and rhoF. Contact moves sideways on the tyre by rho times the lean of the wheel,
//! and a wheel's centre is at the height r - (r - rho) (1 - cos(lean)) instead of r cos(lean). Rolling without slip
//! gives a wheel's centre the same velocity as an edge does, to first order, as the contact is a radius r below it. So
//! M, C1 and K2 are those of the edge, Appendix A of Meijaard, Papadopoulos, Ruina & Schwab (2007), and K0 alone
//! changes. It is as if the ground rose under each wheel by rho / 2 times the square of the wheel's lean, phi at the
//! rear and phi + delta sin(lam) at the front, against the load on that wheel:
//!
//! ```text
//! mR' = mT (1 - xT / w)        mF' = mT xT / w                      the masses on the wheels
//!
//! K0[phi, phi]     += mR' rhoR + mF' rhoF
//! K0[phi, delta]   += mF' rhoF sin(lam)                             and K0[delta, phi]
//! K0[delta, delta] += mF' rhoF sin(lam)^2
//! ```
//!
//! Sources. Meijaard & Schwab, *Linearized equations for an extended bicycle model*, III European Conference on
//! Computational Mechanics, Lisbon (2006), treat such tyres; that paper was not at hand, and this was derived anew.
//! The model is that of Peterson's dissertation (Davis 2013, chapter 2), which was at hand, but has no linearized
//! matrices in print. Nonlinear equations of it, formed anew (four bodies, tori, one configuration and four rolling
//! constraints, by SymPy) and linearized numerically at 50 digits, have these matrices to 21 digits for the benchmark
//! and four other designs. Its conversion of parameters says, too, that the outer radii take the place of the radii
//! (there r + t). A wheel alone agrees with [`super::disc`].

#![allow(non_snake_case)] // The names are the paper's.

use carvallo::Coefficients;
use carvallo_models::Whipple;

use crate::hand_written;

/// The coefficients of a design whose tyres have crowns of the radii rhoR and rhoF.
pub fn matrices(design: &Whipple, rhoR: f64, rhoF: f64) -> Coefficients<f64, 2> {
    let edge = hand_written::matrices(design);
    let &Whipple { w, lam, mR, xB, mB, xH, mH, mF, .. } = design;
    let mT = mR + mB + mH + mF;
    let on_front = (xB * mB + xH * mH + w * mF) / w;
    let on_rear = mT - on_front;
    let sin = lam.sin();

    let [[K11, K12], [K21, K22]] = edge.k0.0;
    let rise = on_front * rhoF;
    let K0 = [[K11 + on_rear * rhoR + rise, K12 + rise * sin], [K21 + rise * sin, K22 + rise * sin * sin]];
    let zero = [[0.0; 2]; 2];
    Coefficients::from_rows([edge.m.0, zero, zero, edge.c1.0, zero, K0, zero, edge.k2.0])
}
