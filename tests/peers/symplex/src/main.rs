//! Writes `tests/src/peers/symplex/f64.rs` and `f32.rs`: Appendix A of Meijaard, Papadopoulos, Ruina & Schwab (2007),
//! as symplex-build turns it into Rust.
//!
//! `cargo run --release --manifest-path tests/peers/symplex/Cargo.toml`

#![allow(non_snake_case)] // The names are the paper's.

use std::error::Error;
use std::path::Path;

use symplex::matrix::{CodegenOptions, Matrix, Precision};
use symplex::prelude::*;
use symplex_build::CodeGen;

/// The parameters that the matrices depend on, in the order of the models of Carvallo.
const PARAMETERS: [&str; 23] = [
    "w", "c", "lam", "rR", "mR", "IRxx", "IRyy", "xB", "zB", "mB", "IBxx", "IBzz", "IBxz", "xH", "zH", "mH", "IHxx",
    "IHzz", "IHxz", "rF", "mF", "IFxx", "IFyy",
];

fn main() -> Result<(), Box<dyn Error>> {
    let context = Context::new();
    let parameters = PARAMETERS.map(|name| context.symbol(name));
    let matrices = matrices(&context, &parameters)?;
    let with_derivatives = with_derivatives(&matrices, &parameters)?;
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../src/peers/symplex");
    for (precision, file) in [(Precision::F64, "f64.rs"), (Precision::F32, "f32.rs")] {
        // What is fastest in a portable build: `mul_add`, the default, is a call of a function there.
        let options = CodegenOptions { precision, inline: true, use_mul_add: false, ..CodegenOptions::default() };
        CodeGen::new()
            .options(options)
            .add_matrix_fn("matrices", &matrices, &PARAMETERS)
            .add_matrix_fn("matrices_and_derivatives", &with_derivatives, &PARAMETERS)
            .write_to_path(folder.join(file))?;
    }
    Ok(())
}

/// M, C1, K0 and K2 below each other.
fn matrices(context: &Context, parameters: &[Ex; 23]) -> Result<Matrix, Box<dyn Error>> {
    let [w, c, lam, rR, mR, IRxx, IRyy, xB, zB, mB, IBxx, IBzz, IBxz, xH, zH, mH, IHxx, IHzz, IHxz, rF, mF, IFxx, IFyy] =
        parameters;
    let (IRzz, IFzz) = (IRxx, IFxx);
    let zero = context.int(0);
    let two = &context.int(2);
    let (sin, cos) = &(lam.sin(), lam.cos());

    let mT = &(mR + mB + mH + mF);
    let xT = &((xB * mB + xH * mH + w * mF) / mT);
    let zT = &((-rR * mR + zB * mB + zH * mH - rF * mF) / mT);
    let ITxx = &(IRxx + IBxx + IHxx + IFxx + mR * rR.powi(2) + mB * zB.powi(2) + mH * zH.powi(2) + mF * rF.powi(2));
    let ITxz = &(IBxz + IHxz - mB * xB * zB - mH * xH * zH + mF * w * rF);
    let ITzz = &(IRzz + IBzz + IHzz + IFzz + mB * xB.powi(2) + mH * xH.powi(2) + mF * w.powi(2));

    let mA = &(mH + mF);
    let xA = &((xH * mH + w * mF) / mA);
    let zA = &((zH * mH - rF * mF) / mA);
    let IAxx = &(IHxx + IFxx + mH * (zH - zA).powi(2) + mF * (rF + zA).powi(2));
    let IAxz = &(IHxz - mH * (xH - xA) * (zH - zA) + mF * (w - xA) * (rF + zA));
    let IAzz = &(IHzz + IFzz + mH * (xH - xA).powi(2) + mF * (w - xA).powi(2));
    let uA = &((xA - w - c) * cos - zA * sin);
    let IAll = &(mA * uA.powi(2) + IAxx * sin.powi(2) + two * IAxz * sin * cos + IAzz * cos.powi(2));
    let IAlx = &(-mA * uA * zA + IAxx * sin + IAxz * cos);
    let IAlz = &(mA * uA * xA + IAxz * sin + IAzz * cos);

    let mu = &(c / w * cos);
    let SR = &(IRyy / rR);
    let SF = &(IFyy / rF);
    let ST = &(SR + SF);
    let SA = &(mA * uA + mu * mT * xT);

    let M12 = IAlx + mu * ITxz;
    let C21 = &(mu * ST + SF * cos);
    Ok(Matrix::new(vec![
        vec![ITxx.clone(), M12.clone()],
        vec![M12, IAll + two * mu * IAlz + mu.powi(2) * ITzz],
        vec![zero.clone(), C21 + ITxz / w * cos - mu * mT * zT],
        vec![-C21, IAlz / w * cos + mu * (SA + ITzz / w * cos)],
        vec![mT * zT, -SA],
        vec![-SA, -SA * sin],
        vec![zero.clone(), (ST - mT * zT) / w * cos],
        vec![zero, (SA + SF * sin) / w * cos],
    ])?)
}

/// The entries of the matrices, and for each parameter the derivatives with respect to it that are not zero.
fn with_derivatives(matrices: &Matrix, parameters: &[Ex]) -> Result<Matrix, Box<dyn Error>> {
    let derivatives = parameters.iter().flat_map(|parameter| matrices.iter().map(|entry| entry.diff(parameter)));
    let not_zero = derivatives.filter(|derivative| derivative.is_zero() != Some(true));
    Ok(Matrix::new(vec![matrices.iter().cloned().chain(not_zero).collect()])?)
}
