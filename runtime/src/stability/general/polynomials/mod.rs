//! The critical speeds of two to four coordinates from polynomials with coefficients that are computed from the matrices,
//! where all that follows from them is certain.
//!
//! What eigenvalues at many speeds would tell follows from the coefficients `p_k` of the characteristic polynomial: with its even
//! part `e(y) = p_0 + p_2 y + p_4 y^2 + ...` and its odd part `s o(y)`, where y = s^2, two eigenvalues sum to zero where e and o have
//! a root in common: a negative one is that of an imaginary pair. Without damping o is zero at all speeds, and imaginary pairs
//! meet where e and its derivative have a root in common.
//!
//! 1. [`terms`]: polynomials that know what their coefficients may err by;
//! 2. [`characteristic`]: the coefficients of the characteristic polynomial;
//! 3. [`common_root`]: where two polynomials have a root in common, and which.

mod characteristic;
mod common_root;
mod terms;

use self::characteristic::{Characteristic, Coefficients, MOST, Variable, characteristic};
use self::common_root::CommonRoot;
use self::terms::Terms;
use super::crossings::{Findings, Found, add, change};
use super::equations::{Column, Equations};
use super::isolation::Bracket;
use crate::numeric::isolation::Brackets;
use crate::stability::critical::CriticalKind;

/// Of a web page, which loads the faster without them, none is found so.
const IS_THERE: bool = !cfg!(target_family = "wasm");

impl Equations {
    /// All critical speeds, in no order, where they are certain.
    pub(super) fn find_certain_crossings(&self) -> Option<Findings> {
        let is_conservative = self.is_conservative;
        if !IS_THERE || (is_conservative && self.columns.iter().any(|column| *column != Column::Both)) {
            return None;
        }
        let Characteristic { variable, is_divided, coefficients: p } = characteristic(self)?;
        // Where the highest one is zero an eigenvalue passes through infinity from one side of the axis to the other.
        if self.columns.contains(&Column::Position) && !zeros(variable, &p[self.states()])?.is_empty() {
            return None;
        }
        let mut found = Vec::new();
        for bracket in zeros(variable, &p[0])? {
            let crossing = self.find_divergence(bracket.start()).filter(|crossing| bracket.contains(crossing))?;
            let change = if is_conservative { None } else { change(crossing.growth) };
            add(&mut found, Found { kind: CriticalKind::Capsize, crossing, change });
        }
        if self.states() < 2 {
            return Some(Findings { found, samples: Vec::new(), unexamined: Vec::new() });
        }
        let common = common_root(self.states(), &p, is_conservative)?;
        for bracket in zeros(variable, &common.determinant)? {
            let v = bracket.start();
            let square = common.at(if variable == Variable::Square { v * v } else { v })?;
            if square > 0.0 {
                continue;
            }
            let omega = (-square).sqrt() * if is_divided { v } else { 1.0 };
            let found_there = if is_conservative {
                let crossing = self.find_meeting(v, omega)?;
                Found { kind: CriticalKind::DoubleRoot, crossing, change: None }
            } else {
                let crossing = self.find_flutter(v, omega)?;
                Found { kind: CriticalKind::Weave, crossing, change: change(crossing.growth) }
            };
            let is_same = (found_there.crossing.omega - omega).abs() <= CLOSE * omega;
            if !(is_same && bracket.contains(&found_there.crossing)) {
                return None;
            }
            add(&mut found, found_there);
        }
        Some(Findings { found, samples: Vec::new(), unexamined: Vec::new() })
    }
}

/// What a frequency may move by, relative to it, from that of the polynomials to all digits.
const CLOSE: f64 = 1e-3;

/// Of the even part of the characteristic polynomial with the odd one, or where that is zero with its own derivative.
fn common_root(states: usize, p: &Coefficients, is_conservative: bool) -> Option<CommonRoot> {
    let (mut even, mut odd) = ([Terms::ZERO; MOST + 1], [Terms::ZERO; MOST]);
    let degree = states / 2;
    for k in 0..=degree {
        even[k] = p[2 * k];
        if 2 * k < states {
            odd[k] = if is_conservative { p[2 * k + 2].times((k + 1) as f64) } else { p[2 * k + 1] };
        }
    }
    CommonRoot::new(degree, &even[..=degree], &odd[..states.div_ceil(2)])
}

