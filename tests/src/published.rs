//! Results as printed, digit by digit.

use nalgebra::Complex;

/// A published benchmark: each entry of its matrices as printed.
pub struct Benchmark {
    /// The name of the bicycle.
    pub bicycle: &'static str,
    /// The rows of M, C1, K0 and K2.
    pub matrices: [[[&'static str; 2]; 2]; 4],
    /// What K0 is multiplied by in print: 1, or g.
    pub gravity: f64,
    /// How far the printed digits are from the exact values at most, in units of the last digit.
    pub units: f64,
}

/// Meijaard, Papadopoulos, Ruina & Schwab 2007, section 6 (K0 without g).
pub const BENCHMARK_2007: Benchmark = Benchmark {
    bicycle: "benchmark",
    matrices: [
        [["80.81722", "2.31941332208709"], ["2.31941332208709", "0.29784188199686"]],
        [["0", "33.86641391492494"], ["-0.85035641456978", "1.68540397397560"]],
        [["-80.95", "-2.59951685249872"], ["-2.59951685249872", "-0.80329488458618"]],
        [["0", "76.59734589573222"], ["0", "2.65431523794604"]],
    ],
    gravity: 1.0,
    units: 0.5,
};

/// Schwab, Meijaard & Papadopoulos 2005, ENOC (K0 with g in it).
///
/// Two last digits are not the nearest: exactly, C1 has 1.70696539792387543 and K2 has 76.406208759656577.
pub const BENCHMARK_2005: Benchmark = Benchmark {
    bicycle: "benchmark-2005",
    matrices: [
        [["80.8121", "2.32343142623549"], ["2.32343142623549", "0.30126570934256"]],
        [["0", "33.77386947593010"], ["-0.84823447825693", "1.70696539792387"]],
        [["-794.1195", "-25.739089291258"], ["-25.739089291258", "-8.139414705882"]],
        [["0", "76.40620875965657"], ["0", "2.67560553633218"]],
    ],
    gravity: 9.81,
    units: 0.8,
};

/// Meijaard et al. 2007, Table 2 (b, c): speed, then real and imaginary part of the weave mode, capsize, castering.
///
/// At rest, where nothing weaves, the first two are the two real eigenvalues above zero.
pub const EIGENVALUES_2007: [(f64, [f64; 4]); 11] = [
    (0.0, [3.13164324790656, 5.53094371765393, -3.13164324790656, -5.53094371765393]),
    (1.0, [3.52696170990070, 0.80774027519930, -3.13423125066578, -7.11008014637442]),
    (2.0, [2.68234517512745, 1.68066296590675, -3.07158645641514, -8.67387984831735]),
    (3.0, [1.70675605663975, 2.31582447384325, -2.63366137253667, -10.3510146724592]),
    (4.0, [0.41325331521125, 3.07910818603206, -1.42944427361326, -12.15861426576447]),
    (5.0, [-0.77534188219585, 4.46486771378823, -0.32286642900409, -14.07838969279822]),
    (6.0, [-1.52644486584142, 5.87673060598709, -0.00406690076970, -16.08537123098026]),
    (7.0, [-2.13875644258362, 7.19525913329805, 0.10268170574766, -18.15788466125262]),
    (8.0, [-2.69348683581097, 8.46037971396931, 0.14327879765713, -20.27940894394569]),
    (9.0, [-3.21675402252485, 9.69377351531791, 0.15790184030917, -22.43788559040858]),
    (10.0, [-3.72016840437287, 10.90681139476287, 0.16105338653172, -24.62459635017404]),
];

/// Meijaard et al. 2007, Table 2 (a): the speeds of the double root, of weave and of capsize.
pub const CRITICAL_SPEEDS_2007: [f64; 3] = [0.68428307889246, 4.29238253634111, 6.02426201538837];

/// A foot in m.
pub const FOOT: f64 = 0.3048;

/// R. S. Sharp 1971, The stability and control of motorcycles, J. Mech. Eng. Sci. 13, for the standard motorcycle: speed in ft/s,
/// then real and imaginary parts of capsize, weave and wobble in 1/s.
pub const EIGENVALUES_1971: [(f64, [[f64; 2]; 3]); 8] = [
    (10.0, [[-3.56, 0.0], [2.01, 1.63], [-5.20, 55.7]]),
    (20.0, [[-2.83, 0.0], [-0.18, 2.09], [-5.91, 55.8]]),
    (30.0, [[-0.13, 0.0], [-3.36, 4.56], [-6.42, 55.5]]),
    (50.0, [[0.08, 0.0], [-6.59, 11.4], [-6.52, 54.6]]),
    (70.0, [[0.08, 0.0], [-3.97, 16.8], [-5.70, 54.0]]),
    (100.0, [[0.07, 0.0], [-1.82, 19.2], [-3.94, 54.3]]),
    (130.0, [[0.05, 0.0], [-1.13, 20.4], [-2.24, 55.6]]),
    (160.0, [[0.04, 0.0], [-0.96, 21.2], [-0.82, 57.5]]),
];

/// How far the nearest of some eigenvalues is from one that Sharp prints, in units of the last digit: the second behind the
/// point, or the third in all.
///
/// # Panics
/// If there are no eigenvalues.
pub fn units_off(found: &[Complex<f64>], [re, im]: [f64; 2]) -> f64 {
    let printed = Complex::new(re, im);
    let nearest = found.iter().min_by(|a, b| (*a - printed).norm().total_cmp(&(*b - printed).norm()));
    let nearest = nearest.expect("an eigenvalue");
    let unit = |printed: f64| if printed.abs() < 10.0 { 0.01 } else { 0.1 };
    let off = |found: f64, printed: f64| (found - printed).abs() / unit(printed);
    off(nearest.re, re).max(off(nearest.im, im))
}
