//! Chains of links that stand on a hinge, one on top of the other: the inverted pendulum, double, triple and so on.
//!
//! Link i has the length l, from its lower hinge to the next, the mass m, its centre at the distance a from the lower
//! hinge, and the moment of inertia I about its centre. In the absolute angles from the vertical, with m> the mass of
//! all links above link i,
//!
//! ```text
//! M[i, i]  = I[i] + m[i] a[i]^2 + m>[i] l[i]^2
//! M[i, j]  = l[i] (m[j] a[j] + m>[j] l[j])          for j above i; M is symmetric
//! K0[i, i] = -(m[i] a[i] + m>[i] l[i])              K0 is diagonal
//! ```
//!
//! A chain that hangs has -g in place of g. Nothing rolls: C0, C1, Kc and K2 are zero.
//!
//! Sources. This is standard, and was found anew and compared with the Hessians of the energies of three links, formed
//! by SymPy. Special cases that were at hand are in the tests: Kibble & Berkshire, *Classical Mechanics* (2004), eq.
//! 11.21, the double pendulum of unequal weights on unequal strings; Riley, Hobson & Bence, *Mathematical Methods for
//! Physics and Engineering* (2006), problem 9.7, two equal rods; and chains of equal weights on equal strings, whose
//! squared frequencies are g / l times the zeros of Laguerre's polynomial (Daniel Bernoulli 1738; the statement is
//! from memory, the zeros from Abramowitz & Stegun 1964, table 25.9).

use carvallo::{Coefficients, Matrix};

/// A link of a chain.
#[derive(Clone, Copy, Debug)]
pub struct Link {
    /// Length in m, to the hinge of the next link.
    pub l: f64,
    /// Distance of the centre of mass from the lower hinge in m.
    pub a: f64,
    /// Mass in kg.
    pub m: f64,
    /// Moment of inertia about the centre of mass in kg m^2.
    pub i: f64,
}

/// The coefficients of a standing chain, lowest link first, for the absolute angles from the vertical.
pub fn standing<const N: usize>(links: [Link; N]) -> Coefficients<f64, N> {
    let above = |link: usize| links[link + 1..].iter().map(|link| link.m).sum::<f64>();
    let moment = |link: usize| links[link].m * links[link].a + above(link) * links[link].l;
    let m = Matrix::<f64, N>::from_fn(|row, column| {
        let (low, high) = (row.min(column), row.max(column));
        let Link { l, a, m, i } = links[low];
        if low == high { i + m * a * a + above(low) * l * l } else { l * moment(high) }
    });
    let k0 = Matrix::<f64, N>::from_fn(|row, column| if row == column { -moment(row) } else { 0.0 });
    Coefficients { m, k0, ..Default::default() }
}

/// The same for the angles at the hinges, each from the link below it: the absolute angle is the sum of all up to it.
///
/// The forces are then torques at the hinges.
pub fn standing_at_hinges<const N: usize>(links: [Link; N]) -> Coefficients<f64, N> {
    let absolute = standing(links);
    let sums = Matrix::<f64, N>::from_fn(|row, column| if column <= row { 1.0 } else { 0.0 });
    let turned = |matrix: Matrix<f64, N>| sums.transpose() * matrix * sums;
    Coefficients { m: turned(absolute.m), k0: turned(absolute.k0), ..absolute }
}