/// The scaled speeds at which a polynomial is zero, each in its own bracket; `None` if they are not certain.
fn zeros<const R: usize>(variable: Variable, polynomial: &Terms<R>) -> Option<Vec<Bracket>> {
    match polynomial.count() {
        0..=9 => zeros_of::<R, 9>(variable, polynomial),
        10..=17 => zeros_of::<R, 17>(variable, polynomial),
        _ => zeros_of::<R, 31>(variable, polynomial),
    }
}

fn zeros_of<const R: usize, const N: usize>(variable: Variable, polynomial: &Terms<R>) -> Option<Vec<Bracket>> {
    /// The last step, relative to the zero: what is left is its cube.
    const LAST: f64 = 1e-4;
    let rounded = polynomial.rounded::<N>()?;
    let mut brackets = Brackets::new();
    rounded.isolate(&mut brackets)?;
    let speed = |x: f64| if variable == Variable::Square { x.sqrt() } else { x };
    let zero = |bracket: &crate::numeric::isolation::Bracket| {
        let zero = speed(rounded.refine(bracket, LAST)?);
        Some(Bracket { low: speed(bracket.low), high: speed(bracket.high), zero: Some(zero) })
    };
    brackets.iter().map(zero).collect()
}

#[cfg(test)]
mod tests {
    use crate::stability::critical::CriticalKind;
    use crate::stability::general::Equations;
    use crate::system::{Coefficients, Matrix, States};

    /// Entries of many digits at random.
    fn random<const N: usize>(seed: u64) -> impl FnMut(f64) -> Matrix<f64, N> {
        let mut state = seed;
        move |size| {
            Matrix::from_fn(|_, _| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                size * ((state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0)
            })
        }
    }

    /// Those of many eigenvalues, by another way to the zeros of the conditions. How many of a kind there are; `None` if they are
    /// not certain.
    fn assert_agreement<const N: usize>(coefficients: &Coefficients<f64, N>, kind: CriticalKind) -> Option<usize> {
        let equations = Equations::new(&coefficients.into(), 0.5).expect("a regular system");
        let certain = equations.find_certain_crossings()?.found;
        let by_eigenvalues = equations.find_crossings_by_eigenvalues().expect("zeros").found;
        assert_eq!(certain.len(), by_eigenvalues.len());
        for found in &certain {
            let is_same = by_eigenvalues.iter().any(|other| {
                let [v, w] = [found, other].map(|found| found.crossing.v.to_f64());
                let distance = (found.crossing.omega - other.crossing.omega).abs();
                found.kind == other.kind && (v - w).abs() <= 1e-13 * v && distance <= 1e-12 * other.crossing.omega
            });
            assert!(is_same, "{found:?} among {by_eigenvalues:?}");
        }
        Some(certain.iter().filter(|found| found.kind == kind).count())
    }

    fn symmetric<const N: usize>(matrix: Matrix<f64, N>) -> Matrix<f64, N> {
        matrix + matrix.transpose()
    }

    fn skew<const N: usize>(matrix: Matrix<f64, N>) -> Matrix<f64, N> {
        matrix - matrix.transpose()
    }

    /// What is gyroscopic, in which the highest powers of the speed cancel, without damping and with it: how many of 20 are
    /// certain, and what they have.
    fn symmetric_systems<const N: usize>() -> [(usize, usize); 2] {
        let mut found = [(0, 0); 2];
        for seed in 0..20 {
            let mut matrix = random::<N>(seed);
            let stiff = Matrix::identity() * 2.0;
            let free = Coefficients {
                m: symmetric(matrix(0.1)) + Matrix::identity(),
                c1: skew(matrix(1.5)),
                kc: symmetric(matrix(0.5)) + stiff,
                k0: symmetric(matrix(0.5)),
                k2: symmetric(matrix(0.5)) - Matrix::identity(),
                ..Default::default()
            };
            let damped = Coefficients { c0: symmetric(matrix(0.5)) + Matrix::identity() * 0.4, ..free };
            let all = [(free, CriticalKind::DoubleRoot), (damped, CriticalKind::Weave)];
            for ((certain, count), (coefficients, kind)) in found.iter_mut().zip(all) {
                if let Some(there) = assert_agreement(&coefficients, kind) {
                    (*certain, *count) = (*certain + 1, *count + there);
                }
            }
        }
        found
    }

    #[test]
    fn are_certain_of_symmetric_and_skew_matrices() {
        for found in [symmetric_systems::<3>(), symmetric_systems::<4>()] {
            assert!(found.iter().all(|&(certain, count)| certain >= 15 && count >= 5), "{found:?}");
        }
    }

