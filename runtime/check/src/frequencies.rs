//! Eigenvalues in hertz, or in degrees by second.

use std::f64::consts::PI;

use crate::given::{Given, Reading};

/// By how much numbers in these units are larger than those in rad/s.
const UNITS: [(f64, &str); 2] = [(0.5 / PI, "Hz"), (180.0 / PI, "degrees per second")];

/// The same numbers with eigenvalues in 1/s, where all of them, or their imaginary parts alone, are in another unit; and what that is
/// called.
pub fn in_seconds(given: &Given) -> Vec<(Given, String)> {
    let has_imaginary = given.eigenvalues.iter().flat_map(|own| &own.values).any(|(_, im)| im.is_some());
    let all = UNITS.into_iter().flat_map(|unit| [(unit, false), (unit, true)]);
    let meant = all.filter(|(_, is_imaginary)| !given.eigenvalues.is_empty() && (has_imaginary || !is_imaginary));
    meant
        .map(|((factor, unit), is_imaginary)| {
            let mut own = given.clone();
            let mend = |reading: &mut Reading| {
                reading.value /= factor;
                reading.tolerance /= factor;
            };
            for (re, im) in own.eigenvalues.iter_mut().flat_map(|own| &mut own.values) {
                if !is_imaginary {
                    mend(re);
                }
                im.iter_mut().for_each(mend);
            }
            let what = if is_imaginary { "imaginary parts of eigenvalues" } else { "eigenvalues" };
            (own, format!("{what} are in {unit} in the place of 1/s"))
        })
        .collect()
}
