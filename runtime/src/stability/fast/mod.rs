//! Critical speeds and stable ranges of ordinary designs, fast: for certain, or not at all.

mod double_root;
mod even;

use arrayvec::ArrayVec;

use super::ranges::Verdicts;
use super::verdict::{Verdict, verdict};
use super::{Change, CriticalKind, CriticalSpeed, Stability};
use crate::numeric::isolation::{Bracket, Brackets, Rounded};
use crate::numeric::{DoubleDouble, Sum};
use crate::{Coefficients, Complex, Scalar};
use double_root::DoubleRoots;
use even::{Even, Square, at};

struct Found {
    critical: CriticalSpeed,
    there: Option<Verdict>,
}

/// The least relative distance of two critical speeds.
const APART: f64 = 1.0 / (1u64 << 36) as f64;

/// The least that may be left of terms that cancel, for the digits that a root in `f64` gives.
const CANCELLED: f64 = 1.0 / (1u64 << 16) as f64;

/// What may be lacking of a root, relative to it.
const NEGLIGIBLE: f64 = f64::EPSILON / (1u64 << 16) as f64;

/// The largest relative error.
const SHARP: f64 = 1.0 / (1u64 << 20) as f64;

/// `None` if the fast path cannot decide.
pub(super) fn stability<T: Scalar>(coefficients: &Coefficients<T, 2>, gravity: f64) -> Option<Stability> {
    let even = Even::new(coefficients, gravity)?;
    let (hurwitz, discriminant) = even.hurwitz_and_discriminant();
    let signs = Signs {
        p0: Rounded::new(&even.p0),
        p1: Rounded::new(&even.p1),
        p2: Rounded::new(&even.p2),
        p3: Rounded::new(&[even.p3]).sign(0.0)?,
        hurwitz: Rounded::new(&hurwitz),
    };
    let mut found = ArrayVec::<Found, 12>::new();

    let mut brackets = Brackets::new();
    signs.p0.isolate(&mut brackets)?;
    for bracket in brackets.drain(..) {
        let root = simple_root(&even.p0, &signs.p0, &bracket)?;
        let slope = signs.p1.sign(root.square.u)?;
        let change = if bracket.rises == (slope > 0) { Change::Stabilizes } else { Change::Destabilizes };
        let critical = critical(CriticalKind::Capsize, root.square, root.error, change)?;
        found.push(Found { critical, there: Some(signs.cubic(root.square.u)?.max(Verdict::Marginal)) });
    }

    signs.hurwitz.isolate(&mut brackets)?;
    for bracket in brackets.drain(..) {
        let root = simple_root(&hurwitz, &signs.hurwitz, &bracket)?;
        let u = root.square.u;
        if signs.p1.sign(u)? != signs.p3 {
            continue;
        }
        let change = if bracket.rises == (signs.p3 > 0) { Change::Stabilizes } else { Change::Destabilizes };
        let mut critical = critical(CriticalKind::Weave, root.square, root.error, change)?;
        let sum = at(&even.p1, u);
        if sum.value.to_f64().abs() < CANCELLED * sum.size {
            return None;
        }
        let numerator = sum.value + (even.p1[1].value.to_f64() * root.square.rest).into();
        let first = numerator.to_f64() / even.p3.value.to_f64();
        let rest = (numerator - even.p3.value.times(first)).to_f64() / even.p3.value.to_f64();
        critical.eigenvalue.im = Square { u: first, rest }.speed().0;
        let there = if signs.p0.sign(u)? > 0 && signs.p3 > 0 { Verdict::Marginal } else { Verdict::Unstable };
        found.push(Found { critical, there: Some(there) });
    }

    let rounded = Rounded::new(&discriminant);
    rounded.isolate(&mut brackets)?;
    if !brackets.is_empty() {
        let roots = DoubleRoots::new(&even);
        for bracket in brackets.drain(..) {
            let root = roots.near(rounded.refine(&bracket)?)?;
            let change = if root.merges { Change::Merges } else { Change::Splits };
            let mut critical = critical(CriticalKind::DoubleRoot, root.square, root.error, change)?;
            let (speed, rest) = root.square.speed();
            critical.eigenvalue.re = (DoubleDouble::product(speed, root.sigma)
                + (speed * root.sigma_rest + rest * root.sigma).into())
            .to_f64();
            found.push(Found { critical, there: None });
        }
    }

    found.sort_unstable_by(|x, y| x.critical.speed.total_cmp(&y.critical.speed));
    let is_apart = |pair: &[Found]| pair[1].critical.speed - pair[0].critical.speed > APART * pair[1].critical.speed;
    if !found.windows(2).all(is_apart) {
        return None;
    }
    let bounds: ArrayVec<(f64, Verdict), 12> =
        found.iter().filter_map(|found| Some((found.critical.speed, found.there?))).collect();
    let rest = [even.p0[0], Sum::ZERO, even.p2[0], Sum::ZERO, even.p4];
    let verdicts = Verdicts::between(verdict(&rest), &bounds, |speed| signs.quartic(speed * speed))?;
    Some(Stability {
        critical_speeds: found.iter().map(|found| found.critical).collect(),
        stable_ranges: verdicts.stable_ranges(),
        verdicts,
    })
}

struct Signs {
    p0: Rounded<3>,
    p1: Rounded<2>,
    p2: Rounded<2>,
    p3: i8,
    hurwitz: Rounded<3>,
}

impl Signs {
    /// The verdict at a speed that is not critical.
    fn quartic(&self, u: f64) -> Option<Verdict> {
        if self.p3 < 0 || self.p0.sign(u)? < 0 || self.p1.sign(u)? < 0 || self.p2.sign(u)? < 0 {
            return Some(Verdict::Unstable);
        }
        Some(if self.hurwitz.sign(u)? > 0 { Verdict::Stable } else { Verdict::Unstable })
    }

    /// The verdict on the three eigenvalues that are not zero at a capsize speed.
    fn cubic(&self, u: f64) -> Option<Verdict> {
        if self.p3 < 0 || self.p1.sign(u)? < 0 || self.p2.sign(u)? < 0 {
            return Some(Verdict::Unstable);
        }
        // There p_0 is zero and the determinant p_1 (p_2 p_3 - p_1 p_4).
        Some(if self.hurwitz.sign(u)? > 0 { Verdict::Stable } else { Verdict::Unstable })
    }
}

struct Root {
    square: Square,
    error: f64,
}

fn simple_root(polynomial: &[Sum; 3], rounded: &Rounded<3>, bracket: &Bracket) -> Option<Root> {
    let u = rounded.refine(bracket)?;
    let value = at(polynomial, u);
    let [_, c1, c2] = polynomial.map(|c| c.value.to_f64());
    let slope = 2.0 * c2 * u + c1;
    let step = -value.value.to_f64() / slope;
    let error = f64::EPSILON * value.size / slope.abs();
    let left = (c2 / slope).abs() * step * step;
    (step.abs() <= APART * u && left <= NEGLIGIBLE * u).then_some(Root { square: Square { u, rest: step }, error })
}

fn critical(kind: CriticalKind, square: Square, error: f64, change: Change) -> Option<CriticalSpeed> {
    let (speed, _) = square.speed();
    let error = error.max(square.u * f64::EPSILON / 8.0) / (2.0 * speed);
    (error <= SHARP * speed).then_some(CriticalSpeed {
        kind,
        speed,
        error: error + 0.5 * f64::EPSILON * speed,
        eigenvalue: Complex::new(0.0, 0.0),
        change,
    })
}
