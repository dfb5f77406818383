//! Faults that are planted in functions by hand, in models of one, two and three coordinates.

use carvallo::{Coefficients, Model, Number, Rows};
use carvallo_compare::{Comparison, Report, SideReport};
use carvallo_models::{DoublePendulum, DoublePendulumMatrices, Pendulum, ThreePipes, Whipple, WhippleMatrices};

fn report<M, const N: usize, O>(by_hand: impl Fn(&M) -> O + Copy + 'static) -> Report
where
    M: Model<N, Scalar = f64> + 'static,
    O: Into<Coefficients<f64, N>> + 'static,
{
    let comparison = Comparison::<M, N>::of(M::coefficients).against("by hand", by_hand).random_designs(20);
    comparison.report().unwrap_or_else(|error| panic!("{error}"))
}

fn by_hand(report: &Report) -> &SideReport {
    assert_eq!(report.sides[0].double.differences, [], "generated code is right");
    &report.sides[1]
}

/// The first cause of each explanation, with what it explains.
fn causes(report: &Report) -> Vec<(String, &str)> {
    let side = by_hand(report);
    assert_eq!(side.unexplained, [""; 0], "{report}");
    side.explanations.iter().map(|found| (found.entries.join(" "), found.causes[0].as_str())).collect()
}

#[track_caller]
fn check<M, const N: usize, O>(by_hand: impl Fn(&M) -> O + Copy + 'static, expected: &[(&str, &str)])
where
    M: Model<N, Scalar = f64> + 'static,
    O: Into<Coefficients<f64, N>> + 'static,
{
    let report = report(by_hand);
    let found = causes(&report);
    let found: Vec<(&str, &str)> = found.iter().map(|(entries, cause)| (entries.as_str(), *cause)).collect();
    assert_eq!(found, expected, "\n{report}");
}

/// Of one coordinate: m l^2 with a fault.
fn pendulum(
    mass: impl Fn(&Pendulum) -> f64 + Copy + 'static,
) -> impl Fn(&Pendulum) -> Coefficients<f64, 1> + Copy + 'static {
    move |p| {
        let mut all = p.coefficients();
        all.m[(0, 0)] = mass(p);
        all
    }
}

#[test]
fn of_one_coordinate() {
    check(pendulum(|p| -p.m * p.l * p.l), &[("M_11", "M has the opposite sign")]);
    check(pendulum(|p| 2.0 * p.m * p.l * p.l), &[("M_11", "M is twice as large")]);
    check(pendulum(|p| p.m * p.l * p.l / 2.0), &[("M_11", "M is half as large")]);
    check(pendulum(|p| p.m * p.l), &[("M_11", "M is divided by `l`")]);
    check(pendulum(|p| p.m * p.l * p.l * p.g), &[("M_11", "M has `g` as a factor too many")]);
    check(pendulum(|p| p.l * p.m * p.m), &[("M_11", "the parameters `m` and `l` are swapped")]);
    check(pendulum(|p| p.m * p.l * 2.0), &[("M_11", "\"m*l^2\" in M_11 is \"m*l*2\"")]);
    check(pendulum(|_| 0.0), &[("M_11", "M is zero")]);
    check(pendulum(|p| 1.000_002_3 * p.m * p.l * p.l), &[("M_11", "M_11 is 1.0000023 times as large")]);
}

/// Gravity inside of K0, as Kc.
#[test]
fn gravity_that_is_written_into_a_matrix() {
    let weighty = |p: &Pendulum| {
        let mut all = p.coefficients();
        (all.kc, all.k0) = (all.k0 * p.g, all.kc);
        all
    };
    check(weighty, &[("Kc_11 K0_11", "what belongs into K0 stands in Kc, with `g` in it")]);
}

#[test]
fn of_two_coordinates_a_matrix() {
    let transposed = |p: &Whipple| WhippleMatrices { c1: transpose(p.matrices().c1), ..p.matrices() };
    check(transposed, &[("C1_12 C1_21", "C1 is transposed")]);
    let negative = |p: &Whipple| {
        let mut all = p.coefficients();
        all.k0 = -all.k0;
        all
    };
    check(negative, &[("K0_11 K0_12 K0_21 K0_22", "K0 has the opposite sign")]);
    let exchanged = |p: &Whipple| {
        let mut all = p.coefficients();
        (all.c1, all.k2) = (all.k2, all.c1);
        all
    };
    let entries = "C1_12 C1_21 C1_22 K2_12 K2_21 K2_22";
    check(exchanged, &[(entries, "C1 and K2 are exchanged")]);
    // K2 filled row by column has its second column in its second row.
    let by_columns = |p: &Whipple| WhippleMatrices { k2: transpose(p.matrices().k2), ..p.matrices() };
    check(by_columns, &[("K2_12 K2_21", "K2 is transposed")]);
}

fn transpose(Rows([[a, b], [c, d]]): Rows<f64, 2>) -> Rows<f64, 2> {
    Rows([[a, c], [b, d]])
}

#[test]
fn of_two_coordinates_all_matrices() {
    let every = |change: fn(nalgebra::Matrix2<f64>) -> nalgebra::Matrix2<f64>| {
        move |p: &Whipple| {
            let mut all = p.coefficients();
            for name in carvallo::MatrixName::ALL {
                let matrix = all.matrix_mut(name);
                *matrix = change(*matrix);
            }
            all
        }
    };
    let flip = |m: nalgebra::Matrix2<f64>| nalgebra::Matrix2::new(m.m11, -m.m12, -m.m21, m.m22);
    let first = |report: &Report| by_hand(report).explanations[0].causes.clone();
    let found = first(&report(every(flip)));
    // Which of two coordinates it is makes no difference.
    assert_eq!(found[0], "`phi` is counted in the other sense");
    assert!(found.contains(&"`delta` is counted in the other sense".to_owned()), "{found:?}");
    let swap = |m: nalgebra::Matrix2<f64>| nalgebra::Matrix2::new(m.m22, m.m21, m.m12, m.m11);
    assert_eq!(first(&report(every(swap)))[0], "the coordinates `phi` and `delta` are exchanged");
    let rows = |m: nalgebra::Matrix2<f64>| nalgebra::Matrix2::new(m.m21, m.m22, m.m11, m.m12);
    assert_eq!(first(&report(every(rows)))[0], "the equations of `phi` and `delta` are exchanged");
    let equation = |m: nalgebra::Matrix2<f64>| nalgebra::Matrix2::new(m.m11, m.m12, -m.m21, -m.m22);
    assert_eq!(first(&report(every(equation)))[0], "the equation of `delta` has the opposite sign");
}

#[test]
fn of_two_coordinates_parameters() {
    let swapped = |p: &Whipple| Whipple { xH: p.zH, zH: p.xH, ..*p }.matrices();
    let found = report(swapped);
    let [explanation] = &by_hand(&found).explanations[..] else { panic!("{found}") };
    assert_eq!(explanation.causes, ["the parameters `xH` and `zH` are swapped"]);
    let radii = |p: &Whipple| Whipple { rR: p.rF, rF: p.rR, ..*p }.matrices();
    assert_eq!(by_hand(&report(radii)).explanations[0].causes, ["the parameters `rR` and `rF` are swapped"]);
    let degrees = |p: &Whipple| Whipple { lam: p.lam.to_degrees(), ..*p }.matrices();
    assert_eq!(by_hand(&report(degrees)).explanations[0].causes, ["`lam` is turned into degrees"]);
    let trail = |p: &Whipple| Whipple { c: p.c / 2.0, ..*p }.matrices();
    assert_eq!(by_hand(&report(trail)).explanations[0].causes, ["`c` is taken half"]);
    let sign = |p: &Whipple| Whipple { zB: -p.zB, ..*p }.matrices();
    assert_eq!(by_hand(&report(sign)).explanations[0].causes, ["`zB` has the opposite sign"]);
    let twice = |p: &Whipple| Whipple { mF: p.mR, ..*p }.matrices();
    assert_eq!(by_hand(&report(twice)).explanations[0].causes, ["`mR` stands for `mF`"]);
}

/// The double pendulum by hand: `s` is what multiplies one term of the mass matrix, which is 2, and `k` another.
fn chain<T: Number>(p: &DoublePendulum<T>, s: f64, k: f64) -> DoublePendulumMatrices<T> {
    let DoublePendulum { l1, a1, a2, m1, m2, I1, I2, .. } = *p;
    let lower = I2 + m2 * a2 * a2;
    let coupled = m2 * l1 * a2;
    let upper = I1 + m1 * a1 * a1 + m2 * l1 * l1;
    let (m12, weight) = (lower + coupled, m2 * a2);
    let m11 = upper + lower + coupled.like(s) * coupled;
    let upper_weight = -(m1 * a1) - m2 * l1 - weight.like(k) * weight;
    DoublePendulumMatrices {
        m: Rows([[m11, m12], [m12, lower]]),
        k0: Rows([[upper_weight, -weight], [-weight, -weight]]),
    }
}

#[test]
fn of_two_coordinates_a_term() {
    check(|p: &DoublePendulum| chain(p, 2.0, 1.0), &[]);
    let missing = report(|p: &DoublePendulum| chain(p, 2.0, 0.0));
    let side = by_hand(&missing);
    assert_eq!(side.explanations[0].entries, ["K0_11"]);
    assert_eq!(side.explanations[0].causes[0], "Sz_theta1 is without \"Sz_theta2\"", "{missing}");
    let sign = report(|p: &DoublePendulum| chain(p, 2.0, -1.0));
    let cause = &by_hand(&sign).explanations[0].causes[0];
    assert_eq!(cause, "\"Sz_theta2\" in Sz_theta1 is \"-Sz_theta2\"", "{sign}");
}

#[test]
fn of_three_coordinates() {
    let transposed = |p: &ThreePipes| {
        let mut all = p.coefficients();
        all.c1 = all.c1.transpose();
        all
    };
    let entries = "C1_12 C1_13 C1_21 C1_23 C1_31 C1_32";
    check(transposed, &[(entries, "C1 is transposed")]);
    let sign = |p: &ThreePipes| {
        let mut all = p.coefficients();
        all.kc[(1, 2)] = -all.kc[(1, 2)];
        all
    };
    check(sign, &[("Kc_23", "Kc_23 has the opposite sign")]);
    let swapped = |p: &ThreePipes| ThreePipes { m: p.f, f: p.m, ..*p }.matrices();
    let found = report(swapped);
    assert_eq!(by_hand(&found).explanations[0].causes[0], "the parameters `m` and `f` are swapped", "{found}");
    let factor = |p: &ThreePipes| {
        let mut all = p.coefficients();
        all.m[(2, 2)] *= 0.5;
        all
    };
    check(factor, &[("M_33", "M_33 is half as large")]);
    let neighbours = |p: &ThreePipes| {
        let mut all = p.coefficients();
        all.c0.swap((0, 0), (0, 1));
        all
    };
    check(neighbours, &[("C0_11 C0_12", "C0_11 and C0_12 are exchanged")]);
}

/// Two faults in different places are two explanations.
#[test]
fn two_faults() {
    let two = |p: &ThreePipes| {
        let mut all = p.coefficients();
        all.k0[(1, 1)] *= 2.0;
        all.c1 = all.c1.transpose();
        all
    };
    let entries = "C1_12 C1_13 C1_21 C1_23 C1_31 C1_32";
    check(two, &[(entries, "C1 is transposed"), ("K0_22", "K0_22 is twice as large")]);
}

#[test]
fn what_nothing_explains_is_said() {
    let found = report(pendulum(|p| p.m * (p.l + 0.37 * p.c)));
    let side = by_hand(&found);
    assert_eq!((&side.explanations[..], &side.unexplained[..]), (&[][..], &["M_11".to_owned()][..]));
    assert!(found.to_string().contains("no slip explains M_11"), "{found}");
    // What is no number is farthest off.
    let found = report(pendulum(|_| f64::NAN));
    assert_eq!(by_hand(&found).double.ulps, f64::INFINITY);
}

/// A function in `f32` that is another one than in `f64`: it alone is transposed.
#[test]
fn what_differs_in_single_precision_alone_is_explained() {
    let comparison = Comparison::<Whipple, 2>::of(Whipple::matrices)
        .single(|p: &Whipple<f32>| p.matrices())
        .against("by hand", Whipple::matrices)
        .single(|p: &Whipple<f32>| {
            let all = p.matrices();
            let Rows([[a, b], [c, d]]) = all.c1;
            WhippleMatrices { c1: Rows([[a, c], [b, d]]), ..all }
        });
    let report = comparison.random_designs(20).report().expect("designs");
    let side = &report.sides[1];
    assert_eq!((&side.double.differences[..], &side.explanations[..]), (&[][..], &[][..]));
    let [found] = &side.explanations_in_single[..] else { panic!("{report}") };
    assert_eq!((&found.entries.join(" "), found.causes[0].as_str()), (&"C1_12 C1_21".to_owned(), "C1 is transposed"));
    assert!(report.to_string().contains("\n`by hand` differs in f32 in 2 entries; where each"), "{report}");
    assert_eq!(report.broken(carvallo_compare::Limits::default()), ["`by hand` differs in f32 in C1_12, C1_21"]);
}

/// A slip in `f32` alone: what it rounds to tells the term.
#[test]
fn a_slip_in_single_precision_alone_is_named() {
    let by_hand = |p: &Pendulum<f32>| {
        let mut all = p.coefficients();
        all.m[(0, 0)] = p.m * p.l * 2.0;
        all
    };
    let comparison = Comparison::<Pendulum, 1>::of(Pendulum::coefficients).single(Pendulum::<f32>::coefficients);
    let comparison = comparison.against("by hand", Pendulum::coefficients).single(by_hand).random_designs(20);
    let report = comparison.report().expect("designs");
    let causes = &report.sides[1].explanations_in_single[0].causes;
    assert_eq!(causes[0], "\"m*l^2\" in M_11 is \"m*l*2\"", "{report}");
}

/// Two slips in the formula of one entry, in different terms: the sign of one, and the square of mu in the other.
#[test]
#[allow(non_snake_case)]
fn two_slips_in_one_entry() {
    let by_two = |p: &Whipple| {
        let mut all = p.coefficients();
        let mu = p.c / p.w * p.lam.cos();
        // What M_22 = IAll + 2*mu*IAlz + mu^2*ITzz has of the term with IAlz is what is left beside the others.
        let ITzz = p.IRxx + p.IBzz + p.IHzz + p.IFxx + p.mB * p.xB * p.xB + p.mH * p.xH * p.xH + p.mF * p.w * p.w;
        let mA = p.mH + p.mF;
        let xA = (p.xH * p.mH + p.w * p.mF) / mA;
        let zA = (p.zH * p.mH - p.rF * p.mF) / mA;
        let uA = (xA - p.w - p.c) * p.lam.cos() - zA * p.lam.sin();
        let [x, z] = [p.xH - xA, p.zH - zA];
        let [front_x, front_z] = [p.w - xA, p.rF + zA];
        let IAxz = p.IHxz - p.mH * x * z + p.mF * front_x * front_z;
        let IAzz = p.IHzz + p.IFxx + p.mH * x * x + p.mF * front_x * front_x;
        let IAlz = mA * uA * xA + IAxz * p.lam.sin() + IAzz * p.lam.cos();
        all.m[(1, 1)] += -4.0 * mu * IAlz + (mu - mu * mu) * ITzz;
        all
    };
    let found = report(by_two);
    let [explanation] = &by_hand(&found).explanations[..] else { panic!("{found}") };
    assert_eq!(explanation.entries, ["M_22"]);
    let expected = "\"+ 2*mu*IAlz + mu^2*ITzz\" in M_22 is \"- 2*mu*IAlz + mu*ITzz\"";
    assert!(explanation.causes.iter().any(|cause| cause == expected), "{found}");
}