    /// With and without damping at rest, and with damping that is divided by the speed.
    #[test]
    fn are_certain_of_any_matrices() {
        let (mut certain, mut count) = (0, 0);
        for seed in 0..20 {
            let mut matrix = random::<3>(100 + seed);
            let rolling = Coefficients {
                m: symmetric(matrix(0.1)) + Matrix::identity(),
                c1: matrix(0.5) + Matrix::identity(),
                kc: matrix(1.0) + Matrix::identity() * 2.0,
                k0: matrix(1.0),
                k2: matrix(0.7),
                ..Default::default()
            };
            let damped = Coefficients { c0: matrix(0.5), k1: matrix(0.5), ..rolling };
            let creeping = Coefficients { cm1: matrix(0.5) + Matrix::identity(), ..damped };
            let even = Coefficients { cm1: matrix(0.5) + Matrix::identity(), ..rolling };
            for coefficients in [rolling, damped, creeping, even] {
                if let Some(there) = assert_agreement(&coefficients, CriticalKind::Weave) {
                    (certain, count) = (certain + 1, count + there);
                }
            }
        }
        assert!(certain >= 70 && count > 40, "{certain} with {count}");
    }

    /// Of all matrices, with coordinates of which only the position or the rate is a state: how many of 20 are certain, and the
    /// speeds at which a pair crosses the axis.
    fn systems_of_orders<const N: usize>(states: [States; N]) -> (usize, usize) {
        let (mut certain, mut count) = (0, 0);
        for seed in 0..20 {
            let mut matrix = random::<N>(200 + seed);
            let has = |with: States| states.map(|states| f64::from(u8::from(states == States::Both || states == with)));
            let [positions, rates] = [States::Position, States::Rate].map(has);
            let columns = |mut matrix: Matrix<f64, N>, are_there: [f64; N]| {
                (0..N).for_each(|j| matrix.column_mut(j).iter_mut().for_each(|entry| *entry *= are_there[j]));
                matrix
            };
            let one = Matrix::identity();
            let coefficients = Coefficients {
                m: columns(symmetric(matrix(0.1)) + one, rates),
                cm1: matrix(0.2) + one * 0.3,
                c0: matrix(0.3) + one * 0.6,
                c1: matrix(0.2) + one * 0.3,
                kc: columns(matrix(1.5) + one * 2.0, positions),
                k0: columns(matrix(1.0), positions),
                k1: columns(matrix(1.0), positions),
                k2: columns(matrix(1.0), positions),
                states,
            };
            if let Some(there) = assert_agreement(&coefficients, CriticalKind::Weave) {
                (certain, count) = (certain + 1, count + there);
            }
        }
        (certain, count)
    }

    #[test]
    fn are_certain_of_coordinates_of_first_order_and_by_their_rate() {
        use States::{Both, Position, Rate};
        let found = [
            systems_of_orders([Both, Position]),
            systems_of_orders([Rate, Both]),
            systems_of_orders([Rate, Rate, Position]),
            systems_of_orders([Both, Position, Rate]),
            systems_of_orders([Both, Position, Both]),
            systems_of_orders([Rate, Both, Rate, Both]),
        ];
        assert!(found.iter().all(|&(certain, _)| certain >= 16), "{found:?}");
        assert!(found.iter().map(|(_, count)| count).sum::<usize>() >= 40, "{found:?}");
    }

    /// `(1 - v) q'` of a coordinate of first order that drives another: at 1 m/s its eigenvalue passes through infinity, from
    /// one side of the axis to the other.
    #[test]
    fn an_eigenvalue_that_passes_through_infinity_is_left_to_others() {
        let coefficients = |slope: f64| Coefficients::<f64, 2> {
            m: Matrix::<f64, 2>::new(1.0, 0.0, 0.0, 0.0),
            c0: Matrix::<f64, 2>::new(1.0, 0.0, 0.0, 1.0),
            c1: Matrix::<f64, 2>::new(0.0, 0.0, 0.0, slope),
            kc: Matrix::<f64, 2>::new(2.0, 0.5, 0.5, 1.0),
            states: [States::Both, States::Position],
            ..Default::default()
        };
        let is_certain = |slope: f64| {
            let equations = Equations::new(&(&coefficients(slope)).into(), 0.0).expect("a regular system");
            equations.find_certain_crossings().is_some()
        };
        assert!(is_certain(1.0) && !is_certain(-1.0));
    }
}
