//! Appendix A of Meijaard, Papadopoulos, Ruina & Schwab (2007) as symplex-build 0.57.0 turns it into Rust.
//!
//! `f64.rs` and `f32.rs` are its output (symplex is under MIT or Apache-2.0), with its option `inline`, and without
//! `mul_add`, which is a slow call of a function where the target has no such instruction. To write them anew:
//! `cargo run --release --manifest-path tests/peers/symplex/Cargo.toml`.

use carvallo::{Rows, Scalar};
use carvallo_models::{Whipple, WhippleMatrices};

#[allow(non_snake_case, unused_parens)] // As it comes.
#[allow(clippy::all)]
mod double {
    include!("f64.rs");
}

#[allow(non_snake_case, unused_parens)]
#[allow(clippy::all)]
mod single {
    include!("f32.rs");
}

/// A number type for which there is such code.
pub trait Symplex: Scalar {
    /// M, C1, K0 and K2, entry by entry.
    fn entries(design: &Whipple<Self>) -> [Self; 16];
    /// The same, and after them the derivatives that are not identically zero: by parameters, of each by entries.
    fn entries_and_derivatives(design: &Whipple<Self>) -> [Self; 16 + DERIVATIVES];
}

/// How many derivatives of an entry with respect to a parameter are not identically zero.
pub const DERIVATIVES: usize = 158;

macro_rules! symplex {
    ($t:ident, $module:ident) => {
        impl Symplex for $t {
            #[inline]
            fn entries(d: &Whipple<Self>) -> [Self; 16] {
                of_design!(d, $module::matrices)
            }
            #[inline]
            fn entries_and_derivatives(d: &Whipple<Self>) -> [Self; 16 + DERIVATIVES] {
                of_design!(d, $module::matrices_and_derivatives)
            }
        }
    };
}
macro_rules! of_design {
    ($d:ident, $function:path) => {
        $function(
            $d.w, $d.c, $d.lam, $d.rR, $d.mR, $d.IRxx, $d.IRyy, $d.xB, $d.zB, $d.mB, $d.IBxx, $d.IBzz, $d.IBxz, $d.xH,
            $d.zH, $d.mH, $d.IHxx, $d.IHzz, $d.IHxz, $d.rF, $d.mF, $d.IFxx, $d.IFyy,
        )
    };
}
symplex!(f64, double);
symplex!(f32, single);

/// The coefficient matrices of a design.
#[inline]
pub fn matrices<T: Symplex>(design: &Whipple<T>) -> WhippleMatrices<T> {
    rows(&T::entries(design))
}

#[inline(always)]
fn rows<T: Scalar>(entries: &[T; 16]) -> WhippleMatrices<T> {
    let matrix = |first: usize| Rows([[entries[first], entries[first + 1]], [entries[first + 2], entries[first + 3]]]);
    WhippleMatrices { m: matrix(0), c1: matrix(4), k0: matrix(8), k2: matrix(12) }
}
