//! Appendix A of Meijaard, Papadopoulos, Ruina & Schwab (2007) by hand, one statement for each formula of the paper.
//!
//! This is what one would write without a compiler: the reference for speed and for rounding errors. It takes 175
//! operations, sine and cosine of the standard library among them.

#![allow(non_snake_case)] // The names are the paper's.

use carvallo::{Number, Rows};
use carvallo_compare::Counted;
use carvallo_models::{Whipple, WhippleMatrices};

/// A number whose sine and cosine come from the standard library, whatever the runtime does.
pub trait Float: Number {
    /// Sine and cosine of an angle in radians.
    fn sin_cos(self) -> (Self, Self);
}

impl Float for f32 {
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        f32::sin_cos(self)
    }
}

impl Float for f64 {
    #[inline]
    fn sin_cos(self) -> (Self, Self) {
        f64::sin_cos(self)
    }
}

/// Counts as the function of the runtime does.
impl Float for Counted {
    fn sin_cos(self) -> (Self, Self) {
        Number::sin_cos(self)
    }
}

/// The coefficient matrices of a design.
///
/// Always inlined, since that is what is fastest in a loop over designs.
#[inline(always)]
pub fn matrices<T: Float>(design: &Whipple<T>) -> WhippleMatrices<T> {
    let &Whipple { w, c, lam, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBzz, IBxz, .. } = design;
    let &Whipple { xH, zH, mH, IHxx, IHzz, IHxz, rF, mF, IFxx, IFyy, .. } = design;
    let (IRzz, IFzz) = (IRxx, IFxx);
    let zero = w.like(0.0);
    let two = w.like(2.0);
    let (sin, cos) = Float::sin_cos(lam);

    let mT = mR + mB + mH + mF;
    let xT = (xB * mB + xH * mH + w * mF) / mT;
    let zT = (-rR * mR + zB * mB + zH * mH - rF * mF) / mT;
    let ITxx = IRxx + IBxx + IHxx + IFxx + mR * rR * rR + mB * zB * zB + mH * zH * zH + mF * rF * rF;
    let ITxz = IBxz + IHxz - mB * xB * zB - mH * xH * zH + mF * w * rF;
    let ITzz = IRzz + IBzz + IHzz + IFzz + mB * xB * xB + mH * xH * xH + mF * w * w;

    let mA = mH + mF;
    let xA = (xH * mH + w * mF) / mA;
    let zA = (zH * mH - rF * mF) / mA;
    let IAxx = IHxx + IFxx + mH * (zH - zA) * (zH - zA) + mF * (rF + zA) * (rF + zA);
    let IAxz = IHxz - mH * (xH - xA) * (zH - zA) + mF * (w - xA) * (rF + zA);
    let IAzz = IHzz + IFzz + mH * (xH - xA) * (xH - xA) + mF * (w - xA) * (w - xA);
    let uA = (xA - w - c) * cos - zA * sin;
    let IAll = mA * uA * uA + IAxx * sin * sin + two * IAxz * sin * cos + IAzz * cos * cos;
    let IAlx = -mA * uA * zA + IAxx * sin + IAxz * cos;
    let IAlz = mA * uA * xA + IAxz * sin + IAzz * cos;

    let mu = c / w * cos;
    let SR = IRyy / rR;
    let SF = IFyy / rF;
    let ST = SR + SF;
    let SA = mA * uA + mu * mT * xT;

    let M12 = IAlx + mu * ITxz;
    let M = [[ITxx, M12], [M12, IAll + two * mu * IAlz + mu * mu * ITzz]];
    let K0 = [[mT * zT, -SA], [-SA, -SA * sin]];
    let K2 = [[zero, (ST - mT * zT) / w * cos], [zero, (SA + SF * sin) / w * cos]];
    let C21 = mu * ST + SF * cos;
    let C1 = [[zero, C21 + ITxz / w * cos - mu * mT * zT], [-C21, IAlz / w * cos + mu * (SA + ITzz / w * cos)]];
    WhippleMatrices { m: Rows(M), c1: Rows(C1), k0: Rows(K0), k2: Rows(K2) }
}
